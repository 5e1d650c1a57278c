// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Four doubles handled side by side, and the same words for one double.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace ameco {

/// Four numbers that take every step together; each lane gets the bits a lone double would get.
///
/// Kept in two registers of two, the width every 64-bit machine has (the compilers' vector type):
/// while one of them waits for a root or a quotient, the other has work.
struct Pack {
    using Register = double __attribute__((vector_size(16)));

    Register a{};
    Register b{};

    Pack() = default;
    Pack(double x) : a(Register{} + x), b(a) {} // implicit, so that 2.0 * p reads as for a double
    Pack(Register low, Register high) : a(low), b(high) {}

    [[nodiscard]] double lane(std::size_t n) const { return n < 2 ? a[n] : b[n - 2]; }
    void set_lane(std::size_t n, double x) {
        if (n < 2) {
            a[n] = x;
        } else {
            b[n - 2] = x;
        }
    }
};

/// Truth of a comparison in each lane: all bits set where true.
struct PackMask {
    using Register = decltype(Pack::Register{} < Pack::Register{});

    Register a;
    Register b;
};

inline constexpr std::size_t pack_lanes = 4;

[[nodiscard]] inline Pack operator+(Pack x, Pack y) {
    return {x.a + y.a, x.b + y.b};
}
[[nodiscard]] inline Pack operator-(Pack x, Pack y) {
    return {x.a - y.a, x.b - y.b};
}
[[nodiscard]] inline Pack operator*(Pack x, Pack y) {
    return {x.a * y.a, x.b * y.b};
}
[[nodiscard]] inline Pack operator/(Pack x, Pack y) {
    return {x.a / y.a, x.b / y.b};
}
[[nodiscard]] inline Pack operator-(Pack x) {
    return {-x.a, -x.b};
}
[[nodiscard]] inline PackMask operator<(Pack x, Pack y) {
    return {x.a < y.a, x.b < y.b};
}
[[nodiscard]] inline PackMask operator>(Pack x, Pack y) {
    return {x.a > y.a, x.b > y.b};
}

// Code that is written once for T = double and T = Pack uses these.

[[nodiscard]] inline double root(double x) {
    return std::sqrt(x);
}
[[nodiscard]] inline Pack::Register root(Pack::Register x) {
#ifdef __SSE2__
    return _mm_sqrt_pd(x);
#else
    return Pack::Register{std::sqrt(x[0]), std::sqrt(x[1])};
#endif
}
[[nodiscard]] inline Pack root(Pack x) {
    return {root(x.a), root(x.b)};
}

[[nodiscard]] inline double select(bool where, double x, double y) {
    return where ? x : y;
}
[[nodiscard]] inline Pack::Register select(PackMask::Register where, Pack::Register x,
                                           Pack::Register y) {
    using Mask = PackMask::Register;
    return reinterpret_cast<Pack::Register>((where & reinterpret_cast<Mask>(x)) |
                                            (~where & reinterpret_cast<Mask>(y)));
}
[[nodiscard]] inline Pack select(PackMask where, Pack x, Pack y) {
    return {select(where.a, x.a, y.a), select(where.b, x.b, y.b)};
}

/// `x` with the sign of `sign`.
[[nodiscard]] inline double with_sign(double x, double sign) {
    return std::copysign(x, sign);
}
[[nodiscard]] inline Pack with_sign(Pack x, Pack sign) {
    const PackMask::Register bit{INT64_MIN, INT64_MIN};
    return {select(bit, sign.a, x.a), select(bit, sign.b, x.b)};
}

[[nodiscard]] inline double magnitude(double x) {
    return std::abs(x);
}
[[nodiscard]] inline Pack magnitude(Pack x) {
    return with_sign(x, Pack());
}

[[nodiscard]] inline bool any(bool where) {
    return where;
}
[[nodiscard]] inline bool any(PackMask where) {
    const PackMask::Register either = where.a | where.b;
#ifdef __SSE2__
    return _mm_movemask_pd(reinterpret_cast<Pack::Register>(either)) != 0;
#else
    return (either[0] | either[1]) != 0;
#endif
}

} // namespace ameco
