// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Places on the boundary of the given mesh for nodes of curved patches and curved ridges.
#pragma once

#include "core/remesh/original_surface.h"
#include "core/remesh/surface_rules.h"

#include <optional>

namespace ameco {

/// Unit vector out of a face.
[[nodiscard]] Vec<2> unit_normal(const std::array<Vec<2>, 2>& face);
[[nodiscard]] Vec<3> unit_normal(const std::array<Vec<3>, 3>& face);

/// The boundary around a node, as it is before the node goes to another place.
template <int D>
struct SurfaceSite {
    NodeFaces<D> faces;
    std::vector<int> patches; ///< of these, ascending
    bool on_ridge = false;    ///< between two patches, or inside the only one
    Vec<D> direction;         ///< unit vector: the mean normal on a patch, the tangent on a ridge
};

/// Sets all but the direction on a ridge, which becomes the mean normal.
template <int D>
void gather_site(const EditMesh<D>& mesh, NodeId v, SurfaceSite<D>& site);

/// The place nearest to `p` on the original surface: on the one patch of a site, or on the ridges
/// between its two or inside the only one. What the corners of the face or edge it lies on have in
/// common is kept to the bit.
/// \param largest_turn_deg  between the original surface there and the site's direction [deg]: the
///                          nearest place may be on the other side of something thin
/// \return  none where the surface is turned by more, or there is no such ridge
template <int D>
[[nodiscard]] std::optional<Vec<D>> place_on_surface(const OriginalSurface<D>& original,
                                                     const SurfaceSite<D>& site, const Vec<D>& p,
                                                     double largest_turn_deg);

/// Whether two places are the same to rounding. Nodes of planes and straight lines of the original
/// surface, which are on it, keep their coordinates to the bit.
template <int D>
[[nodiscard]] bool is_same_place(const Vec<D>& p, const Vec<D>& q) {
    constexpr double rounding = 1e-14; // of coordinates
    return (p - q).norm() <= rounding * q.cwiseAbs().maxCoeff();
}

} // namespace ameco
