// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What may become of an edge and the elements around it: the rules that swaps and splits share.
#pragma once

#include "core/remesh/cavity.h"
#include "core/remesh/surface_rules.h"

#include <vector>

namespace ameco {

/// Whether a cavity reaches the boundary: one of its elements is a ghost.
template <int D>
[[nodiscard]] bool at_boundary(const EditMesh<D>& mesh, const Cavity<D>& cavity);

/// Whether two nodes are the ends of an edge of the boundary.
template <int D>
[[nodiscard]] bool is_boundary_edge(const EditMesh<D>& mesh, NodeId a, NodeId b);

/// Whether all real elements of a cavity are of one region, all its boundary faces of one patch.
template <int D>
[[nodiscard]] bool has_one_label(const EditMesh<D>& mesh, const Cavity<D>& cavity);

/// Whether an edge may leave, or get a node: faces inside the domain, borders between regions,
/// required elements, edges and frozen faces have frozen nodes only, and stay.
/// \param shell  of the edge a, b
/// \return  accepted, region_border or geometry_class
template <int D>
[[nodiscard]] Verdict allowed_to_change(const EditMesh<D>& mesh, NodeId a, NodeId b,
                                        const Cavity<D>& shell);

/// Whether an edge may leave for good: beyond the above it is no ridge, and its cavity has one
/// label.
/// \return  accepted, region_border or geometry_class
template <int D>
[[nodiscard]] Verdict allowed_to_leave(const EditMesh<D>& mesh, NodeId a, NodeId b,
                                       const Cavity<D>& shell);

/// Nodes a shell may be starred from: those of its ring, ascending. On the boundary only the ones
/// beside the ghost will do: a star from one behind them would pull it to the surface.
template <int D>
void shell_ring(const EditMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell,
                std::vector<NodeId>& ring);

/// Inside the domain the stars of the smallest shells are the same elements from every node of the
/// ring, and those of shells of four tetrahedra from opposite ones: leaves one node of each, the
/// first.
template <int D>
void drop_equal_stars(const EditMesh<D>& mesh, const Cavity<D>& shell, std::vector<NodeId>& ring);

/// Judges the boundary faces, if any, in the star of a cavity from `node`, one of its nodes: the
/// boundary must stay a manifold, and near to what it was.
/// \param short_size  h_1 at the node [L]
/// \return  accepted, link_condition, surface_normal or surface_distance
template <int D>
[[nodiscard]] Verdict judge_swapped_boundary(const EditMesh<D>& mesh, const SurfaceRules& surface,
                                             double short_size, const Cavity<D>& cavity,
                                             NodeId node, Star<D>& star);

} // namespace ameco
