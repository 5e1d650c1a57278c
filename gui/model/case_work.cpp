// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/model/case_work.h"

#include "core/base/error.h"
#include "core/base/stop_check.h"
#include "core/base/text.h"
#include "core/coarsen/level_report.h"
#include "core/hierarchy/hierarchy_folder.h"
#include "core/io/format.h"
#include "core/io/io.h"
#include "gui/scene/scene_input.h"

#include <algorithm>
#include <utility>

namespace ameco::gui {
namespace {

namespace fs = std::filesystem;

template <int D>
std::shared_ptr<const SceneData> make_scene(const std::shared_ptr<const AnyLevel>& any, int number,
                                            std::vector<int> removed_at, Monitor& monitor) {
    const Level<D>& level = std::get<Level<D>>(*any);
    SceneInput<D> input;
    input.mesh = std::shared_ptr<const Mesh<D>>(any, &level.mesh);
    input.natural = std::shared_ptr<const MetricField<D>>(any, &level.natural);
    input.removed_at = std::move(removed_at);
    input.name = "level " + std::to_string(number);
    return make_scene_data(std::move(input), monitor);
}

/// Whatever of a level can be worked out from the level itself and the finer one.
/// \param fine  null for the finest level
template <int D>
CaseLevel complete_level(Level<D> level, const Level<D>* fine, LevelStatistics statistics,
                         const LevelTiming& timing, const HierarchyOptions& options,
                         Monitor& monitor) {
    CaseLevel result;
    result.number = statistics.level;
    result.options = options;
    result.options.coarsen.target.factor =
        fine != nullptr ? statistics.factor : HierarchyOptions().coarsen.target.factor;
    result.options.factors.clear();
    if (!level.mesh.elements.empty()) {
        result.conformity =
            fine == nullptr
                ? classify_conformity(level.mesh, level.natural)
                : classify_conformity(level.mesh,
                                      wanted_metric(fine->mesh,
                                                    target_metric(fine->mesh, fine->natural,
                                                                  result.options.coarsen.target),
                                                    level));
    }
    result.level = std::make_shared<const AnyLevel>(std::move(level));
    result.scene = make_scene<D>(result.level, statistics.level, {}, monitor);
    result.statistics = std::move(statistics);
    result.timing = timing;
    return result;
}

void tell_what_was_read(const fs::path& path, const MeshFile& file, Monitor& monitor) {
    const std::string name = path.filename().string();
    for (const std::string& change : file.changes) {
        monitor.message(Severity::warning, name + ": " + change);
    }
    for (const std::string& note : file.notes) {
        monitor.message(Severity::info, name + ": " + note);
    }
}

void tell_repairs(const fs::path& path, const BoundaryRepair& repair, Monitor& monitor) {
    const std::string name = path.filename().string() + ": ";
    for (const std::string& remark : repair_remarks(repair)) {
        monitor.message(Severity::info, name + remark);
    }
}

/// A surface has no metric and cannot be coarsened, but it can be looked at.
CaseLevel surface_level(Mesh<3> mesh, Monitor& monitor) {
    LevelStatistics statistics;
    statistics.nodes = static_cast<std::int64_t>(mesh.points.size());
    statistics.faces = static_cast<std::int64_t>(mesh.faces.size());
    statistics.predicted_nodes = static_cast<double>(statistics.nodes);
    Level<3> level;
    level.mesh = std::move(mesh);
    level.natural.resize(level.mesh.points.size());
    monitor.message(Severity::info, "a surface without volume: it can be looked at, not coarsened");
    return complete_level<3>(std::move(level), nullptr, statistics, {}, {}, monitor);
}

template <int D>
CaseLevel finest_case_level(Mesh<D> mesh, const HierarchyOptions& options, Monitor& monitor) {
    HierarchyOptions none = options;
    none.levels = 0;
    CaseLevel result;
    MonitorPart part(monitor, 0.3, 0.8);
    const LevelSink<D> sink = [&](const Level<D>& level, const LevelStatistics& statistics,
                                  const LevelTiming& timing) {
        result = complete_level<D>(level, nullptr, statistics, timing, options, monitor);
    };
    const HierarchyEnd end = build_hierarchy(std::move(mesh), none, sink, part);
    if (end.status == HierarchyStatus::cancelled) {
        throw Cancelled();
    }
    return result;
}

template <int D>
void add_finest(Mesh<D> mesh, const fs::path& path, const HierarchyOptions& options,
                const Sketch& sketch, LoadedCase& loaded, Monitor& monitor) {
    loaded.file.dimension = D;
    loaded.file.repair = complete_boundary(mesh, options.coarsen.features.ridge_angle_deg);
    tell_repairs(path, loaded.file.repair, monitor);
    monitor.progress(0.2, "checking");
    const CheckReport report = check(mesh);
    stop_if_asked(monitor);
    if (!report.valid()) {
        throw InputError(path.string() + ": not a valid mesh: " + report.summary());
    }
    if (sketch) {
        SceneInput<D> input;
        input.mesh = std::make_shared<const Mesh<D>>(mesh);
        input.name = "level 0";
        sketch(make_scene_data(std::move(input), monitor));
    }
    loaded.levels.push_back(finest_case_level(std::move(mesh), options, monitor));
}

LoadedCase read_finest(const fs::path& path, const HierarchyOptions& options, const Sketch& sketch,
                       Monitor& monitor) {
    if (format_of_suffix(path, true) != nullptr && format_of_suffix(path, false) == nullptr) {
        throw InputError(path.string() +
                         ": holds a metric and no mesh: open the mesh that it belongs to");
    }
    monitor.progress(0, "reading " + path.filename().string());
    MeshFile file = read_mesh(path, {.surfaces = true});
    stop_if_asked(monitor);
    tell_what_was_read(path, file, monitor);
    LoadedCase loaded;
    loaded.file.path = fs::absolute(path).lexically_normal().string();
    loaded.file.format = file.format;
    if (Mesh<3>* const mesh = std::get_if<Mesh<3>>(&file.mesh);
        mesh != nullptr && mesh->elements.empty() && !mesh->faces.empty()) {
        loaded.levels.push_back(surface_level(std::move(*mesh), monitor));
        return loaded;
    }
    std::visit(
        [&](auto& mesh) { add_finest(std::move(mesh), path, options, sketch, loaded, monitor); },
        file.mesh);
    return loaded;
}

/// A level of a folder, read as it was when it was made.
template <int D>
CaseLevel read_stored_level(const StoredLevel& stored, const Hierarchy& hierarchy,
                            const std::vector<LevelTiming>& timings, const CaseLevel& parent,
                            Monitor& monitor) {
    const auto k = static_cast<std::size_t>(stored.number);
    if (stored.number < 1 || k >= hierarchy.levels.size()) {
        throw InputError(stored.folder + ": has no level " + std::to_string(stored.number));
    }
    Level<D> level = read_level<D>(stored.folder, hierarchy, stored.number);
    const Level<D>& fine = std::get<Level<D>>(*parent.level);
    const auto exists = [&](NodeId v) { return fine.mesh.points.contains(v); };
    if (!std::all_of(level.parent.begin(), level.parent.end(), exists)) {
        throw InputError(stored.folder + ": level " + std::to_string(stored.number) +
                         " was not made from the level before it");
    }
    return complete_level(std::move(level), &fine, hierarchy.levels[k].statistics,
                          k < timings.size() ? timings[k] : LevelTiming(), stored.options, monitor);
}

CaseLevel read_stored_level(const StoredLevel& stored, int dimension, const CaseLevel& parent,
                            Monitor& monitor) {
    const Hierarchy hierarchy = read_hierarchy(stored.folder);
    const auto timings = read_timing(stored.folder);
    return dimension == 3 ? read_stored_level<3>(stored, hierarchy, timings, parent, monitor)
                          : read_stored_level<2>(stored, hierarchy, timings, parent, monitor);
}

void add_stored(const std::vector<StoredLevel>& stored, LoadedCase& loaded, Monitor& monitor) {
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const StoredLevel& s = stored[i];
        monitor.progress(static_cast<double>(i + 1) / static_cast<double>(stored.size() + 1),
                         "reading level " + std::to_string(s.number));
        stop_if_asked(monitor);
        const auto parent =
            std::find_if(loaded.levels.begin(), loaded.levels.end(),
                         [&](const CaseLevel& level) { return level.id == s.parent_key; });
        if (parent == loaded.levels.end()) {
            continue; // the reason was told already
        }
        try {
            CaseLevel level = read_stored_level(s, loaded.file.dimension, *parent, monitor);
            level.id = s.key;
            level.parent = s.parent_key;
            loaded.levels.push_back(std::move(level));
        } catch (const Error& error) {
            monitor.message(Severity::warning, error.what());
        }
    }
}

template <int D>
HierarchyEnd make_levels(const CaseLevel& from, double max_aspect_ratio,
                         const HierarchyOptions& options,
                         const std::function<void(CaseLevel)>& sink, Monitor& monitor) {
    Level<D> start = std::get<Level<D>>(*from.level);
    if (options.coarsen.mean != from.options.coarsen.mean) {
        start.natural = nodal_metric(start.mesh, options.coarsen.mean, monitor);
    }
    if (from.number == 0) { // on coarser levels the geometry is carried along
        start.geometry = classify_geometry(start.mesh, options.coarsen.features);
    }
    auto fine = std::make_shared<const Level<D>>(start);
    const LevelSink<D> each = [&](const Level<D>& level, const LevelStatistics& statistics,
                                  const LevelTiming& timing) {
        CaseLevel made = complete_level<D>(level, fine.get(), statistics, timing, options, monitor);
        fine = std::shared_ptr<const Level<D>>(made.level, &std::get<Level<D>>(*made.level));
        sink(std::move(made));
    };
    return extend_hierarchy(std::move(start), from.number, max_aspect_ratio, options, each,
                            monitor);
}

template <int D>
void add_levels(const std::vector<CaseLevel>& branch, HierarchyFolder& folder, Monitor& monitor) {
    for (const CaseLevel& level : branch) {
        stop_if_asked(monitor);
        monitor.progress(level.number / static_cast<double>(branch.size()),
                         "writing level " + std::to_string(level.number));
        folder.add_level(std::get<Level<D>>(*level.level), level.statistics, level.timing);
    }
}

bool is_usable_folder(const fs::path& folder) {
    std::error_code failure;
    if (!fs::exists(folder, failure) || fs::exists(folder / "hierarchy.json", failure)) {
        return true;
    }
    const fs::directory_iterator entries(folder, failure);
    return !failure && entries == fs::directory_iterator();
}

} // namespace

LoadedCase read_case(const fs::path& path, const Sketch& sketch, Monitor& monitor) {
    return read_finest(path, {}, sketch, monitor);
}

LoadedCase read_hierarchy_case(const fs::path& path, Monitor& monitor) {
    const fs::path folder = fs::is_directory(path) ? path : path.parent_path();
    const Hierarchy hierarchy = read_hierarchy(folder);
    if (hierarchy.levels.empty()) {
        throw InputError(folder.string() + ": has no levels: make some with ameco coarsen");
    }
    const fs::path mesh = folder / hierarchy.levels.front().mesh.name;
    LoadedCase loaded = read_finest(mesh, hierarchy.options, {}, monitor);
    std::vector<StoredLevel> stored;
    for (int k = 1; k < intact_levels(folder, hierarchy); ++k) {
        stored.push_back({k, k - 1, k, folder.string(), hierarchy.options});
    }
    if (stored.size() + 1 < hierarchy.levels.size()) {
        monitor.message(Severity::warning,
                        folder.string() + ": files of level " + std::to_string(stored.size() + 1) +
                            " are missing or not those that were written: it is left out");
    }
    add_stored(stored, loaded, monitor);
    return loaded;
}

LoadedCase read_stored_case(const fs::path& mesh, const std::vector<StoredLevel>& stored,
                            Monitor& monitor) {
    const HierarchyOptions options = stored.empty() ? HierarchyOptions() : stored.front().options;
    LoadedCase loaded = read_finest(mesh, options, {}, monitor);
    add_stored(stored, loaded, monitor);
    return loaded;
}

HierarchyEnd make_case_levels(const CaseLevel& from, double max_aspect_ratio,
                              const HierarchyOptions& options,
                              const std::function<void(CaseLevel)>& sink, Monitor& monitor) {
    return std::holds_alternative<Level<3>>(*from.level)
               ? make_levels<3>(from, max_aspect_ratio, options, sink, monitor)
               : make_levels<2>(from, max_aspect_ratio, options, sink, monitor);
}

std::shared_ptr<const SceneData> with_removed_at(const CaseLevel& level,
                                                 std::vector<int> removed_at) {
    return std::holds_alternative<Level<3>>(*level.level)
               ? make_scene<3>(level.level, level.number, std::move(removed_at), Monitor::silent())
               : make_scene<2>(level.level, level.number, std::move(removed_at), Monitor::silent());
}

std::vector<int> removal_levels_of(const std::vector<CaseLevel>& branch, std::size_t k) {
    std::vector<const IdVector<NodeId, NodeId>*> parents;
    for (std::size_t i = k + 1; i < branch.size(); ++i) {
        std::visit([&](const auto& l) { parents.push_back(&l.parent); }, *branch[i].level);
    }
    return removal_levels(static_cast<std::size_t>(branch[k].statistics.nodes), branch[k].number,
                          parents);
}

void write_branch(const CaseFile& file, const std::vector<CaseLevel>& branch,
                  const fs::path& folder, Monitor& monitor) {
    if (!is_usable_folder(folder)) {
        throw FileError(folder.string() + ": the folder is not empty: choose another one");
    }
    Hierarchy h;
    h.program = std::string("ameco ") + AMECO_VERSION;
    h.dimension = file.dimension;
    h.options = branch.back().options;
    h.options.levels = std::max<int>(1, static_cast<int>(branch.size()) - 1);
    h.options.target_ratio = 0;
    for (std::size_t k = 1; k < branch.size(); ++k) {
        h.options.factors.push_back(branch[k].statistics.factor);
    }
    h.input.format = file.format;
    h.input.repair = file.repair;
    HierarchyFolder out(folder, file.path, h);
    if (file.dimension == 3) {
        add_levels<3>(branch, out, monitor);
    } else {
        add_levels<2>(branch, out, monitor);
    }
    out.finish(HierarchyStatus::complete);
}

} // namespace ameco::gui
