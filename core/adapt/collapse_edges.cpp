// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/collapse_edges.h"

#include "core/adapt/edge_queue.h"
#include "core/remesh/collapse.h"

#include <algorithm>

namespace ameco {
namespace {

template <int D>
class Collapser {
public:
    Collapser(UnitMesh<D>& mesh, const CollapseOptions& options, const SurfaceRules& surface)
        : mesh_(mesh), options_(options), surface_(surface) {}

    Verdict collapse(const Edge& edge) {
        const Verdict first = propose({.removed = edge[0], .kept = edge[1]}, 0);
        if (first == Verdict::accepted) {
            std::swap(star_, best_star_);
            std::swap(ball_, best_ball_);
        }
        const bool found = first == Verdict::accepted;
        const Verdict second =
            propose({.removed = edge[1], .kept = edge[0]}, found ? best_star_.worst_quality : 0);
        if (second == Verdict::accepted) {
            make({.removed = edge[1], .kept = edge[0]}, ball_, star_);
            return second;
        }
        if (found) {
            make({.removed = edge[0], .kept = edge[1]}, best_ball_, best_star_);
        }
        return first;
    }

private:
    Verdict propose(Collapse collapse, double better_than) {
        Verdict verdict = allowed_by_geometry(mesh_.edit, collapse);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
        gather_ball(mesh_.edit, collapse.removed, ball_);
        mesh_.edit.neighbours(collapse.removed, neighbours_);
        if (options_.by_excess ? !lowers_excess(collapse) : makes_long_edges(collapse)) {
            return Verdict::long_edge;
        }
        verdict = make_star(mesh_.edit, ball_, collapse.kept, star_);
        if (verdict == Verdict::accepted) {
            const double floor = std::min(
                options_.quality_floor, options_.quality_share * worst_quality(mesh_.edit, ball_));
            verdict = mesh_.judge(std::max(floor, better_than), star_);
        }
        if (verdict == Verdict::accepted && mesh_.edit.on_boundary(collapse.removed)) {
            verdict = judge_collapsed_boundary(
                mesh_.edit, surface_, mesh_.short_size(collapse.removed), collapse, ball_, star_);
        }
        return verdict;
    }

    [[nodiscard]] bool makes_long_edges(Collapse collapse) const {
        double longest = options_.longest;
        for (const NodeId v : neighbours_) {
            longest = std::max(longest, mesh_.length(collapse.removed, v));
        }
        return std::any_of(neighbours_.begin(), neighbours_.end(), [&](NodeId v) {
            return v != collapse.kept && mesh_.length(collapse.kept, v) > longest;
        });
    }

    /// Whether the edges that come have a smaller sum of excesses than those that go.
    [[nodiscard]] bool lowers_excess(Collapse collapse) {
        const double most = mesh_.excess(collapse.removed, neighbours_) - least_excess_fall;
        mesh_.edit.neighbours(collapse.kept, beside_kept_);
        double after = 0;
        for (const NodeId v : neighbours_) {
            if (v != collapse.kept &&
                !std::binary_search(beside_kept_.begin(), beside_kept_.end(), v)) {
                after += mesh_.excess(collapse.kept, v);
            }
        }
        return after <= most;
    }

    void make(Collapse collapse, const Cavity<D>& ball, const Star<D>& star) {
        if (mesh_.edit.node_class(collapse.removed) == NodeClass::ridge) {
            mesh_.edit.merge_ridges(collapse.removed, collapse.kept);
        }
        mesh_.replace(ball, star);
    }

    UnitMesh<D>& mesh_;
    const CollapseOptions& options_;
    const SurfaceRules& surface_;
    Cavity<D> ball_, best_ball_;
    Star<D> star_, best_star_;
    std::vector<NodeId> neighbours_; ///< of the node that is to go
    std::vector<NodeId> beside_kept_;
};

} // namespace

template <int D>
std::int64_t collapse_short_edges(UnitMesh<D>& mesh, const CollapseOptions& options,
                                  const SurfaceRules& surface, int since, VerdictCounts& verdicts,
                                  const Monitor& monitor) {
    const std::vector<LongEdge> queue = edges_by_length(mesh, since, {.below = options.below});
    Collapser<D> collapser(mesh, options, surface);
    std::int64_t made = 0;
    StopCheck stop(monitor);
    for (const LongEdge& edge : queue) {
        if (stop.asked()) {
            break;
        }
        // A collapse keeps the edges that do not end in the node it removes.
        if (!mesh.edit.is_removed(edge.nodes[0]) && !mesh.edit.is_removed(edge.nodes[1])) {
            const Verdict verdict = collapser.collapse(edge.nodes);
            verdicts.add(verdict);
            made += verdict == Verdict::accepted ? 1 : 0;
        }
    }
    return made;
}

template std::int64_t collapse_short_edges(UnitMesh<2>&, const CollapseOptions&,
                                           const SurfaceRules&, int, VerdictCounts&,
                                           const Monitor&);
template std::int64_t collapse_short_edges(UnitMesh<3>&, const CollapseOptions&,
                                           const SurfaceRules&, int, VerdictCounts&,
                                           const Monitor&);

} // namespace ameco
