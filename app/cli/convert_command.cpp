// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/hierarchy/hierarchy_folder.h"
#include "core/hierarchy/statistics_json.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/format.h"
#include "core/io/mapbc.h"
#include "core/io/text_file.h"

#include <CLI/CLI.hpp>

#include <optional>

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
             {"convert levels su2 --to su2", "all levels of a hierarchy, into the folder su2"},
             {"convert wing.sol wing.solb", "a metric, from text to binary"},
             {"convert wing.meshb wing.mtc --metric wing.solb", "both, as MTC wants them"}},
            "ameco formats lists the formats. The input is recognised by its content, the output "
            "by its suffix. The content stays as it is in the file: nothing is turned, added or "
            "dropped, and records ameco does not know are carried along; but prisms, pyramids, "
            "hexahedra and quadrilaterals are split. What was split, and what the new format "
            "cannot hold, is said on stderr."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("IN", input_, "mesh or metric to read, or the folder of a hierarchy")
            ->required();
        app.add_option("OUT", output_, "file to write, or folder for the levels")->required();
        app.add_option("--to", format_, "format to write [that of OUT's suffix]; see ameco formats")
            ->type_name("NAME")
            ->check(one_of(names_of_formats()));
        app.add_option("--metric", metric_,
                       "metric to write beside an MTC meta-file, which names it, or into a .vtu")
            ->type_name("METRIC");
        app.add_option("--names", names_, "names of the patches (.mapbc)")->type_name("FILE");
        app.add_option("--format-version", version_,
                       "version of the Medit format, 1 to 4 [the input's]")
            ->type_name("N")
            ->check(whole_number(1, 4));
    }

    ExitCode run(Session& session) override {
        refuse_overwriting(input_, output_);
        if (std::filesystem::is_directory(input_)) {
            convert_hierarchy(session);
            return ExitCode::ok;
        }
        const Conversion conversion =
            wants_metric() ? convert_metric(session) : convert_mesh(input_, output_, session);
        Json json = show(conversion, input_, output_, session);
        if (session.json) {
            session.out << json.dump(2) << '\n';
        }
        return ExitCode::ok;
    }

private:
    /// Tells people what was done; what programs are told is returned.
    static Json show(const Conversion& conversion, const std::string& input,
                     const std::string& output, Session& session) {
        session.monitor.clear_line();
        for (const std::string& loss : conversion.losses) {
            session.monitor.message(Severity::warning, output + ": " + loss);
        }
        if (!session.json && session.verbosity >= 0) {
            session.out << output << ": " << conversion.what << " from " << input << " ("
                        << conversion.format << ")\n";
        }
        return {{"input", input},
                {"input_format", conversion.format},
                {"output", output},
                {"not_carried", conversion.losses}};
    }

    /// All levels of a hierarchy, as files of the same names with another suffix.
    void convert_hierarchy(Session& session) const {
        if (format_.empty()) {
            throw UsageError(input_ + ": is a folder: say with --to in which format its levels "
                                      "are wanted");
        }
        namespace fs = std::filesystem;
        const fs::path out(output_);
        const Format& format = format_to_write(out, {.format = format_}, false);
        const std::string suffix(format.suffixes.front());
        const Hierarchy hierarchy = read_hierarchy(input_);
        create_folder(out);
        Json list = Json::array();
        std::vector<std::string> names;
        for (std::size_t k = 0; k < hierarchy.levels.size(); ++k) {
            const std::string from = (fs::path(input_) / hierarchy.levels[k].mesh.name).string();
            names.push_back("level_" + std::to_string(k) + suffix);
            const std::string to = (out / names.back()).string();
            refuse_overwriting(from, to);
            list.push_back(show(convert_mesh(from, to, session), from, to, session));
        }
        if (format.name == "vtu") {
            write_collection(out / "hierarchy.pvd", names);
        }
        if (session.json) {
            session.out << list.dump(2) << '\n';
        }
    }

    /// The levels as the steps of a ParaView collection.
    static void write_collection(const std::filesystem::path& path,
                                 const std::vector<std::string>& names) {
        TextFile file(path);
        file.text("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                  "  <Collection>\n");
        for (std::size_t k = 0; k < names.size(); ++k) {
            file.text("    <DataSet timestep=\"" + std::to_string(k) + "\" part=\"0\" file=\"" +
                      names[k] + "\"/>\n");
        }
        file.text("  </Collection>\n</VTKFile>\n");
        file.commit();
    }

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

    Conversion convert_mesh(const std::string& input, const std::string& output,
                            Session& session) const {
        WriteOptions options;
        options.format = format_;
        const Format& format = format_to_write(output, options, false);
        if (!metric_.empty() && format.name != "mtc" && format.name != "vtu") {
            throw UsageError("--metric: only .mtc and .vtu take a metric beside the mesh");
        }
        MeshFile file = load_mesh(input, session, {.surfaces = true});
        take_names(file);
        session.monitor.progress(0.5, "writing " + output);
        options.version = version_ > 0 ? version_ : file.format_version;
        options.carried = &file.carried;
        std::optional<TensorFile> tensors;
        if (format.name == "vtu" && !metric_.empty()) {
            options.tensors = &tensors.emplace(read_tensors(metric_));
        } else {
            options.metric = write_metric_beside(session);
        }
        Conversion result;
        result.format = file.format;
        std::visit(
            [&](const auto& mesh) {
                result.losses = write_mesh(output, mesh, options);
                result.what = count_text(static_cast<std::int64_t>(mesh.points.size())) +
                              " nodes, " +
                              count_text(static_cast<std::int64_t>(mesh.elements.size())) + " " +
                              element_word(std::decay_t<decltype(mesh)>::dimension);
            },
            file.mesh);
        return result;
    }

    /// Names the patches as the file of `--names` says.
    void take_names(MeshFile& file) const {
        if (names_.empty()) {
            return;
        }
        const FileBytes bytes(names_);
        for (const auto& [id, patch] : mapbc::read(bytes.view(), names_)) {
            if (!patch.name.empty()) {
                std::visit(
                    [&, id = id, &name = patch.name](auto& mesh) { mesh.patch_names[id] = name; },
                    file.mesh);
            }
        }
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
    std::string names_;
    int version_ = 0;
};

} // namespace

std::unique_ptr<Command> make_convert_command() {
    return std::make_unique<ConvertCommand>();
}

} // namespace ameco::cli
