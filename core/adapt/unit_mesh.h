// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A mesh on its way to be unit in a metric: what all operators of the adaptation look at.
#pragma once

#include "core/adapt/metric_source.h"
#include "core/base/stop_check.h"
#include "core/metric/edge_length.h"
#include "core/metric/length_excess.h"
#include "core/remesh/cavity.h"
#include "core/remesh/change_times.h"
#include "core/remesh/metric_quality.h"
#include "core/remesh/surface_rules.h"

namespace ameco {

/// An EditMesh with a metric at every node, also at those that are put in or moved. The `measure`
/// of its elements is their quality in the metric.
template <int D>
class UnitMesh {
public:
    /// \param source  where new nodes get their metric from; must outlive this
    /// \param near    a node of the source's background mesh near each node
    UnitMesh(const Mesh<D>& mesh, const GeometryClasses<D>& classes, const MetricSource<D>& source,
             IdVector<NodeId, NodeId> near, Quality quality = Quality::shape);

    EditMesh<D> edit;

    [[nodiscard]] const RootField<D>& root() const { return root_; }

    /// Length of the straight line between two nodes in the metric [-].
    [[nodiscard]] double length(NodeId a, NodeId b) const { return length(a, edit.point(a), b); }
    /// The same with node a moved to `p`, its metric kept.
    [[nodiscard]] double length(NodeId a, const Vec<D>& p, NodeId b) const {
        const Vec<D> e = edit.point(b) - p;
        return edge_length((factor_[a] * e).norm(), (factor_[b] * e).norm());
    }
    /// Whether the length of an edge is surely from `low` to `high`, told without a logarithm: seen
    /// from both ends it is, and the length is a mean of the two.
    [[nodiscard]] bool is_surely_between(NodeId a, NodeId b, double low, double high) const {
        const Vec<D> e = edit.point(b) - edit.point(a);
        const auto is_between = [&](double square) {
            return square >= low * low && square <= high * high;
        };
        return is_between((factor_[a] * e).squaredNorm()) &&
               is_between((factor_[b] * e).squaredNorm());
    }
    /// \see length_excess
    [[nodiscard]] double excess(NodeId a, NodeId b) const {
        return is_surely_between(a, b, shortest_in_band, longest_in_band)
                   ? 0
                   : length_excess(length(a, b));
    }
    /// Sum over the edges from a node to some others.
    [[nodiscard]] double excess(NodeId v, std::span<const NodeId> others) const {
        double sum = 0;
        for (const NodeId w : others) {
            sum += excess(v, w);
        }
        return sum;
    }
    /// Length of a vector in the metric of one node [-].
    [[nodiscard]] double length_at(NodeId v, const Vec<D>& e) const {
        return (factor_[v] * e).norm();
    }
    /// Vector to the space in which the metric of node v is the unit matrix, and back.
    [[nodiscard]] Vec<D> to_unit(NodeId v, const Vec<D>& e) const { return factor_[v] * e; }
    [[nodiscard]] Vec<D> from_unit(NodeId v, const Vec<D>& y) const {
        // The rows of F are orthogonal: F^-1 = F^T diag(1 / |row|^2).
        return factor_[v].transpose() * y.cwiseQuotient(factor_[v].rowwise().squaredNorm());
    }
    [[nodiscard]] double quality(const Simplex<D>& s) const {
        return metric_quality(edit, root_, s, quality_);
    }
    /// A node of the background mesh near a node.
    [[nodiscard]] NodeId near(NodeId v) const { return near_[v]; }
    /// h_1 of the metric at a node [L].
    [[nodiscard]] double short_size(NodeId v) const { return short_size_[v]; }

    /// Adds a node that has the metric of its place; \see EditMesh::add_node.
    NodeId add_node(const Vec<D>& p, NodeId beside, NodeClass node_class, bool on_boundary);
    void drop_last_node();
    /// Moves a node, and takes the metric from its new place.
    void move_node(NodeId v, const Vec<D>& p);

    /// What `move_node` changes, to be put back.
    struct NodeState {
        Vec<D> point;
        Mat<D> factor;
        Tensor<D> root;
        double short_size;
        NodeId near;
    };
    [[nodiscard]] NodeState state(NodeId v) const {
        return {edit.point(v), factor_[v], root_[v], short_size_[v], near_[v]};
    }
    void restore(NodeId v, const NodeState& state);

    /// Qualities of the star's elements, kept as their `measure`; stops at the first one that is
    /// not above `least`.
    /// \return  accepted or low_quality
    [[nodiscard]] Verdict judge(double least, Star<D>& star) const;

    /// Where a node was when this was made, or when it was added.
    [[nodiscard]] const Vec<D>& first_place(NodeId v) const { return first_place_[v]; }

    /// Has moves leave a node where it is, and swaps leave elements whose nodes are all held.
    void hold(NodeId v) { held_[v] = 1; }
    [[nodiscard]] bool is_held(NodeId v) const { return held_[v] != 0; }

    /// Says that the elements at a node have changed; \see changed_since.
    void touch(NodeId v) { changes_.touch(v); }
    /// Whether anything at the node has changed since that time of the clock.
    [[nodiscard]] bool changed_since(NodeId v, ChangeTimes::Time time) const {
        return changes_.changed_since(v, time);
    }
    /// Starts a new time, and returns it.
    ChangeTimes::Time tick() { return changes_.tick(); }

    /// Says that the ball of a node that has moved has changed, in a time of its own.
    /// \param qualities  of the real elements of the ball, in its order
    void keep_moved(NodeId v, std::span<const double> qualities);

    // Notes on what was tried in vain spare work that would end as it did before.

    /// The corners of an element at which something has changed since no swap was found there, as
    /// bits; all where none was tried yet.
    [[nodiscard]] unsigned corners_changed_since_swap(ElementId e) const {
        const ChangeTimes::Time tried = e.index() < swap_tried_.size() ? swap_tried_[e.index()] : 0;
        return changes_.changed_corners(edit.nodes(e), tried);
    }
    void note_swap_tried(ElementId e);
    /// When a node was last found to have no better place; 0: never.
    [[nodiscard]] ChangeTimes::Time move_tried(NodeId v) const { return move_tried_[v]; }
    void note_move_tried(NodeId v) { move_tried_[v] = changes_.now(); }

    /// Replaces a cavity, and touches the nodes of the star, in a time of its own.
    void replace(const Cavity<D>& cavity, const Star<D>& star);

private:
    void set_metric(NodeId v, const Metric<D>& metric);

    const MetricSource<D>& source_;
    Quality quality_;
    IdVector<NodeId, Mat<D>> factor_;
    RootField<D> root_;
    IdVector<NodeId, double> short_size_;
    IdVector<NodeId, NodeId> near_; ///< a node of the background mesh near each node
    ChangeTimes changes_;
    std::vector<ChangeTimes::Time> swap_tried_; ///< by element slot
    IdVector<NodeId, ChangeTimes::Time> move_tried_;
    IdVector<NodeId, std::uint8_t> held_;
    IdVector<NodeId, Vec<D>> first_place_;
};

} // namespace ameco
