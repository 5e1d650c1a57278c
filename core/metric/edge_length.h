// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Length of an edge when the metric varies along it.
#pragma once

#include <cmath>

namespace ameco {

/// Length of an edge from its lengths in the metrics of its two ends.
///
/// The prescribed size grows geometrically from one end to the other, so the length is the
/// logarithmic mean
///
///     l = (l_a - l_b) / ln(l_a / l_b)
///
/// and l = l_a where both agree. In a unit mesh every length is near 1.
///
/// \param l_a, l_b  lengths seen from either end [-], >= 0
/// \see docs/theory/conformity.md, "Edge length"
[[nodiscard]] inline double edge_length(double l_a, double l_b) {
    const double big = l_a > l_b ? l_a : l_b;
    const double small = l_a > l_b ? l_b : l_a;
    if (small <= 0) {
        return 0;
    }
    const double d = (big - small) / small;
    if (d < 1e-4) { // series of x / ln(1 + x): the quotient would lose its digits
        return small * (1 + d / 2 - d * d / 12);
    }
    return (big - small) / std::log1p(d);
}

} // namespace ameco
