// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/hierarchy/statistics_json.h"

#include <CLI/CLI.hpp>

namespace ameco::cli {
namespace {

/// What came of a conversion.
struct Conversion {
    std::string format;              ///< of the input
    std::string what;                ///< "67,866 nodes, 387,024 tets"
    std::vector<std::string> losses; ///< what the output's format cannot carry
};

class ConvertCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {
            "convert",
            "Write a mesh or a metric in another format.",
            "convert IN OUT [options]",
            {{"convert wing.meshb wing.mesh", "from binary to text"},
             {"convert wing.sol wing.solb", "a metric, from text to binary"},
             {"convert wing.meshb wing4.meshb --format-version 4", "Medit with 64-bit numbers"}},
            "The content stays as it is in the file: nothing is turned, added or dropped, and\n"
            "records ameco does not know are carried along. What the new format cannot hold\n"
            "is said on stderr. The input is recognised by its content, the output by its "
            "suffix."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("IN", input_, "mesh or metric (.mesh, .meshb, .sol, .solb)")->required();
        app.add_option("OUT", output_, "file to write (.mesh, .meshb; .sol, .solb for a metric)")
            ->required();
        app.add_option("--format-version", version_,
                       "version of the Medit format, 1 to 4 [the input's]")
            ->type_name("N")
            ->check(whole_number(1, 4));
    }

    ExitCode run(Session& session) override {
        refuse_overwriting(input_, output_);
        const Conversion conversion =
            is_metric_name(input_) ? convert_metric(session) : convert_mesh(session);
        session.monitor.clear_line();
        for (const std::string& loss : conversion.losses) {
            session.monitor.message(Severity::warning, output_ + ": " + loss);
        }
        if (session.json) {
            session.out << Json{{"input", input_},
                                {"input_format", conversion.format},
                                {"output", output_},
                                {"not_carried", conversion.losses}}
                               .dump(2)
                        << '\n';
        } else if (session.verbosity >= 0) {
            session.out << output_ << ": " << conversion.what << " from " << input_ << " ("
                        << conversion.format << ")\n";
        }
        return ExitCode::ok;
    }

private:
    Conversion convert_mesh(Session& session) const {
        require_suffix(output_, {".meshb", ".mesh"});
        const MeshFile file = load_mesh(input_, session);
        session.monitor.progress(0.5, "writing " + output_);
        WriteOptions options;
        options.version = version_ > 0 ? version_ : file.format_version;
        options.carried = &file.carried;
        Conversion result;
        result.format = file.format;
        std::visit(
            [&](const auto& mesh) {
                result.losses = write_mesh(output_, mesh, options);
                result.what = count_text(static_cast<std::int64_t>(mesh.points.size())) +
                              " nodes, " +
                              count_text(static_cast<std::int64_t>(mesh.elements.size())) + " " +
                              element_word(std::decay_t<decltype(mesh)>::dimension);
            },
            file.mesh);
        return result;
    }

    Conversion convert_metric(Session& session) const {
        require_suffix(output_, {".solb", ".sol"});
        session.monitor.progress(0, "reading " + input_);
        const TensorFile file = read_tensors(input_); // as they stand: no digit is lost
        for (const std::string& note : file.notes) {
            session.monitor.message(Severity::info, input_ + ": " + note);
        }
        Conversion result;
        result.format = file.format;
        if (const auto* solid = std::get_if<IdVector<NodeId, Tensor<3>>>(&file.tensors)) {
            result.what = write_tensors_of<3>(*solid, file.format_version);
        } else {
            result.what = write_tensors_of<2>(std::get<IdVector<NodeId, Tensor<2>>>(file.tensors),
                                              file.format_version);
        }
        return result;
    }

    template <int D>
    std::string write_tensors_of(const IdVector<NodeId, Tensor<D>>& tensors,
                                 int input_version) const {
        WriteOptions options;
        options.version = version_ > 0 ? version_ : input_version;
        write_tensors<D>(output_, tensors, options);
        return count_text(static_cast<std::int64_t>(tensors.size())) + " tensors";
    }

    std::string input_;
    std::string output_;
    int version_ = 0;
};

} // namespace

std::unique_ptr<Command> make_convert_command() {
    return std::make_unique<ConvertCommand>();
}

} // namespace ameco::cli
