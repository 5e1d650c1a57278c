// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Orientation tests with exact signs.
#pragma once

#include "core/base/vec.h"

namespace ameco {

/// Sign of the area of the triangle a, b, c: +1 counter-clockwise, -1 clockwise, 0 on one line.
/// Exact for all finite coordinates.
[[nodiscard]] int orientation(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c);

/// Sign of the volume of the tetrahedron a, b, c, d, det(b-a, c-a, d-a): +1, -1, or 0 in one plane.
/// Exact for all finite coordinates: a floating-point filter decides most calls, exact arithmetic
/// (CGAL) the rest.
[[nodiscard]] int orientation(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d);

/// How many calls of this thread needed exact arithmetic since it started.
[[nodiscard]] long long exact_orientation_calls();

} // namespace ameco
