// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/python/level_binding.h"

#include "app/python/arrays.h"
#include "app/python/json_binding.h"
#include "app/python/mesh_binding.h"
#include "app/python/metric_binding.h"
#include "app/python/options_binding.h"
#include "core/hierarchy/build_hierarchy.h"
#include "core/hierarchy/hierarchy_folder.h"
#include "core/multigrid/transfer_files.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <utility>

namespace ameco::python {
namespace {

namespace fs = std::filesystem;

/// A level of either dimension with what was measured on it, never changed.
struct AnyLevel {
    std::variant<std::shared_ptr<const Level<3>>, std::shared_ptr<const Level<2>>> level;
    LevelStatistics statistics;
    LevelTiming timing;
    FeatureOptions features;        ///< that the geometry of level 0 was classified with
    double finest_aspect_ratio = 1; ///< upper edge of the aspect-ratio classes
};

struct Made {
    std::vector<AnyLevel> levels;
    HierarchyEnd end;
};

/// Puts the levels it is given, as `build_hierarchy` does, behind each other.
template <int D>
LevelSink<D> collect(std::vector<AnyLevel>& levels, const FeatureOptions& features,
                     double finest_aspect_ratio) {
    return [&levels, features, finest_aspect_ratio](
               const Level<D>& level, const LevelStatistics& statistics, const LevelTiming& time) {
        const double finest = statistics.level == 0 ? statistics.classes.max
                              : levels.empty()      ? finest_aspect_ratio
                                                    : levels.back().finest_aspect_ratio;
        levels.push_back(
            {std::make_shared<const Level<D>>(level), statistics, time, features, finest});
    };
}

Made build(AnyMesh& mesh, const HierarchyOptions& options, PythonMonitor& monitor) {
    require_valid(mesh, monitor);
    return monitor.call([&] {
        Made made;
        std::visit(
            [&]<int D>(const std::shared_ptr<const Mesh<D>>& m) {
                made.end =
                    build_hierarchy(Mesh<D>(*m), options,
                                    collect<D>(made.levels, options.coarsen.features, 1), monitor);
            },
            mesh.mesh);
        return made;
    });
}

std::pair<std::vector<AnyLevel>, std::string> make_hierarchy(AnyMesh& mesh, const py::dict& given,
                                                             const py::object& progress,
                                                             const py::object& cancel) {
    PythonMonitor monitor(progress, cancel);
    HierarchyOptions options = options_from(given, mesh);
    Made made = build(mesh, options, monitor);
    if (made.end.status == HierarchyStatus::cancelled && made.levels.size() < 2) {
        throw Cancelled();
    }
    return {std::move(made.levels), std::string(name(made.end.status))};
}

/// The one coarser level that was to be made.
AnyLevel only_level(Made&& made) {
    if (made.end.status == HierarchyStatus::cancelled) {
        throw Cancelled();
    }
    if (made.end.refused) {
        throw CheckFailed("the mesh cannot be coarsened: of " +
                          std::to_string(made.end.refused->nodes_before) + " nodes " +
                          std::to_string(made.end.refused->nodes_after) + " would stay");
    }
    return std::move(made.levels.back());
}

AnyLevel coarsen_mesh(AnyMesh& mesh, const py::dict& given, const py::object& progress,
                      const py::object& cancel) {
    PythonMonitor monitor(progress, cancel);
    HierarchyOptions options = options_from(given, mesh);
    options.levels = 1;
    return only_level(build(mesh, options, monitor));
}

AnyMesh mesh_of(const AnyLevel& level) {
    AnyMesh mesh;
    std::visit(
        [&]<int D>(const std::shared_ptr<const Level<D>>& l) {
            mesh.mesh = std::shared_ptr<const Mesh<D>>(l, &l->mesh);
        },
        level.level);
    mesh.known_valid = true;
    return mesh;
}

AnyMetric metric_of(const AnyLevel& level) {
    return std::visit(
        []<int D>(const std::shared_ptr<const Level<D>>& l) -> AnyMetric {
            return {std::shared_ptr<const MetricField<D>>(l, &l->natural)};
        },
        level.level);
}

/// What is kept was decided on the finest level, and goes with the levels.
void require_same_features(const FeatureOptions& given, const FeatureOptions& made_with) {
    const FeatureOptions defaults;
    const bool other_angle = given.ridge_angle_deg != defaults.ridge_angle_deg &&
                             given.ridge_angle_deg != made_with.ridge_angle_deg;
    const bool other_patches =
        !given.frozen_patches.empty() && given.frozen_patches != made_with.frozen_patches;
    const bool other_boundary =
        given.boundary != defaults.boundary && given.boundary != made_with.boundary;
    if (other_angle || other_patches || other_boundary) {
        throw UsageError(std::string(other_angle     ? "ridge_angle"
                                     : other_patches ? "freeze"
                                                     : "boundary") +
                         ": a level keeps what was decided on its finest mesh: give it there");
    }
}

AnyLevel coarsen_level(const AnyLevel& fine, const py::dict& given, const py::object& progress,
                       const py::object& cancel) {
    PythonMonitor monitor(progress, cancel);
    HierarchyOptions options = options_from(given, mesh_of(fine));
    require_same_features(options.coarsen.features, fine.features);
    options.coarsen.features = fine.features;
    const int number = fine.statistics.level;
    options.levels = number + 1;
    return only_level(monitor.call([&] {
        Made made;
        std::visit(
            [&]<int D>(const std::shared_ptr<const Level<D>>& l) {
                made.end = extend_hierarchy(
                    Level<D>(*l), number, fine.finest_aspect_ratio, options,
                    collect<D>(made.levels, fine.features, fine.finest_aspect_ratio), monitor);
            },
            fine.level);
        return made;
    }));
}

Hierarchy empty_hierarchy(const std::vector<AnyLevel>& levels, const py::dict& given) {
    Hierarchy h;
    h.program = std::string("ameco ") + AMECO_VERSION;
    const AnyMesh finest = mesh_of(levels.front());
    h.dimension = finest.dimension();
    h.options = options_from(given, finest);
    h.input.copied = true;
    h.input.format = "made in Python";
    return h;
}

void write_hierarchy(const fs::path& folder_path, const fs::path& source,
                     const std::vector<AnyLevel>& levels, const std::string& status,
                     const py::dict& given, bool transfer) {
    PythonMonitor monitor{py::none(), py::none()};
    const Hierarchy start = empty_hierarchy(levels, given);
    monitor.call([&] {
        HierarchyFolder folder(folder_path, source, start);
        const auto write = [&]<int D>(const std::shared_ptr<const Level<D>>& level,
                                      const AnyLevel& any, const Mesh<D>* finer) {
            folder.add_level(*level, any.statistics, any.timing);
            if (transfer && finer != nullptr) {
                const int k = any.statistics.level;
                folder.add_transfer(k,
                                    write_transfer_files(folder.path(), k - 1, *finer, level->mesh,
                                                         level->parent, monitor),
                                    0);
            }
        };
        const AnyLevel* before = nullptr;
        for (const AnyLevel& any : levels) {
            std::visit(
                [&]<int D>(const std::shared_ptr<const Level<D>>& level) {
                    using Pointer = std::shared_ptr<const Level<D>>;
                    write(level, any,
                          before == nullptr ? nullptr : &std::get<Pointer>(before->level)->mesh);
                },
                any.level);
            before = &any;
        }
        for (const HierarchyStatus s :
             {HierarchyStatus::complete, HierarchyStatus::exhausted, HierarchyStatus::cancelled}) {
            if (name(s) == status) {
                folder.finish(s);
            }
        }
        return true;
    });
}

} // namespace

void bind_levels(py::module_& module) {
    py::class_<AnyLevel>(module, "Level")
        .def_property_readonly("number", [](const AnyLevel& l) { return l.statistics.level; })
        .def_property_readonly("mesh", &mesh_of)
        .def_property_readonly("metric", &metric_of)
        .def_property_readonly("parent",
                               [](const AnyLevel& level) {
                                   return std::visit(
                                       [](const auto& l) { return view_of<int, 1>(l->parent, l); },
                                       level.level);
                               })
        .def_property_readonly(
            "statistics", [](const AnyLevel& l) { return python_value(to_json(l.statistics)); })
        .def_property_readonly(
            "seconds",
            [](const AnyLevel& l) { return python_value(to_json(l.timing).at("seconds")); })
        .def("__repr__", [](const AnyLevel& l) {
            return "<ameco.Level " + std::to_string(l.statistics.level) + ": " +
                   std::to_string(l.statistics.nodes) + " nodes>";
        });
    module.def("coarsen_mesh", &coarsen_mesh);
    module.def("coarsen_level", &coarsen_level);
    module.def("hierarchy", &make_hierarchy);
    module.def("write_hierarchy", &write_hierarchy);
}

} // namespace ameco::python
