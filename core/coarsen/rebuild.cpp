// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/rebuild.h"

#include "core/base/error.h"
#include "core/base/stop_check.h"
#include "core/base/stopwatch.h"
#include "core/coarsen/fit_level.h"
#include "core/coarsen/level_report.h"
#include "core/mesh/facets.h"
#include "core/metric/edge_length.h"
#include "core/recovery/fill.h"
#include "core/remesh/front_order.h"
#include "core/remesh/original_surface.h"
#include "core/surface/boundary_surface.h"
#include "core/surface/self_intersections.h"
#include "core/surface/surface_tree.h"
#include "core/surface/thin_surface.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace ameco {

#ifndef AMECO_WITH_HALF_EDGES

void require_rebuildable(const Mesh<3>&) {
    throw Error(ExitCode::not_built, "--rebuild tetgen: this build has no OpenMesh (Debian: "
                                     "libopenmesh-dev)");
}

Level<3> rebuild_level(const Level<3>& fine, const CoarsenOptions&, CoarsenReport&, Monitor&) {
    require_rebuildable(fine.mesh);
    return {};
}

#else

void require_rebuildable(const Mesh<3>& mesh) {
    const auto refuse = [](const std::string& what) {
        throw UsageError("--rebuild: a mesh with " + what + " is coarsened by local operations");
    };
    if (std::any_of(mesh.region.begin(), mesh.region.end(),
                    [&](int r) { return r != mesh.region.raw().front(); })) {
        refuse("several regions");
    }
    const Features& features = mesh.features;
    if (!features.required_edges.empty() || !features.required_faces.empty() ||
        !features.required_elements.empty()) {
        refuse("required edges, faces or elements");
    }
    if (check(mesh).interior_faces > 0) {
        refuse("faces inside");
    }
    if (!can_recover()) {
        throw Error(ExitCode::not_built,
                    "--rebuild tetgen: this build has no TetGen (Debian: libtet1.5-dev)");
    }
}

namespace {

/// What decides about nodes.
struct Selection {
    const Level<3>& fine;
    const MetricField<3>& target;
    double reach;

    [[nodiscard]] bool too_close(NodeId v, NodeId w) const {
        const Vec<3> e = fine.mesh.points[w] - fine.mesh.points[v];
        return edge_length(length(target[v], e), length(target[w], e)) < reach;
    }
};

struct Thinned {
    Thinning thinning;                   ///< in numbers of the surface
    IdVector<NodeId, NodeId> of_surface; ///< fine node of each surface node
};

Thinned thin_boundary(const Selection& selection, const FrontOrder& front,
                      const CoarsenOptions& options) {
    const Level<3>& fine = selection.fine;
    IdVector<NodeId, NodeId> number;
    const Mesh<3> surface = boundary_surface(fine.mesh, &number);
    Thinned thinned;
    thinned.of_surface.resize(surface.points.size());
    ThinningInput input;
    for (const NodeId v : front.order) {
        if (number[v].valid()) {
            thinned.of_surface[number[v]] = v;
            input.order.push_back(number[v]);
        }
    }
    for (const NodeId v : thinned.of_surface) {
        input.frozen.push_back(fine.geometry.node[v] == NodeClass::frozen);
        input.reach.push_back(options.removal.surface.layer_share * fine.natural[v].sizes[0]);
    }
    for (std::size_t r = 0; r < fine.geometry.ridges.size(); ++r) {
        const Edge& e = fine.geometry.ridges[r].nodes;
        if (number[e[0]].valid() && number[e[1]].valid()) {
            input.ridges.push_back({{number[e[0]], number[e[1]]}, static_cast<int>(r)});
        }
    }
    input.too_close = [&](NodeId v, NodeId w) {
        return selection.too_close(thinned.of_surface[v], thinned.of_surface[w]);
    };
    input.deviation = fine.geometry.deviation; // faces inside, which have none, are not allowed
    input.largest_turn_deg = options.removal.surface.largest_turn_deg;
    input.relative_distance = options.removal.surface.relative_distance;
    // Faces of the coarse surface may meet where a body is thin: there the fine nodes stay.
    constexpr int attempts = 10;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        thinned.thinning = thin_surface(surface, input);
        const auto meeting = self_intersections(thinned.thinning.surface);
        if (meeting.empty()) {
            return thinned;
        }
        std::vector<bool> involved(surface.points.size());
        for (const auto& pair : meeting) {
            for (const FaceId f : pair) {
                for (const NodeId v : thinned.thinning.surface.faces[f]) {
                    involved[v.index()] = true;
                }
                for (const NodeId v : thinned.thinning.attached[f]) {
                    involved[v.index()] = true;
                }
            }
        }
        for (const Facet<3>& f : surface.faces) { // and those around them
            if (std::any_of(f.begin(), f.end(), [&](NodeId v) { return involved[v.index()]; })) {
                for (const NodeId v : f) {
                    input.frozen[v.index()] = true;
                }
            }
        }
    }
    throw CheckFailed("the coarse surface would intersect itself");
}

/// Which nodes stay: those of the thinned surface, and inside those that no rule removes.
std::vector<bool> choose_nodes(const Selection& selection, const Thinned& thinned,
                               const FrontOrder& front, const Lines& lines,
                               const NodeNodes& neighbours) {
    const Mesh<3>& mesh = selection.fine.mesh;
    std::vector<bool> on_boundary(mesh.points.size()), stays(mesh.points.size());
    for (const NodeId v : thinned.of_surface.ids()) {
        on_boundary[thinned.of_surface[v].index()] = true;
        stays[thinned.of_surface[v].index()] = !thinned.thinning.removed[v.index()];
    }
    for (const NodeId v : front.order) {
        if (on_boundary[v.index()]) {
            continue;
        }
        if (selection.fine.geometry.node[v] == NodeClass::frozen) {
            stays[v.index()] = true;
        } else if (lines.on_line(v)) {
            stays[v.index()] = lines.position[v] % 2 == 0;
        } else {
            const auto around = neighbours[v];
            stays[v.index()] = std::none_of(around.begin(), around.end(), [&](NodeId w) {
                return stays[w.index()] && selection.too_close(v, w);
            });
        }
    }
    return stays;
}

/// Removes nodes inside that the coarse surface has passed or comes near to.
void keep_clear_of(const Mesh<3>& coarse_surface, double deviation, const Level<3>& fine,
                   const std::vector<bool>& on_boundary, std::vector<bool>& stays) {
    constexpr double clearance = 0.3; // of the size across
    const SurfaceTree tree(coarse_surface);
    for (const NodeId v : fine.mesh.points.ids()) {
        if (!stays[v.index()] || on_boundary[v.index()]) {
            continue;
        }
        const double h = fine.natural[v].sizes[0];
        const auto closest = tree.closest(fine.mesh.points[v]);
        if (closest.distance > deviation + clearance * h) {
            continue;
        }
        const auto& t = tree.triangle(closest.face);
        const bool inside = orientation(t[0], t[1], t[2], fine.mesh.points[v]) < 0;
        stays[v.index()] = inside && closest.distance > clearance * h;
    }
}

/// The coarse surface and all nodes that stay, numbered as in the fine mesh.
struct Skeleton {
    Mesh<3> mesh; ///< without elements
    GeometryClasses<3> geometry;
    IdVector<NodeId, NodeId> parent;
};

Skeleton make_skeleton(const Level<3>& fine, const Thinned& thinned,
                       const std::vector<bool>& stays) {
    Skeleton s;
    s.geometry.frozen_patches = fine.geometry.frozen_patches;
    s.geometry.original = fine.geometry.original;
    IdVector<NodeId, NodeId> number(fine.mesh.points.size());
    for (const NodeId v : fine.mesh.points.ids()) {
        if (stays[v.index()]) {
            number[v] = s.mesh.points.next_id();
            s.mesh.points.push_back(fine.mesh.points[v]);
            s.geometry.node.push_back(fine.geometry.node[v]);
            s.parent.push_back(v);
            if (!fine.mesh.labels.empty()) {
                s.mesh.labels.push_back(fine.mesh.labels[v]);
            }
        }
    }
    const auto of = [&](NodeId surface_node) { return number[thinned.of_surface[surface_node]]; };
    const Mesh<3>& surface = thinned.thinning.surface;
    for (const FaceId f : surface.faces.ids()) {
        const auto& [a, b, c] = surface.faces[f];
        s.mesh.faces.push_back({of(a), of(b), of(c)});
        s.mesh.patch.push_back(surface.patch[f]);
        s.geometry.deviation.push_back(thinned.thinning.deviation[f]);
    }
    for (const SurfaceRidge& r : thinned.thinning.ridges) {
        RidgeEdge ridge = fine.geometry.ridges[static_cast<std::size_t>(r.number)];
        ridge.nodes = sorted(Edge{of(r.nodes[0]), of(r.nodes[1])});
        s.geometry.ridges.push_back(ridge);
    }
    std::sort(s.geometry.ridges.begin(), s.geometry.ridges.end(),
              [](const RidgeEdge& a, const RidgeEdge& b) { return a.nodes < b.nodes; });
    for (const NodeId v : fine.mesh.features.corners) {
        s.mesh.features.corners.push_back(number[v]);
    }
    for (const NodeId v : fine.mesh.features.required_nodes) {
        s.mesh.features.required_nodes.push_back(number[v]);
    }
    s.mesh.patch_names = fine.mesh.patch_names;
    return s;
}

/// Collapses a node onto the neighbour that leaves the best elements. \return whether there is one
bool collapse_away(EditMesh<3>& mesh, NodeId v, const SizeField<3>& sizes,
                   const SurfaceRules& rules) {
    Cavity<3> ball;
    Star<3> star, best_star;
    std::vector<NodeId> neighbours;
    gather_ball(mesh, v, ball);
    mesh.neighbours(v, neighbours);
    NodeId best;
    for (const NodeId w : neighbours) {
        if (propose_collapse(mesh, sizes, rules, {.floor = 0, .share = 0}, 1e300,
                             {.removed = v, .kept = w}, ball, star) == Verdict::accepted &&
            (!best.valid() || star.worst_quality > best_star.worst_quality)) {
            best = w;
            std::swap(star, best_star);
        }
    }
    if (best.valid()) {
        apply_collapse(mesh, {.removed = v, .kept = best}, ball, best_star);
    }
    return best.valid();
}

/// Collapses the nodes from `first` on, which TetGen added, as often as that helps.
/// \return those that are left
std::vector<NodeId> collapse_added(EditMesh<3>& mesh, NodeId first, const SizeField<3>& sizes,
                                   SurfaceRules rules) {
    rules.layer_share = std::numeric_limits<double>::infinity(); // they must go, thin as that is
    std::vector<NodeId> left;
    for (std::size_t i = first.index(); i < mesh.node_count(); ++i) {
        left.push_back(NodeId(i));
    }
    for (std::size_t before = left.size() + 1; left.size() < before;) {
        before = left.size();
        std::erase_if(left, [&](NodeId v) { return collapse_away(mesh, v, sizes, rules); });
    }
    return left;
}

/// For each node that is left the node inside that is closest to it: without them TetGen may do
/// without it.
std::vector<NodeId> hindrances(const EditMesh<3>& mesh, const std::vector<NodeId>& left,
                               std::size_t given) {
    std::vector<NodeId> found, neighbours;
    for (const NodeId v : left) {
        NodeId closest;
        const auto distance = [&](NodeId w) { return (mesh.point(w) - mesh.point(v)).norm(); };
        mesh.neighbours(v, neighbours);
        for (const NodeId w : neighbours) {
            if (w.index() < given && !mesh.on_boundary(w) &&
                mesh.node_class(w) == NodeClass::interior &&
                (!closest.valid() || distance(w) < distance(closest))) {
                closest = w;
            }
        }
        if (closest.valid()) {
            found.push_back(closest);
        }
    }
    return found;
}

/// Metric at the nodes of the mesh; nodes that were added take that of a neighbour.
MetricField<3> metric_at(const Mesh<3>& mesh, const MetricField<3>& target,
                         const IdVector<NodeId, NodeId>& parent) {
    MetricField<3> field(mesh.points.size());
    for (const NodeId v : parent.ids()) {
        field[v] = target[parent[v]];
    }
    std::vector<bool> known(mesh.points.size());
    std::fill_n(known.begin(), parent.size(), true);
    for (bool all = false; !all;) {
        all = true;
        for (const Simplex<3>& s : mesh.elements) {
            const auto source =
                std::find_if(s.begin(), s.end(), [&](NodeId v) { return known[v.index()]; });
            for (const NodeId v : s) {
                if (!known[v.index()] && source != s.end()) {
                    field[v] = field[*source];
                    known[v.index()] = true;
                }
                all = all && known[v.index()];
            }
        }
    }
    return field;
}

void swap_to_metric(EditMesh<3>& mesh, const Mesh<3>& built, const MetricField<3>& field,
                    const SizeField<3>& sizes, const CoarsenOptions& options, CoarsenReport& report,
                    Monitor& monitor) {
    measure_size_quality(mesh, sizes);
    const std::size_t n = built.points.size();
    Lines none;
    none.previous.resize(n);
    none.next.resize(n);
    none.position.resize(n, -1);
    none.gap_used.resize(n, 0);
    IdVector<NodeId, float> short_size(n, 0.0F);
    for (std::size_t i = 0; i < n; ++i) {
        short_size[NodeId(i)] = static_cast<float>(field[NodeId(i)].sizes[0]);
    }
    const Couplings couplings = make_couplings(built);
    RemovedNodes<3> removed(couplings, IdVector<NodeId, float>(n, 0.0F), short_size);
    const RootField<3> root = make_root_field(field);
    SwapOptions swaps = options.swaps;
    swaps.rounds = 8; // Delaunay's elements are farther from the metric than those of local steps
    EditNotes notes(mesh);
    swap_bad_elements(mesh, SwapInput<3>{sizes, root, short_size, none, removed, notes}, swaps,
                      options.removal.surface, report.swaps, monitor);
}

/// The mesh that was built, and the fine node of each node of its skeleton.
struct Built {
    EditMesh<3>::Compact compact;
    IdVector<NodeId, NodeId> parent;
};

/// Has TetGen connect the nodes that stay, and brings what it makes to the metric. Where it adds
/// nodes that cannot be collapsed, nodes beside them go, and it tries again.
Built build(const Level<3>& fine, const MetricField<3>& target, const Thinned& thinned,
            std::vector<bool> stays, const CoarsenOptions& options, CoarsenReport& report,
            Monitor& monitor) {
    constexpr int attempts = 6;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        Skeleton skeleton = make_skeleton(fine, thinned, stays);
        RecoveryOptions recovery;
        recovery.radius_edge = 0;
        recovery.holes = points_in_cavities(skeleton.mesh);
        MonitorPart filling(monitor, 0, 0.5);
        Mesh<3> mesh =
            recover_boundary(skeleton.mesh, recovery, "the coarse surface", filling).mesh;
        mesh.region.assign(mesh.elements.size(), fine.mesh.region.raw().front());
        mesh.labels = skeleton.mesh.labels;
        if (!mesh.labels.empty()) {
            mesh.labels.resize(mesh.points.size(), 0);
        }
        GeometryClasses<3> geometry = skeleton.geometry;
        geometry.node.resize(mesh.points.size(), NodeClass::interior);
        const MetricField<3> field = metric_at(mesh, target, skeleton.parent);
        const SizeField<3> sizes = make_size_field(field);
        EditMesh<3> edited(mesh, geometry);
        const std::size_t given = skeleton.parent.size();
        const std::vector<NodeId> left =
            collapse_added(edited, NodeId(given), sizes, options.removal.surface);
        if (left.empty()) {
            MonitorPart swapping(monitor, 0.5, 1);
            swap_to_metric(edited, mesh, field, sizes, options, report, swapping);
            BoundaryDistance<3>().measure(edited);
            return {edited.compact(), std::move(skeleton.parent)};
        }
        for (const NodeId v : hindrances(edited, left, given)) {
            stays[skeleton.parent[v].index()] = false;
        }
    }
    throw CheckFailed("TetGen needs nodes for the coarse surface that the fine mesh does not have");
}

} // namespace

Level<3> rebuild_level(const Level<3>& fine, const CoarsenOptions& options, CoarsenReport& report,
                       Monitor& monitor) {
    require_rebuildable(fine.mesh);
    report = {};
    Stopwatch watch;
    report.factor = options.target.factor;
    report.nodes_before = static_cast<std::int64_t>(fine.mesh.points.size());
    report.elements_before = static_cast<std::int64_t>(fine.mesh.elements.size());
    const MetricField<3> target = target_metric(fine.mesh, fine.natural, options.target);
    report.predicted_nodes = predicted_nodes(fine, target);
    report.seconds.metric = watch.lap();

    const Couplings couplings = make_couplings(fine.mesh);
    const FrontOrder front = front_order(fine.mesh, fine.natural, couplings.neighbours);
    const Lines lines = find_lines(fine.mesh, couplings, front.key, options.lines);
    report.lines = lines.count;
    report.line_nodes = lines.node_count;
    report.seconds.order = watch.lap();

    monitor.progress(0.1, "thinning the surface");
    const Selection selection{fine, target, options.removal.reach};
    const Thinned thinned = thin_boundary(selection, front, options);
    std::vector<bool> stays = choose_nodes(selection, thinned, front, lines, couplings.neighbours);
    std::vector<bool> on_boundary(stays.size());
    for (const NodeId v : thinned.of_surface) {
        on_boundary[v.index()] = true;
    }
    double deviation = 0;
    for (const double d : thinned.thinning.deviation) {
        deviation = std::max(deviation, d);
    }
    keep_clear_of(thinned.thinning.surface, deviation, fine, on_boundary, stays);
    report.seconds.first_pass = watch.lap();
    MonitorPart building(monitor, 0.3, 0.85);
    Built built = build(fine, target, thinned, stays, options, report, building);
    report.seconds.swap = watch.lap();
    stop_if_asked(monitor);

    auto& compact = built.compact;
    Level<3> coarse{std::move(compact.mesh), std::move(compact.classes), {}, {}};
    for (const NodeId v : compact.parent) {
        coarse.parent.push_back(built.parent[v]);
    }
    if (options.nodes == CoarseNodes::moved) {
        MonitorPart fitting(monitor, 0.85, 0.95);
        fit_level(fine.mesh, target, options, coarse, report, fitting);
        report.seconds.fit = watch.lap();
    }
    report.nodes_after = static_cast<std::int64_t>(coarse.mesh.points.size());
    report.elements_after = static_cast<std::int64_t>(coarse.mesh.elements.size());
    report.removal.counts[static_cast<std::size_t>(Verdict::accepted)] =
        report.nodes_before - report.nodes_after;
    report.check = check(coarse.mesh);
    if (!report.check.valid()) {
        throw CheckFailed("the rebuilt mesh is not valid: " + report.check.summary());
    }
    report.conformity = conformity(coarse.mesh, wanted_metric(fine.mesh, target, coarse));
    measure_deviation(coarse.mesh, coarse.geometry, report);
    report.seconds.check = watch.lap();
    monitor.progress(0.95, "measuring the new mesh");
    coarse.natural = nodal_metric(coarse.mesh, options.mean);
    report.seconds.metric += watch.lap();
    return coarse;
}

#endif

} // namespace ameco
