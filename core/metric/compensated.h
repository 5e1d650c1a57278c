// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Differences and scalar products with twice the digits of a double; T is double or Pack.
#pragma once

#include <array>
#include <cstddef>

namespace ameco {

/// An unevaluated sum `value + rest`, |rest| <= half an ulp of `value`.
template <class T>
struct TwoPart {
    T value;
    T rest;
};

/// a - b without any error (Knuth).
template <class T>
[[nodiscard]] inline TwoPart<T> exact_difference(T a, T b) {
    const T d = a - b;
    const T b_seen = a - d;
    return {d, (a - (d + b_seen)) + (b_seen - b)};
}

/// a + b without any error (Knuth).
template <class T>
[[nodiscard]] inline TwoPart<T> exact_sum(T a, T b) {
    const T s = a + b;
    const T b_seen = s - a;
    return {s, (a - (s - b_seen)) + (b - b_seen)};
}

/// A number as the sum of two with at most 26 digits each (Veltkamp), so that products of such
/// parts are exact. Values below 1e300.
template <class T>
[[nodiscard]] inline TwoPart<T> halves(T a) {
    const T big = 134217729.0 * a; // 2^27 + 1
    const T high = big - (big - a);
    return {high, a - high};
}

/// A vector given to twice the digits, with the halves of its leading part.
template <std::size_t D, class T>
struct AccurateVec {
    std::array<TwoPart<T>, D> x;
    std::array<TwoPart<T>, D> half;
};

/// a^T e to nearly twice the digits, rounded at the end (Ogita, Rump and Oishi, Accurate sum and
/// dot product, SIAM J. Sci. Comput. 26, 2005; Dekker's product instead of a fused multiply-add,
/// which not every machine has). `a_half` are the halves of `a`.
template <std::size_t D, class T>
[[nodiscard]] inline T accurate_dot(const std::array<T, D>& a,
                                    const std::array<TwoPart<T>, D>& a_half,
                                    const AccurateVec<D, T>& e) {
    TwoPart<T> sum{a[0] * e.x[0].value, a[0] * e.x[0].rest};
    for (std::size_t k = 0; k < D; ++k) {
        const T p = a[k] * e.x[k].value;
        const TwoPart<T>& u = a_half[k];
        const TwoPart<T>& v = e.half[k];
        const T p_rest =
            u.rest * v.rest - (((p - u.value * v.value) - u.rest * v.value) - u.value * v.rest);
        if (k == 0) {
            sum.rest = sum.rest + p_rest;
        } else {
            const TwoPart<T> s = exact_sum(sum.value, p);
            sum.value = s.value;
            sum.rest = sum.rest + (s.rest + (p_rest + a[k] * e.x[k].rest));
        }
    }
    return sum.value + sum.rest;
}

} // namespace ameco
