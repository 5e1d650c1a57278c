// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/memory_estimate.h"
#include "app/cli/mesh_input.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "core/coarsen/coarsen.h"
#include "core/hierarchy/statistics_json.h"

#include <CLI/CLI.hpp>

#include <map>
#include <optional>

namespace ameco::cli {
namespace {

struct PatchInfo {
    std::string name;
    std::int64_t faces = 0;
};

/// Nodal aspect ratios: of a metric file, or of the natural metric of a valid mesh.
struct AspectRatios {
    AspectRatioSummary summary;
    AspectRatioClasses classes;
};

struct MeshInfo {
    std::string file, format;
    std::vector<std::string> notes;
    int dimension = 0;
    std::int64_t nodes = 0, elements = 0, faces = 0;           ///< as in the file
    std::vector<double> low, high;                             ///< bounding box [L]
    std::map<int, PatchInfo> patches;                          ///< after completion
    std::map<int, std::int64_t> regions;                       ///< elements by region
    std::vector<std::pair<std::string, std::size_t>> features; ///< those the file has
    BoundaryRepair repair;
    CheckReport check;
    std::optional<AspectRatios> aspect_ratios;
};

struct MetricInfo {
    std::string file, format;
    std::vector<std::string> notes;
    int dimension = 0;
    std::int64_t nodes = 0;
    double smallest = 0, largest = 0; ///< sizes [L]
    AspectRatios aspect_ratios;
};

template <int D>
AspectRatios aspect_ratios_of(const MetricField<D>& field) {
    return {summarise_aspect_ratios(field), classify_aspect_ratios(field)};
}

template <int D>
void describe_content(const Mesh<D>& mesh, MeshInfo& info) {
    info.dimension = D;
    info.nodes = static_cast<std::int64_t>(mesh.points.size());
    info.elements = static_cast<std::int64_t>(mesh.elements.size());
    info.faces = static_cast<std::int64_t>(mesh.faces.size());
    if (!mesh.points.empty()) {
        Vec<D> low = mesh.points[NodeId(0)];
        Vec<D> high = low;
        for (const Vec<D>& x : mesh.points) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
        info.low.assign(low.data(), low.data() + D);
        info.high.assign(high.data(), high.data() + D);
    }
    for (const int region : mesh.region) {
        ++info.regions[region];
    }
    const Features& f = mesh.features;
    for (const auto& [what, count] : std::initializer_list<std::pair<const char*, std::size_t>>{
             {"edges", f.edges.size()},
             {"corners", f.corners.size()},
             {"ridges", f.ridges.size()},
             {"required nodes", f.required_nodes.size()},
             {"required edges", f.required_edges.size()},
             {"required faces", f.required_faces.size()},
             {"required elements", f.required_elements.size()}}) {
        if (count > 0) {
            info.features.emplace_back(what, count);
        }
    }
}

template <int D>
void describe_patches(const Mesh<D>& mesh, MeshInfo& info) {
    for (const auto& [id, patch_name] : mesh.patch_names) {
        info.patches[id].name = patch_name;
    }
    for (const int id : mesh.patch) {
        ++info.patches[id].faces;
    }
}

MeshInfo inspect_mesh(const std::string& path, Session& session) {
    MeshFile file = load_mesh(path, session);
    MeshInfo info;
    info.file = path;
    info.format = file.format;
    info.notes = file.notes;
    std::visit(
        [&](auto& mesh) {
            describe_content(mesh, info);
            info.repair = complete_boundary(mesh, FeatureOptions{}.ridge_angle_deg);
            describe_patches(mesh, info);
            session.monitor.progress(0.2, "testing");
            info.check = check(mesh);
            if (info.check.valid()) {
                MonitorPart part(session.monitor, 0.4, 1);
                info.aspect_ratios =
                    aspect_ratios_of(nodal_metric(mesh, CoarsenOptions{}.mean, part));
            }
        },
        file.mesh);
    return info;
}

MetricInfo inspect_metric(const std::string& path, Session& session) {
    session.monitor.progress(0, "reading " + path);
    const MetricFile file = read_metric(path);
    MetricInfo info;
    info.file = path;
    info.format = file.format;
    info.notes = file.notes;
    std::visit(
        [&](const auto& field) {
            info.nodes = static_cast<std::int64_t>(field.size());
            bool first = true;
            for (const auto& metric : field) {
                info.dimension = static_cast<int>(metric.sizes.size());
                info.smallest = first ? metric.sizes.minCoeff()
                                      : std::min(info.smallest, metric.sizes.minCoeff());
                info.largest = first ? metric.sizes.maxCoeff()
                                     : std::max(info.largest, metric.sizes.maxCoeff());
                first = false;
            }
            info.aspect_ratios = aspect_ratios_of(field);
        },
        file.field);
    return info;
}

Json info_json(const MeshInfo& info) {
    Json patches = Json::array();
    for (const auto& [id, patch] : info.patches) {
        patches.push_back({{"id", id}, {"name", patch.name}, {"faces", patch.faces}});
    }
    Json regions = Json::array();
    for (const auto& [id, count] : info.regions) {
        regions.push_back({{"id", id}, {"elements", count}});
    }
    Json features = Json::object();
    for (const auto& [what, count] : info.features) {
        features[what] = count;
    }
    Json json = {{"file", info.file},
                 {"kind", "mesh"},
                 {"format", info.format},
                 {"notes", info.notes},
                 {"dimension", info.dimension},
                 {"nodes", info.nodes},
                 {"elements", info.elements},
                 {"boundary_faces", info.faces},
                 {"bounds", {{"low", info.low}, {"high", info.high}}},
                 {"patches", patches},
                 {"regions", regions},
                 {"features", features},
                 {"repair", to_json(info.repair)},
                 {"valid", info.check.valid()},
                 {"errors", to_json(info.check.errors)},
                 {"warnings", to_json(info.check.warnings)}};
    if (info.aspect_ratios) {
        json["volume"] = info.check.volume;
        json["aspect_ratio"] = to_json(info.aspect_ratios->summary, info.aspect_ratios->classes);
        json["memory_to_coarsen_bytes"] =
            coarsening_memory(info.dimension, info.nodes, info.elements);
    }
    return json;
}

Json info_json(const MetricInfo& info) {
    return {{"file", info.file},
            {"kind", "metric"},
            {"format", info.format},
            {"notes", info.notes},
            {"dimension", info.dimension},
            {"nodes", info.nodes},
            {"sizes", {{"smallest", info.smallest}, {"largest", info.largest}}},
            {"aspect_ratio", to_json(info.aspect_ratios.summary, info.aspect_ratios.classes)}};
}

std::string bounds_text(const MeshInfo& info) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    std::string text;
    for (std::size_t i = 0; i < info.low.size(); ++i) {
        text += (i == 0 ? "" : ",  ") + std::string(axes[i]) + " " + number_text(info.low[i]) +
                " .. " + number_text(info.high[i]);
    }
    return text;
}

Facts content_facts(const MeshInfo& info) {
    Facts facts{{"format", info.format},
                {"nodes", count_text(info.nodes)},
                {element_word(info.dimension), count_text(info.elements)},
                {"boundary faces", count_text(info.faces)},
                {"bounds", bounds_text(info)}};
    if (info.check.valid()) {
        facts.emplace_back(info.dimension == 3 ? "volume" : "area",
                           number_text(info.check.volume, 6));
    }
    if (info.regions.size() > 1) {
        std::string text;
        for (const auto& [id, count] : info.regions) {
            text +=
                (text.empty() ? "" : ", ") + std::to_string(id) + " (" + count_text(count) + ")";
        }
        facts.emplace_back("regions", text);
    }
    std::string features;
    for (const auto& [what, count] : info.features) {
        features += (features.empty() ? "" : ", ") + count_text(static_cast<std::int64_t>(count)) +
                    " " + what;
    }
    if (!features.empty()) {
        facts.emplace_back("features", features);
    }
    return facts;
}

void print_remarks(std::ostream& out, const MeshInfo& info) {
    for (const std::string& note : info.notes) {
        out << "  note: " << note << '\n';
    }
    for (const std::string& remark : repair_remarks(info.repair)) {
        out << "  note: " << remark << '\n';
    }
    for (const Finding& f : info.check.warnings) {
        out << "  note: " << name(f.defect) << ", " << count_text(f.count)
            << " (first: " << f.example << ")\n";
    }
}

void print_aspect_ratios(std::ostream& out, const AspectRatios& ratios) {
    print_facts(out, aspect_ratio_facts(ratios.summary));
    out << '\n';
    print_aspect_ratio_classes(out, ratios.classes);
}

void print_info(std::ostream& out, const MeshInfo& info) {
    out << info.file << '\n';
    print_facts(out, content_facts(info));
    print_remarks(out, info);
    if (!info.patches.empty()) {
        out << '\n';
        Table table({{"patch"}, {"faces"}, {"name", Table::Align::left}});
        for (const auto& [id, patch] : info.patches) {
            table.add_row({std::to_string(id), count_text(patch.faces), patch.name});
        }
        table.print(out);
    }
    out << '\n';
    if (info.aspect_ratios) {
        print_aspect_ratios(out, *info.aspect_ratios);
        out << "\ncoarsening it takes about "
            << bytes_text(coarsening_memory(info.dimension, info.nodes, info.elements))
            << " of memory\n";
    } else {
        out << "NOT VALID: " << info.check.summary() << '\n';
    }
}

void print_info(std::ostream& out, const MetricInfo& info) {
    out << info.file << '\n';
    print_facts(out, {{"format", info.format},
                      {"tensors", count_text(info.nodes) + ", all symmetric positive definite, " +
                                      std::to_string(info.dimension) + "-D"},
                      {"sizes", number_text(info.smallest) + " .. " + number_text(info.largest)}});
    for (const std::string& note : info.notes) {
        out << "  note: " << note << '\n';
    }
    print_aspect_ratios(out, info.aspect_ratios);
}

class InfoCommand : public Command {
public:
    [[nodiscard]] CommandHelp help() const override {
        return {
            "info",
            "Describe meshes and metrics: counts, patches, stretching, memory needed.",
            "info FILE... [options]",
            {{"info wing.meshb", "what is in a mesh"},
             {"info wing.meshb wing.solb", "a mesh and a metric"},
             {"info wing.meshb --json", "the same for a program: an array, one entry per file"}},
            "The aspect ratio of a node is the largest over the smallest size of its natural "
            "metric; classes are powers of two, from the most stretched nodes down."};
    }

    void add_options(CLI::App& app) override {
        app.add_option("FILE", files_, "meshes and metrics, in any format of ameco formats")
            ->required();
    }

    ExitCode run(Session& session) override {
        ExitCode worst = ExitCode::ok;
        Json list = Json::array();
        bool first = true;
        for (const std::string& file : files_) {
            try {
                if (is_metric_name(file)) {
                    show(inspect_metric(file, session), session, list, first);
                } else {
                    show(inspect_mesh(file, session), session, list, first);
                }
                first = false;
            } catch (const Error& error) {
                if (files_.size() == 1) {
                    throw;
                }
                session.monitor.message(Severity::error, error.what());
                worst = error.code();
            }
        }
        if (session.json) {
            session.out << list.dump(2) << '\n';
        }
        return worst;
    }

private:
    template <class Info>
    static void show(const Info& info, Session& session, Json& list, bool first) {
        session.monitor.clear_line();
        if (session.json) {
            list.push_back(info_json(info));
        } else {
            session.out << (first ? "" : "\n");
            print_info(session.out, info);
        }
    }

    std::vector<std::string> files_;
};

} // namespace

std::unique_ptr<Command> make_info_command() {
    return std::make_unique<InfoCommand>();
}

} // namespace ameco::cli
