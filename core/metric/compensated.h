// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Differences and scalar products with twice the digits of a double.
#pragma once

#include "core/base/vec.h"

namespace ameco {

/// An unevaluated sum `value + rest` of two doubles, |rest| <= half an ulp of `value`.
template <int D>
struct TwoPartVec {
    Vec<D> value;
    Vec<D> rest;
};

/// b - a without any error (Knuth's two-sum, by component).
template <int D>
[[nodiscard]] inline TwoPartVec<D> exact_difference(const Vec<D>& a, const Vec<D>& b) {
    const Vec<D> d = b - a;
    const Vec<D> a_seen = b - d;
    const Vec<D> b_seen = d + a_seen;
    return {d, (b - b_seen) + (a_seen - a)};
}

/// a^T e to nearly twice the digits, rounded to a double at the end (Ogita, Rump and Oishi,
/// Accurate sum and dot product, SIAM J. Sci. Comput. 26, 2005; Veltkamp's splitting, so the result
/// does not depend on whether the machine has a fused multiply-add). Components below 1e300.
template <int D>
[[nodiscard]] inline double accurate_dot(const Vec<D>& a, const TwoPartVec<D>& e) {
    constexpr double splitter = 134217729.0; // 2^27 + 1
    double sum = 0;
    double rest = 0;
    for (int k = 0; k < D; ++k) {
        const double x = a[k];
        const double y = e.value[k];
        const double x_big = splitter * x;
        const double y_big = splitter * y;
        const double x_high = x_big - (x_big - x);
        const double y_high = y_big - (y_big - y);
        const double x_low = x - x_high;
        const double y_low = y - y_high;
        const double p = x * y;
        const double p_rest =
            x_low * y_low - (((p - x_high * y_high) - x_low * y_high) - x_high * y_low);
        const double s = sum + p;
        const double p_seen = s - sum;
        rest += ((sum - (s - p_seen)) + (p - p_seen)) + (p_rest + x * e.rest[k]);
        sum = s;
    }
    return sum + rest;
}

} // namespace ameco
