// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A weight that goes smoothly from 1 to 0.
#pragma once

#include <algorithm>

namespace ameco {

/// 1 for x <= 0, 0 for x >= 1, and between them the cubic without a kink at either end.
[[nodiscard]] inline double smooth_fall(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return (1 - x) * (1 - x) * (1 + 2 * x);
}

} // namespace ameco
