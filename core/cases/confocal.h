// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Columns of an O-grid around a slender section.
#pragma once

#include "core/base/vec.h"

namespace ameco {

/// The curve on which a column of nodes leaves its foot: a branch of a hyperbola around two foci on
/// the chord. All of them together fill the plane outside the section without crossing, meet a
/// slender section nearly at right angles, and end on a far ellipse with the same foci at equal
/// angles.
///
/// In elliptic coordinates x = f cosh(u) cos(v), z = f sinh(u) sin(v), v is constant.
class ConfocalColumn {
public:
    /// \param foot    its first point, relative to the middle of the foci [L]
    /// \param focal   distance of each focus from the middle, f [L]; the foot is not between the
    /// foci
    ConfocalColumn(const Vec<2>& foot, double focal);

    /// Vector from the foot to the point of the curve that is `distance` away from it [L]. Made
    /// from the small difference in u, so that it keeps its digits when it is 1e-9 of the foot's
    /// coordinates.
    [[nodiscard]] Vec<2> offset(double distance) const;

    /// Distance from the foot to the ellipse whose half axis across the chord is `radius` [L].
    [[nodiscard]] double distance_to_ellipse(double radius) const;

private:
    [[nodiscard]] Vec<2> offset_in_u(double du) const;

    double focal_;
    double cosh_u_ = 1, sinh_u_ = 0; ///< at the foot
    double cos_v_ = 1, sin_v_ = 0;
};

} // namespace ameco
