// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How far two surfaces are from each other.
#pragma once

#include "core/mesh/mesh.h"

namespace ameco {

/// The largest distance of a point of one surface to the other surface, between two bounds.
struct DirectedDistance {
    double lower = 0;           ///< attained by a point that was tried [L]
    double upper = 0;           ///< no point is farther [L]
    Vec<3> at = Vec<3>::Zero(); ///< the point that attains `lower`
    bool converged = true;      ///< upper - lower is within the tolerance that was asked for
};

/// The Hausdorff distance: the larger of both directions.
struct SurfaceDistance {
    DirectedDistance there; ///< from the first surface to the second
    DirectedDistance back;  ///< from the second to the first

    [[nodiscard]] double lower() const;
    [[nodiscard]] double upper() const;
};

/// Distance of the faces of `from` to those of `to`, by branch and bound.
///
/// For a triangle with corners x_i and any triangle t of the other surface, the distance d(x, t) is
/// a convex function of x, so that
///
///     max_i d(x_i, S)  <=  max_{x in T} d(x, S)  <=  min_t max_i d(x_i, t);
///
/// t runs over the triangles closest to the corners and the middle. The triangle with the largest
/// upper bound is cut in two across its longest edge until that bound is no more than `tolerance`
/// above the largest distance seen.
///
/// \param tolerance  error allowed [L], > 0
/// \param max_cuts   cuts after which the bounds are returned as they are: parallel faces at a
///                   distance h much smaller than they are long need pieces of size
///                   sqrt(2 h tolerance) along the edges of the other surface
[[nodiscard]] DirectedDistance directed_distance(const Mesh<3>& from, const Mesh<3>& to,
                                                 double tolerance, long max_cuts = 1'000'000);

/// Both directions. \throws InputError  one of them has no faces
[[nodiscard]] SurfaceDistance surface_distance(const Mesh<3>& a, const Mesh<3>& b,
                                               double tolerance);

} // namespace ameco
