// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The nodes of a mesh in parts, on which threads work side by side.
#pragma once

#include "core/mesh/adjacency.h"
#include "core/remesh/edit_mesh.h"
#include "core/remesh/lines.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace ameco {

/// Each node in exactly one part; a line in one part as a whole.
struct Partition {
    IdVector<NodeId, std::uint16_t> part; ///< 0 ... parts - 1
    std::size_t parts = 1;
};

/// How many parts a mesh is cut into: a power of two that depends on its size alone, and never on
/// the number of threads, so that the result does not either. Small meshes stay whole.
[[nodiscard]] std::size_t part_count(std::size_t nodes, std::size_t nodes_per_part);

using NodeMarks = IdVector<NodeId, std::uint8_t>; ///< 1 or 0

/// Cuts a mesh by planes, each time in two halves, across the axis where that cuts the fewest
/// edges. Lines lie where their first node lies. Coordinates, unlike growth from seeds, cut no
/// layer lengthwise, however flat the elements are.
/// \param parts   a power of two, at most 1024
/// \param counts  the nodes that halves have equally many of, and whose edges are counted
template <int D>
[[nodiscard]] Partition cut_in_parts(const IdVector<NodeId, Vec<D>>& points,
                                     const NodeNodes& neighbours, const Lines& lines,
                                     std::size_t parts, const NodeMarks& counts);

/// Nodes at the borders of the parts, and their neighbours.
[[nodiscard]] NodeMarks border_nodes(const NodeNodes& neighbours, const Partition& partition);

/// What one thread may change of a mesh: nodes of one part with all their neighbours in it. What
/// touches other parts is the interface: nobody changes it while the parts are worked on, so that
/// threads need no locks. A patch may also be the whole mesh.
class Patch {
public:
    Patch() = default; ///< the whole mesh
    Patch(const Partition& partition, std::size_t part)
        : part_of_(&partition.part), part_(static_cast<std::uint16_t>(part)) {}

    [[nodiscard]] bool is_whole() const { return part_of_ == nullptr; }
    /// Lane of the mesh that edits in this patch use, see EditMesh::open_lanes.
    [[nodiscard]] std::size_t lane() const { return part_; }
    [[nodiscard]] bool holds(NodeId v) const { return is_whole() || (*part_of_)[v] == part_; }
    [[nodiscard]] bool holds(std::span<const NodeId> nodes) const {
        return std::all_of(nodes.begin(), nodes.end(), [&](NodeId v) { return holds(v); });
    }
    /// Whether all nodes of an element belong to the patch.
    template <int D>
    [[nodiscard]] bool holds(const EditMesh<D>& mesh, ElementId e) const {
        const std::span<const NodeId> nodes = mesh.nodes(e);
        return holds(mesh.is_ghost(e) ? nodes.first(D) : nodes);
    }

private:
    const IdVector<NodeId, std::uint16_t>* part_of_ = nullptr;
    std::uint16_t part_ = 0;
};

} // namespace ameco
