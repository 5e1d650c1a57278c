// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Distance from a point to a segment or a triangle, and the point that has it.
#pragma once

#include "core/base/vec.h"

#include <array>

namespace ameco {

/// Distance from `p` to the segment a, b [L].
[[nodiscard]] double distance(const Vec<2>& p, const std::array<Vec<2>, 2>& segment);

/// Distance from `p` to the triangle a, b, c [L]; also for triangles without area.
[[nodiscard]] double distance(const Vec<3>& p, const std::array<Vec<3>, 3>& triangle);

/// The point of the triangle a, b, c that is closest to `p`; also for triangles without area.
[[nodiscard]] Vec<3> closest_point(const Vec<3>& p, const std::array<Vec<3>, 3>& triangle);

} // namespace ameco
