// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Directions at the nodes of a surface.
#pragma once

#include "core/surface/half_edges.h"

namespace ameco {

/// Unit normal of each face, outwards; zero for a face without area. [k]
[[nodiscard]] IdVector<FaceId, Vec<3>> face_normals(const Mesh<3>& mesh);

/// The direction at a node that all of its faces can be seen from best.
struct NodeDirection {
    Vec<3> normal = Vec<3>::Zero(); ///< unit vector; zero at nodes that no face uses
    /// Cosine of the largest angle with a face's normal: > 0 if every face is seen from outside.
    double visibility = 0;
};

/// The unit vector n that maximises min_f n . n_f over the faces f at each node: the axis of the
/// narrowest cone that holds their normals. (The usual mean, weighted by angles, can point into the
/// surface at a sharp corner with many faces on one side; this one does not where any vector
/// exists that does not.) The cone is found among the axes of all pairs and triples of normals.
[[nodiscard]] IdVector<NodeId, NodeDirection> node_directions(const Mesh<3>& mesh,
                                                              const HalfEdges& half_edges);

} // namespace ameco
