// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Area of a triangle and volume of a tetrahedron, with the scale of their rounding error.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <limits>

namespace ameco {

struct Volume {
    double value = 0;     ///< positive for positively oriented corners [L^D]
    double magnitude = 0; ///< the same formula with all terms made positive [L^D]
};

/// |computed - true| <= volume_error_bound * magnitude, for one simplex, and for a compensated sum
/// of simplices with the sum of their magnitudes (no under- or overflow).
inline constexpr double volume_error_bound = 16 * std::numeric_limits<double>::epsilon();

/// Signed area (D = 2) or volume (D = 3) of the simplex with the given corners.
[[nodiscard]] Volume volume(const std::array<Vec<2>, 3>& corners);
[[nodiscard]] Volume volume(const std::array<Vec<3>, 4>& corners);

} // namespace ameco
