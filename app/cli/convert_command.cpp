// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/hierarchy/statistics_json.h"
#include "core/io/format.h"

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
            {{"convert wing.su2 wing.meshb", "what a solver has, for ameco"},
             {"convert level_2.meshb level_2.lb8.ugrid", "a level, for a solver"},
             {"convert wing.meshb wing.msh --to gmsh22-text", "a format among those of a suffix"},
             {"convert wing.sol wing.solb", "a metric, from text to binary"},
             {"convert wing.meshb wing.mtc --metric wing.solb", "both, as MTC wants them"}},
            "ameco formats lists the formats. The input is recognised by its content, the output "
            "by its suffix. The content stays as it is in the file: nothing is turned, added or "
            "dropped, and records ameco does not know are carried along; but prisms, pyramids, "
            "hexahedra and quadrilaterals are split. What was split, and what the new format "
            "cannot hold, is said on stderr."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("IN", input_, "mesh or metric to read")->required();
        app.add_option("OUT", output_, "file to write")->required();
        app.add_option("--to", format_, "format to write [that of OUT's suffix]; see ameco formats")
            ->type_name("NAME")
            ->check(one_of(names_of_formats()));
        app.add_option("--metric", metric_,
                       "metric to write beside an MTC meta-file, which names it")
            ->type_name("METRIC");
        app.add_option("--format-version", version_,
                       "version of the Medit format, 1 to 4 [the input's]")
            ->type_name("N")
            ->check(whole_number(1, 4));
    }

    ExitCode run(Session& session) override {
        refuse_overwriting(input_, output_);
        const Conversion conversion =
            wants_metric() ? convert_metric(session) : convert_mesh(session);
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
    [[nodiscard]] static std::vector<std::string> names_of_formats() {
        std::vector<std::string> names;
        for (const Format& format : formats()) {
            if (format.writes()) {
                names.emplace_back(format.name);
            }
        }
        return names;
    }

    /// A meta-file of MTC names both a mesh and a metric: the output decides.
    [[nodiscard]] bool wants_metric() const {
        return is_metric_name(input_) || is_metric_name(output_);
    }

    Conversion convert_mesh(Session& session) const {
        WriteOptions options;
        options.format = format_;
        const Format& format = format_to_write(output_, options, false);
        if (!metric_.empty() && format.name != "mtc") {
            throw UsageError("--metric: only an MTC meta-file (.mtc) names a metric");
        }
        const MeshFile file = load_mesh(input_, session, {.surfaces = true});
        session.monitor.progress(0.5, "writing " + output_);
        options.version = version_ > 0 ? version_ : file.format_version;
        options.carried = &file.carried;
        options.metric = write_metric_beside(session);
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

    /// Writes the metric of `--metric` in MTC's format; returns its name, or nothing.
    [[nodiscard]] std::filesystem::path write_metric_beside(Session& session) const {
        if (metric_.empty()) {
            return {};
        }
        const TensorFile file = read_tensors(metric_);
        const std::filesystem::path path =
            std::filesystem::path(output_).replace_extension(".metrique");
        if (const auto* solid = std::get_if<IdVector<NodeId, Tensor<3>>>(&file.tensors)) {
            write_tensors<3>(path, *solid);
        } else {
            write_tensors<2>(path, std::get<IdVector<NodeId, Tensor<2>>>(file.tensors));
        }
        session.monitor.message(Severity::info, path.string() + ": metric from " + metric_);
        return path.filename();
    }

    Conversion convert_metric(Session& session) const {
        WriteOptions options;
        options.format = format_;
        static_cast<void>(format_to_write(output_, options, true));
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
        options.format = format_;
        options.version = version_ > 0 ? version_ : input_version;
        write_tensors<D>(output_, tensors, options);
        return count_text(static_cast<std::int64_t>(tensors.size())) + " tensors";
    }

    std::string input_;
    std::string output_;
    std::string format_;
    std::string metric_;
    int version_ = 0;
};

} // namespace

std::unique_ptr<Command> make_convert_command() {
    return std::make_unique<ConvertCommand>();
}

} // namespace ameco::cli
