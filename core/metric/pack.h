// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Two doubles handled side by side, and the same words for one double.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace ameco {

/// Two numbers that take every step together; each lane has the bits a lone double would have. The
/// compilers' vector type gives + - * / and comparisons. Two is the width every 64-bit machine has;
/// four on such a machine are slower.
using Pack = double __attribute__((vector_size(16)));
using PackMask = decltype(Pack{} < Pack{}); // -1 where true
inline constexpr std::size_t pack_lanes = 2;

// Code that is written once for T = double and T = Pack uses these.

/// The number `a`, in all lanes.
template <class T>
[[nodiscard]] inline T constant(double a) {
    return T{} + a;
}

[[nodiscard]] inline double root(double a) {
    return std::sqrt(a);
}
[[nodiscard]] inline Pack root(Pack a) {
#ifdef __SSE2__
    return _mm_sqrt_pd(a);
#else
    return Pack{std::sqrt(a[0]), std::sqrt(a[1])};
#endif
}

[[nodiscard]] inline double magnitude(double a) {
    return std::abs(a);
}
[[nodiscard]] inline Pack magnitude(Pack a) {
    const PackMask no_sign{INT64_MAX, INT64_MAX};
    return reinterpret_cast<Pack>(reinterpret_cast<PackMask>(a) & no_sign);
}

/// `a` with the sign of `sign`.
[[nodiscard]] inline double with_sign(double a, double sign) {
    return std::copysign(a, sign);
}
[[nodiscard]] inline Pack with_sign(Pack a, Pack sign) {
    const PackMask bit{INT64_MIN, INT64_MIN};
    return reinterpret_cast<Pack>((reinterpret_cast<PackMask>(a) & ~bit) |
                                  (reinterpret_cast<PackMask>(sign) & bit));
}

[[nodiscard]] inline double select(bool where, double a, double b) {
    return where ? a : b;
}
[[nodiscard]] inline Pack select(PackMask where, Pack a, Pack b) {
    return reinterpret_cast<Pack>((where & reinterpret_cast<PackMask>(a)) |
                                  (~where & reinterpret_cast<PackMask>(b)));
}

[[nodiscard]] inline bool any(bool where) {
    return where;
}
[[nodiscard]] inline bool any(PackMask where) {
#ifdef __SSE2__
    return _mm_movemask_pd(reinterpret_cast<Pack>(where)) != 0;
#else
    return (where[0] | where[1]) != 0;
#endif
}

} // namespace ameco
