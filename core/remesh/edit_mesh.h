// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The mesh that the operators edit in place.
#pragma once

#include "core/mesh/mesh.h"
#include "core/mesh/simplex.h"
#include "core/remesh/geometry_classes.h"

#include <limits>
#include <memory>
#include <memory_resource>
#include <span>
#include <unordered_map>

namespace ameco {

/// One element of an EditMesh.
template <int D>
struct EditElement {
    Simplex<D> nodes;
    int label = 0; ///< region; of a ghost element: patch
    float measure =
        0; ///< size quality; of a ghost element: distance bound to the finest boundary [L]
};

/// A simplicial mesh closed by a ghost node, with the ball of every node at hand.
///
/// As in MTC every boundary face, joined to one virtual node, is an element too (a *ghost
/// element*). The mesh then has no boundary, and an operator treats the nodes, edges and faces of
/// the boundary as all others. Ghost elements have the ghost as their last node; the first D nodes
/// are the boundary face. Faces inside the domain are kept aside: their nodes are frozen.
///
/// Nodes keep their ids while the mesh is edited; a removed node has an empty ball. New nodes come
/// behind those of the mesh that was given. Free element slots have no valid node.
template <int D>
class EditMesh {
public:
    EditMesh(const Mesh<D>& mesh, const GeometryClasses<D>& classes);

    [[nodiscard]] NodeId ghost() const { return ghost_; }
    [[nodiscard]] std::size_t node_count() const { return points_.size(); }
    [[nodiscard]] std::size_t slot_count() const { return elements_.size(); }
    [[nodiscard]] typename IdVector<NodeId, Vec<D>>::Ids nodes() const { return points_.ids(); }

    [[nodiscard]] const Vec<D>& point(NodeId v) const { return points_[v]; }
    [[nodiscard]] const EditElement<D>& element(ElementId e) const { return elements_[e]; }
    [[nodiscard]] const Simplex<D>& nodes(ElementId e) const { return elements_[e].nodes; }
    [[nodiscard]] bool is_free(ElementId e) const { return !elements_[e].nodes[0].valid(); }
    [[nodiscard]] bool is_ghost(ElementId e) const { return elements_[e].nodes[D] == ghost_; }
    void set_measure(ElementId e, float measure) { elements_[e].measure = measure; }

    /// Elements at a node, ghost elements among them; empty for a removed node.
    [[nodiscard]] std::span<const ElementId> ball(NodeId v) const {
        return {ball_[v].start, static_cast<std::size_t>(ball_[v].size)};
    }
    [[nodiscard]] bool is_removed(NodeId v) const { return ball_[v].size == 0; }
    /// The nodes that share an edge with a node, ascending; the ghost is not among them.
    void neighbours(NodeId v, std::vector<NodeId>& out) const;

    /// The finest boundary, or null where it is not known.
    [[nodiscard]] const OriginalSurface<D>* original_surface() const { return original_.get(); }

    [[nodiscard]] NodeClass node_class(NodeId v) const { return class_[v]; }
    [[nodiscard]] bool on_boundary(NodeId v) const { return on_boundary_[v] != 0; }

    /// Whether an edge is on a ridge. Lines listed by a file may run inside the domain too; the
    /// nodes of all of them are ridge nodes or frozen, which is quickly seen.
    [[nodiscard]] bool is_ridge(NodeId a, NodeId b) const {
        const auto may_be = [&](NodeId v) {
            return class_[v] == NodeClass::ridge || class_[v] == NodeClass::frozen;
        };
        return may_be(a) && may_be(b) && ridges_.find(sorted(Edge{a, b})) != ridges_.end();
    }
    /// Whether a face of the boundary is one that must stay as it is.
    [[nodiscard]] bool is_required(const Facet<D>& face) const;
    /// Whether a ghost element's face must stay as it is: required, or of a frozen patch.
    [[nodiscard]] bool is_frozen(ElementId ghost_element) const;
    /// Whether an edge is one that a file wants to find again.
    [[nodiscard]] bool is_required(NodeId a, NodeId b) const;
    /// Whether edges between frozen nodes may belong to faces inside the domain or required
    /// elements, which no swap may touch.
    [[nodiscard]] bool has_protected_inside() const {
        return !interior_.empty() || !features_.required_elements.empty();
    }

    /// Deals the free slots to so many lanes. As many threads may then call `replace` at a time,
    /// each with an own lane, where all nodes of its elements, old and fresh, are no other thread's
    /// business. They may read all that has such nodes.
    void open_lanes(std::size_t count);
    /// Free slots of a lane. While several are open none gets more than it has, so that a lane
    /// needs as many as an edit adds elements.
    [[nodiscard]] std::size_t free_slots(std::size_t lane) const {
        return lanes_[lane].free.size();
    }

    /// Puts `fresh` in the place of `old`. Slots of `old` are used again: that of `sources[i]` (an
    /// element of `old`; equal ones stand beside each other, in the order of `old`) for `fresh[i]`
    /// where it is not yet taken.
    /// \param lane  see `open_lanes`
    /// \return  the slots of `fresh`, until the next call with the same lane
    std::span<const ElementId> replace(std::span<const ElementId> old,
                                       std::span<const EditElement<D>> fresh,
                                       std::span<const ElementId> sources, std::size_t lane = 0);

    /// Moves the ridge edges at `removed` to `kept`, after a collapse along a ridge.
    void merge_ridges(NodeId removed, NodeId kept);

    /// Puts the ridge edges a, m and m, b in the place of a, b, after m was inserted there.
    void split_ridge(NodeId a, NodeId b, NodeId m);

    /// Adds a node that no element has yet. Its ball is empty, as that of a removed one.
    NodeId add_node(const Vec<D>& p, NodeClass node_class, bool on_boundary);
    /// Takes back the node added last, whose ball is still empty.
    void drop_last_node();
    /// Moves a node; keeping the elements around it positive is the caller's matter.
    void move_node(NodeId v, const Vec<D>& p) { points_[v] = p; }

    /// What is left, compacted; `parent[i]` is the id that node i had here. Nodes keep their order.
    struct Compact {
        Mesh<D> mesh;
        GeometryClasses<D> classes;
        IdVector<NodeId, NodeId> parent;
    };
    [[nodiscard]] Compact compact() const;

private:
    struct Ball {
        ElementId* start = nullptr; ///< in `pool_`, or in the memory of a lane
        std::int32_t size = 0;
        std::int32_t capacity = 0;
    };
    /// What one thread needs for its edits; apart from others in memory.
    struct alignas(64) Lane {
        std::vector<ElementId> free;                                 ///< slots
        std::vector<ElementId> left_over, filled;                    ///< scratch of `replace`
        std::unique_ptr<std::pmr::monotonic_buffer_resource> memory; ///< of balls that grew
    };
    struct EdgeHash {
        std::size_t operator()(const Edge& e) const {
            return (e[0].index() * 0x9E3779B97F4A7C15ull) ^ (e[1].index() + 0x7F4A7C15ull);
        }
    };

    void fill_balls();
    void add_to_ball(NodeId v, ElementId e, Lane& lane);
    void remove_from_ball(NodeId v, ElementId e);
    void put(ElementId slot, const EditElement<D>& fresh, Lane& lane);
    [[nodiscard]] ElementId free_slot(Lane& lane);
    [[nodiscard]] Features compact_features(const IdVector<NodeId, NodeId>& new_id,
                                            const GeometryClasses<D>& classes,
                                            const Mesh<D>& mesh) const;

    NodeId ghost_{std::numeric_limits<std::int32_t>::max()}; ///< in no array
    IdVector<NodeId, Vec<D>> points_;
    IdVector<NodeId, int> labels_;
    IdVector<ElementId, EditElement<D>> elements_;
    std::vector<Lane> lanes_;
    std::size_t open_lanes_ = 0;      ///< the first ones
    std::vector<ElementId> all_free_; ///< scratch of `open_lanes`
    IdVector<NodeId, Ball> ball_;
    std::vector<ElementId> pool_;

    IdVector<NodeId, NodeClass> class_;
    IdVector<NodeId, std::uint8_t> on_boundary_;
    std::unordered_map<Edge, RidgeEdge, EdgeHash> ridges_;
    std::vector<Facet<D>> required_faces_;           ///< sorted
    std::vector<Edge> required_edges_;               ///< sorted; of D = 2 also the ridges
    std::vector<Facet<D>> ridge_faces_;              ///< D = 2: faces that files call ridges
    std::vector<std::pair<Facet<D>, int>> interior_; ///< faces inside the domain, with patch
    std::map<int, std::string> patch_names_;
    std::vector<int> frozen_patches_;
    std::shared_ptr<const OriginalSurface<D>> original_;
    Features features_; ///< of the mesh this was made from
};

/// Corners of an element of a mesh that is edited, or of one that may come.
template <int D>
[[nodiscard]] std::array<Vec<D>, D + 1> corners_of(const EditMesh<D>& mesh, const Simplex<D>& s) {
    std::array<Vec<D>, D + 1> x;
    for (int i = 0; i <= D; ++i) {
        x[i] = mesh.point(s[i]);
    }
    return x;
}

/// Ghost element of a boundary face whose normal points outwards.
template <int D>
[[nodiscard]] Simplex<D> ghost_simplex(const Facet<D>& face, NodeId ghost) {
    if constexpr (D == 2) {
        return {face[1], face[0], ghost};
    } else {
        return {face[0], face[1], face[2], ghost};
    }
}

/// The boundary face of a ghost element, normal outwards.
template <int D>
[[nodiscard]] Facet<D> ghost_face(const Simplex<D>& ghost_element) {
    if constexpr (D == 2) {
        return {ghost_element[1], ghost_element[0]};
    } else {
        return {ghost_element[0], ghost_element[1], ghost_element[2]};
    }
}

} // namespace ameco
