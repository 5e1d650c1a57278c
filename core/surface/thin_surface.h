// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A surface with fewer nodes, all of them nodes it had.
#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace ameco {

/// A line of the surface that thinning keeps, with a number of the caller's.
struct SurfaceRidge {
    Edge nodes;
    int number = 0;
};

struct ThinningInput {
    std::vector<NodeId> order;        ///< nodes in the order in which they are looked at
    std::vector<bool> frozen;         ///< [n] nodes that stay
    std::vector<SurfaceRidge> ridges; ///< their nodes leave along them only
    /// Whether a node is to leave along an edge to a node that stays: the edge is too short.
    std::function<bool(NodeId leaves, NodeId stays)> too_close;
    /// [k] How far the given faces may be from where they should be [L]; empty: not at all. What
    /// thinning adds comes on top.
    IdVector<FaceId, double> deviation;
    /// [n] How far faces may get from where the node was [L].
    std::vector<double> reach;
    double largest_turn_deg = 30;   ///< of a new face against those around the node before [deg]
    double relative_distance = 0.1; ///< largest deviation of a new face, over its mean edge [-]
};

struct Thinning {
    Mesh<3> surface;                  ///< faces with their patches; nodes as given
    std::vector<bool> removed;        ///< [n]
    std::vector<SurfaceRidge> ridges; ///< what is left of them
    IdVector<FaceId, double>
        deviation; ///< [k] bound of the faces' distance from the given surface [L]
    IdVector<FaceId, std::vector<NodeId>> attached; ///< [k] removed nodes closest to each face
    std::int64_t collapses = 0;
    std::int64_t refused = 0; ///< nodes that were to leave and could not
};

/// Collapses edges of a manifold surface (OpenMesh), node after node: a node leaves onto the first
/// of its neighbours that was looked at and stays, is too close, and whose new faces turn little
/// and keep near the given surface. Closed parts stay closed, of the same genus.
/// \throws InputError  the surface is no manifold
[[nodiscard]] Thinning thin_surface(const Mesh<3>& surface, const ThinningInput& input);

} // namespace ameco
