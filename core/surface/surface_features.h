// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What a surface has besides smooth faces: ridges, corners, curves, patches.
#pragma once

#include "core/mesh/mesh.h"

#include <utility>
#include <vector>

namespace ameco {

struct SurfaceFeatureOptions {
    double ridge_angle_deg = 40;  ///< edges whose faces turn by more are ridges [deg]
    double corner_angle_deg = 50; ///< curves that turn by more have a corner there [deg]
};

/// A run of ridges from corner to corner, or around.
struct SurfaceCurve {
    std::vector<NodeId> nodes;   ///< in order; the first one is repeated at the end of a loop
    std::pair<int, int> patches; ///< on both sides, the smaller one first
    double length = 0;           ///< [L]
    [[nodiscard]] bool closed() const { return nodes.front() == nodes.back(); }
};

struct SurfaceFeatures {
    std::vector<Edge> ridges;    ///< between patches, sharp, open, or listed by the file; ascending
    std::vector<NodeId> corners; ///< where curves end, branch, or turn; ascending
    std::vector<SurfaceCurve> curves;
};

/// Ridges are edges between two patches, edges whose faces turn by more than the ridge angle, edges
/// without two faces, and those that the mesh lists among its features. Corners are nodes where a
/// number of ridges other than two meet, where the two turn by more than the corner angle, and
/// those that the mesh lists.
[[nodiscard]] SurfaceFeatures find_surface_features(const Mesh<3>& mesh,
                                                    const SurfaceFeatureOptions& options = {});

/// Gives every face a patch: faces that hang together across edges that turn by no more than the
/// angle are one, 1, 2, ... in the order of their first faces. Names of patches are dropped.
/// \return the number of patches
int segment_by_angle(Mesh<3>& mesh, double ridge_angle_deg);

} // namespace ameco
