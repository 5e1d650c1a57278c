// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How far an operation may turn and move the boundary.
#pragma once

#include "core/remesh/cavity.h"

namespace ameco {

struct SurfaceRules {
    double largest_turn_deg =
        30; ///< between the normals of a new face and the one it replaces [deg]
    double relative_distance = 0.1; ///< bound on the distance to the finest boundary, over the
                                    ///< mean edge of the new faces [-]
    double layer_share = 0.5; ///< one operation may move the boundary by this share of h_1, and
                              ///< below an element of that size it may lie so far off [-]
};

/// Judges the boundary faces in a star against those of the cavity it fills.
///
/// The distance between the two surfaces is sampled at nodes and edge midpoints of both. It is
/// added to the largest bound of the faces replaced, so that by the triangle inequality the bound
/// of a face stays one for its distance to the finest boundary; new ghost elements carry it as
/// their measure, until it is measured anew (\see BoundaryDistance).
///
/// \param short_size  h_1 of the natural metric nearby [L]: the surface must not pass the layer
///                    above in one step, nor come near to passing the new elements on it in several
/// \return            accepted, surface_normal or surface_distance
template <int D>
[[nodiscard]] Verdict judge_surface(const EditMesh<D>& mesh, const Cavity<D>& cavity,
                                    double short_size, const SurfaceRules& rules, Star<D>& star);

/// Judges a star inside the domain: an element on a boundary face that has moved must not become so
/// thin that the face could have passed it, `layer_share` of its h_1, unless it was thinner before.
/// \return  accepted or surface_distance
template <int D>
[[nodiscard]] Verdict judge_layer(const EditMesh<D>& mesh, const Cavity<D>& cavity,
                                  const SurfaceRules& rules, const Star<D>& star);

/// The boundary faces at a node.
template <int D>
struct NodeFaces {
    std::vector<ElementId> ghosts;              ///< in the order of the node's ball
    std::vector<std::array<Vec<D>, D>> corners; ///< of each
};

template <int D>
void gather_faces(const EditMesh<D>& mesh, NodeId v, NodeFaces<D>& faces);

/// Judges the boundary faces at a node that was moved to a place on the original surface.
///
/// Places on the new faces must be as near to the original surface as the rules ask for, or nearer
/// than those on the old ones; what the move adds to the bounds of the faces is as above.
///
/// \param before  \see gather_faces
/// \return  accepted, surface_normal or surface_distance; nothing is changed unless accepted
template <int D>
[[nodiscard]] Verdict judge_moved_faces(EditMesh<D>& mesh, NodeId v, const NodeFaces<D>& before,
                                        double short_size, const SurfaceRules& rules);

/// Whether the collapse of `removed` onto `kept`, both on the boundary, leaves the boundary a
/// manifold: the links of the two nodes, with the ghost elements, meet in the link of their edge
/// only.
template <int D>
[[nodiscard]] Verdict check_link(const EditMesh<D>& mesh, NodeId removed, NodeId kept);

} // namespace ameco
