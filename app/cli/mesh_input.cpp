// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/mesh_input.h"

#include "app/cli/report.h"
#include "app/cli/suggest.h"
#include "core/io/format.h"

#include <algorithm>
#include <map>
#include <set>

namespace ameco::cli {

namespace fs = std::filesystem;

MeshFile load_mesh(const fs::path& path, Session& session, const ReadOptions& options) {
    session.monitor.progress(0, "reading " + path.filename().string());
    MeshFile file = read_mesh(path, options);
    for (const std::string& change : file.changes) {
        session.monitor.message(Severity::warning, path.string() + ": " + change);
    }
    for (const std::string& note : file.notes) {
        session.monitor.message(Severity::info, path.string() + ": " + note);
    }
    return file;
}

template <int D>
BoundaryRepair make_valid(Mesh<D>& mesh, const fs::path& path, double ridge_angle_deg,
                          Session& session) {
    BoundaryRepair repair = complete_boundary(mesh, ridge_angle_deg);
    for (const std::string& remark : repair_remarks(repair)) {
        session.monitor.message(Severity::info, path.string() + ": " + remark);
    }
    session.monitor.progress(0, "checking " + path.filename().string());
    const CheckReport report = check(mesh);
    if (!report.valid()) {
        throw InputError(path.string() + ": not a valid mesh: " + report.summary() +
                         " (ameco check " + path.string() + " lists everything)");
    }
    return repair;
}

template BoundaryRepair make_valid(Mesh<2>&, const fs::path&, double, Session&);
template BoundaryRepair make_valid(Mesh<3>&, const fs::path&, double, Session&);

ReadyMesh load_valid_mesh(const fs::path& path, double ridge_angle_deg, Session& session) {
    ReadyMesh ready{load_mesh(path, session), {}};
    ready.repair =
        std::visit([&](auto& mesh) { return make_valid(mesh, path, ridge_angle_deg, session); },
                   ready.file.mesh);
    return ready;
}

template <int D>
std::vector<bool> used_nodes(const Mesh<D>& mesh) {
    std::vector<bool> used(mesh.points.size());
    for (const Simplex<D>& element : mesh.elements) {
        for (const NodeId node : element) {
            used[node.index()] = true;
        }
    }
    return used;
}

template std::vector<bool> used_nodes(const Mesh<2>&);
template std::vector<bool> used_nodes(const Mesh<3>&);

template <int D>
MetricField<D> load_metric(const fs::path& path, const Mesh<D>& mesh,
                           const std::string& mesh_name) {
    MetricFile file = read_metric(path);
    auto* const field = std::get_if<MetricField<D>>(&file.field);
    if (field == nullptr || field->size() != mesh.points.size()) {
        const std::size_t count = std::visit([](const auto& f) { return f.size(); }, file.field);
        throw InputError(path.string() + ": has " + std::to_string(count) + " tensors" +
                         (field == nullptr ? " of another dimension" : "") + ", but " + mesh_name +
                         " has " + std::to_string(mesh.points.size()) +
                         " nodes: give the metric that was made for this mesh");
    }
    return std::move(*field);
}

template MetricField<2> load_metric(const fs::path&, const Mesh<2>&, const std::string&);
template MetricField<3> load_metric(const fs::path&, const Mesh<3>&, const std::string&);

std::string element_word(int dimension) {
    return dimension == 3 ? "tets" : "triangles";
}

bool is_metric_name(const fs::path& path) {
    return format_of_suffix(path, true) != nullptr && format_of_suffix(path, false) == nullptr;
}

template <int D>
std::vector<int> find_patches(const Mesh<D>& mesh, const std::string& option,
                              const std::vector<std::string>& wanted) {
    const std::set<int> used(mesh.patch.begin(), mesh.patch.end());
    std::map<std::string, int> by_name;
    for (const int id : used) {
        by_name[std::to_string(id)] = id;
    }
    for (const auto& [id, patch_name] : mesh.patch_names) {
        by_name[patch_name] = id;
    }
    std::set<int> found;
    for (const std::string& word : wanted) {
        const auto entry = by_name.find(word);
        if (entry == by_name.end()) {
            std::vector<std::string> names;
            std::string list;
            for (const auto& [patch_name, id] : by_name) {
                names.push_back(patch_name);
                list += (list.empty() ? "" : ", ") + patch_name;
            }
            throw UsageError(option + " " + word + ": the mesh has no such patch" +
                             did_you_mean(word, names) + " It has " + list);
        }
        found.insert(entry->second);
    }
    return {found.begin(), found.end()};
}

template std::vector<int> find_patches(const Mesh<2>&, const std::string&,
                                       const std::vector<std::string>&);
template std::vector<int> find_patches(const Mesh<3>&, const std::string&,
                                       const std::vector<std::string>&);

void refuse_overwriting(const fs::path& input, const fs::path& output) {
    std::error_code ignored;
    if (fs::equivalent(input, output, ignored)) {
        throw UsageError(output.string() +
                         ": this is the input, which is never overwritten: name another output");
    }
}

void require_suffix(const fs::path& output, const std::vector<std::string>& suffixes) {
    if (std::find(suffixes.begin(), suffixes.end(), output.extension().string()) !=
        suffixes.end()) {
        return;
    }
    std::string list;
    for (const std::string& suffix : suffixes) {
        list += (list.empty() ? "" : " or ") + suffix;
    }
    throw UsageError(output.string() + ": its name must end in " + list);
}

Facts conformity_facts(const Conformity& c) {
    return {{"edge lengths", percent_text(c.in_band) + " of " + count_text(c.edges) +
                                 " within 0.71 - 1.41, " + percent_text(c.below_half) +
                                 " below 0.5, " + percent_text(c.above_two) + " above 2"},
            {"", "shortest " + number_text(c.shortest) + ", longest " + number_text(c.longest)},
            {"quality",
             "mean " + number_text(c.mean_quality) + ", worst " + number_text(c.worst_quality)}};
}

Facts aspect_ratio_facts(const AspectRatioSummary& s) {
    return {{"aspect ratio", "max " + number_text(s.max) + ", 5 % of the nodes above " +
                                 number_text(s.top_5_percent) + ", median " +
                                 number_text(s.median)},
            {"", percent_text(s.share_isotropic) + " of the nodes below 5, " +
                     percent_text(s.share_above_150) + " above 150"}};
}

} // namespace ameco::cli
