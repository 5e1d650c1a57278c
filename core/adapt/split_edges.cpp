// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/split_edges.h"

#include "core/adapt/edge_queue.h"
#include "core/adapt/place_on_surface.h"
#include "core/remesh/edge_shell.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

/// Where along an edge from a to b the two parts have the same length, when the density of length
/// goes geometrically from l_a to l_b.
double middle(double l_a, double l_b) {
    const double r = std::log(l_b / l_a);
    if (std::abs(r) < 1e-3) {
        return 0.5 + r / 8;
    }
    constexpr double nearest_end = 0.1;
    return std::clamp(std::log(0.5 * (1 + std::exp(r))) / r, nearest_end, 1 - nearest_end);
}

template <int D>
class Splitter {
public:
    Splitter(UnitMesh<D>& mesh, const SplitOptions& options) : mesh_(mesh), options_(options) {}

    Verdict split(NodeId a, NodeId b, double length) {
        gather_shell(mesh_.edit, a, b, cavity_);
        const Verdict allowed = allowed_to_change(mesh_.edit, a, b, cavity_);
        if (allowed != Verdict::accepted) {
            return allowed;
        }
        const NodeId m = add_middle_node(mesh_, a, b, cavity_);
        const Verdict verdict = judge(a, b, m, length);
        if (verdict != Verdict::accepted) {
            mesh_.drop_last_node();
            return verdict;
        }
        mesh_.replace(cavity_, star_);
        mesh_.edit.split_ridge(a, b, m);
        if (options_.curved && mesh_.edit.on_boundary(m)) {
            put_on_surface(a, b, m);
        }
        return verdict;
    }

private:
    [[nodiscard]] Verdict judge(NodeId a, NodeId b, NodeId m, double length) {
        // What is asked falls to nothing where the edge is much too long.
        const double strict =
            std::max(0.0, (options_.much_above - length) / (options_.much_above - options_.above));
        least_quality_ = strict * options_.quality_share * worst_quality(mesh_.edit, cavity_);
        gather_near();
        if (options_.by_excess ? !lowers_excess(a, b, m) : is_crowded(a, b, m, strict)) {
            return Verdict::short_edge;
        }
        const Verdict verdict = make_star(mesh_.edit, cavity_, m, star_);
        return verdict == Verdict::accepted ? mesh_.judge(least_quality_, star_) : verdict;
    }

    /// Moves a node that was put into an edge of the boundary to the original surface, if elements
    /// and boundary are good enough there. Lengths change little, and are left to later operations.
    void put_on_surface(NodeId a, NodeId b, NodeId m) {
        const std::optional<Vec<D>> place = place_of(a, b, m);
        if (!place) {
            return;
        }
        least_quality_ =
            std::max(least_quality_, std::min(options_.surface_quality, star_.worst_quality));
        const auto old = mesh_.state(m);
        mesh_.move_node(m, *place);
        if (keeps_elements(m) && judge_moved_faces(mesh_.edit, m, site_.faces, mesh_.short_size(m),
                                                   *options_.curved) == Verdict::accepted) {
            mesh_.keep_moved(m, qualities_);
        } else {
            mesh_.restore(m, old);
        }
    }

    /// Where a node in an edge of the boundary should be; none if that is where it is, to rounding,
    /// as on planes and straight lines.
    [[nodiscard]] std::optional<Vec<D>> place_of(NodeId a, NodeId b, NodeId m) {
        const OriginalSurface<D>* original = mesh_.edit.original_surface();
        if (original == nullptr) {
            return {};
        }
        gather_site(mesh_.edit, m, site_);
        if (site_.on_ridge) {
            site_.direction = (mesh_.edit.point(b) - mesh_.edit.point(a)).normalized();
        }
        const Vec<D>& p = mesh_.edit.point(m);
        std::optional<Vec<D>> place =
            place_on_surface(*original, site_, p, options_.curved->largest_turn_deg);
        return place && !is_same_place(*place, p) ? place : std::nullopt;
    }

    /// Whether the elements at a node that has moved are not inverted, and good enough.
    [[nodiscard]] bool keeps_elements(NodeId m) {
        qualities_.clear();
        for (const ElementId e : mesh_.edit.ball(m)) {
            if (mesh_.edit.is_ghost(e)) {
                continue;
            }
            qualities_.push_back(mesh_.quality(mesh_.edit.nodes(e)));
            if (qualities_.back() <= least_quality_ ||
                !is_positive(mesh_.edit, mesh_.edit.nodes(e))) {
                return false;
            }
        }
        return true;
    }

    void gather_near() {
        near_.clear();
        for (const ElementId e : cavity_.elements) {
            for (const NodeId v : mesh_.edit.nodes(e)) {
                if (v != mesh_.edit.ghost() &&
                    std::find(near_.begin(), near_.end(), v) == near_.end()) {
                    near_.push_back(v);
                }
            }
        }
    }

    /// Nodes that are freer to move do not count: they can leave onto the new one. Otherwise the
    /// nodes beside a ridge could keep it from getting its own.
    [[nodiscard]] bool is_too_near(NodeId m, NodeId v, double shortest) const {
        return mesh_.edit.node_class(v) >= mesh_.edit.node_class(m) &&
               mesh_.length(m, v) < shortest;
    }

    /// Whether a node is too near to the new one: a node of the shell, and where the edge is much
    /// too long, and many others beside it, also a neighbour of one.
    [[nodiscard]] bool is_crowded(NodeId a, NodeId b, NodeId m, double strict) {
        const double shortest =
            strict * options_.shortest + (1 - strict) * options_.shortest_among_long;
        if (std::any_of(near_.begin(), near_.end(), [&](NodeId v) {
                return v != a && v != b && is_too_near(m, v, shortest);
            })) {
            return true;
        }
        if (strict > 0.5) {
            return false;
        }
        for (const NodeId v : near_) {
            mesh_.edit.neighbours(v, neighbours_);
            for (const NodeId w : neighbours_) {
                if (is_too_near(m, w, shortest)) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Whether the edges to the new node have a smaller sum of excesses than the one that goes.
    [[nodiscard]] bool lowers_excess(NodeId a, NodeId b, NodeId m) const {
        return mesh_.excess(m, near_) <= mesh_.excess(a, b) - least_excess_fall;
    }

    UnitMesh<D>& mesh_;
    const SplitOptions& options_;
    std::vector<NodeId> near_; ///< of the shell
    std::vector<NodeId> neighbours_;
    Cavity<D> cavity_;
    Star<D> star_;
    double least_quality_ = 0; ///< of the elements that come [-]
    SurfaceSite<D> site_;
    std::vector<double> qualities_;
};

} // namespace

template <int D>
NodeId add_middle_node(UnitMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell) {
    const bool boundary = at_boundary(mesh.edit, shell);
    const NodeClass node_class = mesh.edit.is_ridge(a, b) ? NodeClass::ridge
                                 : boundary               ? NodeClass::patch
                                                          : NodeClass::interior;
    const Vec<D> e = mesh.edit.point(b) - mesh.edit.point(a);
    const Vec<D> p = mesh.edit.point(a) + middle(mesh.length_at(a, e), mesh.length_at(b, e)) * e;
    return mesh.add_node(p, a, node_class, boundary);
}

template <int D>
std::int64_t split_long_edges(UnitMesh<D>& mesh, const SplitOptions& options, int since,
                              VerdictCounts& verdicts, const Monitor& monitor) {
    std::vector<LongEdge> queue = edges_by_length(mesh, since, {.above = options.above});
    std::reverse(queue.begin(), queue.end());
    Splitter<D> splitter(mesh, options);
    std::int64_t made = 0;
    StopCheck stop(monitor);
    for (const LongEdge& edge : queue) {
        if (stop.asked()) {
            break;
        }
        // No split removes another edge of the queue, and no node moves.
        const Verdict verdict = splitter.split(edge.nodes[0], edge.nodes[1], edge.length);
        verdicts.add(verdict);
        made += verdict == Verdict::accepted ? 1 : 0;
    }
    return made;
}

template NodeId add_middle_node(UnitMesh<2>&, NodeId, NodeId, const Cavity<2>&);
template NodeId add_middle_node(UnitMesh<3>&, NodeId, NodeId, const Cavity<3>&);
template std::int64_t split_long_edges(UnitMesh<2>&, const SplitOptions&, int, VerdictCounts&,
                                       const Monitor&);
template std::int64_t split_long_edges(UnitMesh<3>&, const SplitOptions&, int, VerdictCounts&,
                                       const Monitor&);

} // namespace ameco
