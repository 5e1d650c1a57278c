// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What may become of the elements around an edge, and a node in the middle of it.
#pragma once

#include "core/adapt/unit_mesh.h"

namespace ameco {

/// Whether an edge may leave, or get a node: faces inside the domain, required elements, edges and
/// frozen faces have frozen nodes only, and stay.
/// \param shell  of the edge a, b
/// \return  accepted, region_border or geometry_class
template <int D>
[[nodiscard]] Verdict allowed_to_change(const EditMesh<D>& mesh, NodeId a, NodeId b,
                                        const Cavity<D>& shell);

/// Whether an edge may leave for good: beyond the above it is no ridge, its elements are of one
/// region, and its boundary faces of one patch.
/// \return  accepted, region_border or geometry_class
template <int D>
[[nodiscard]] Verdict allowed_to_leave(const EditMesh<D>& mesh, NodeId a, NodeId b,
                                       const Cavity<D>& shell);

/// Nodes a shell may be starred from: those of its ring, ascending. On the boundary only the ones
/// beside the ghost will do: a star from one behind them would pull it to the surface.
template <int D>
void shell_ring(const EditMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell,
                std::vector<NodeId>& ring);

/// Judges the boundary faces in the star of a shell from `node`, a node of its ring: the boundary
/// must stay a manifold, and near to what it was.
template <int D>
[[nodiscard]] Verdict judge_swapped_boundary(const UnitMesh<D>& mesh, const SurfaceRules& surface,
                                             const Cavity<D>& shell, NodeId node, Star<D>& star);

/// Adds the node that halves an edge in the metric. No element has it yet.
/// \param shell  of the edge a, b
template <int D>
NodeId add_middle_node(UnitMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell);

} // namespace ameco
