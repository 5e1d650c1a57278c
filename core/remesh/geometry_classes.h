// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Which nodes may leave, and along what: corners, ridges, patches. Classified once on the finest
/// level and carried from level to level, so that coarse angles do not invent or lose features.
#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>

namespace ameco {

enum class NodeClass : std::uint8_t {
    interior, ///< may be removed along any edge
    patch,    ///< on a smooth part of the boundary: leaves along the boundary, within its patch
    ridge,    ///< on a sharp edge or between patches: leaves along that line only
    frozen    ///< corner, required, or on a face inside the domain: stays
};

struct FeatureOptions {
    double ridge_angle_deg = 60;  ///< boundary edges that turn by more than this are kept [deg]
    double corner_angle_deg = 50; ///< ridges that turn by more than this have a corner there [deg]
};

template <int D>
struct GeometryClasses {
    IdVector<NodeId, NodeClass> node;  ///< [n]
    std::vector<Edge> ridges;          ///< sharp edges (3-D), each sorted, in ascending order
    /// Upper bound of the distance between each face and the finest boundary [L], [k].
    IdVector<FaceId, double> deviation;
};

/// Classifies the nodes of a valid mesh from patch ids, dihedral angles and declared features.
template <int D>
[[nodiscard]] GeometryClasses<D> classify_geometry(const Mesh<D>& mesh,
                                                   const FeatureOptions& options = {});

} // namespace ameco
