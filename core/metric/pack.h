// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A few doubles handled side by side, and the same words for one double.
#pragma once

#include <cmath>
#include <cstdint>

namespace ameco {

/// Two numbers that take every step together; each lane has the bits a lone double would have. The
/// compilers' vector type gives + - * / and comparisons (-1 where true). Two is the width that
/// every 64-bit machine has.
using Pack = double __attribute__((vector_size(16)));
using PackMask = decltype(Pack{} < Pack{});
inline constexpr int pack_lanes = 2;

[[nodiscard]] inline Pack pack_of(double a) {
    return Pack{a, a};
}

// Code that is written once for T = double and T = Pack uses these.

[[nodiscard]] inline double root(double a) {
    return std::sqrt(a);
}
[[nodiscard]] inline Pack root(Pack a) {
    return Pack{std::sqrt(a[0]), std::sqrt(a[1])};
}

[[nodiscard]] inline double magnitude(double a) {
    return std::abs(a);
}
[[nodiscard]] inline Pack magnitude(Pack a) {
    return reinterpret_cast<Pack>(reinterpret_cast<PackMask>(a) & PackMask{INT64_MAX, INT64_MAX});
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
    return (where[0] | where[1]) != 0;
}

} // namespace ameco
