// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Eigenvalues and eigenvectors of small symmetric matrices, the tiny ones included; T is double or
/// Pack.
#pragma once

#include "core/metric/metric.h"
#include "core/metric/pack.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ameco {

/// A D x D matrix by columns: a[j][i] is row i, column j.
template <std::size_t D, class T>
using Columns = std::array<std::array<T, D>, D>;

template <std::size_t D>
[[nodiscard]] inline Columns<D, double> identity() {
    Columns<D, double> I{};
    for (std::size_t k = 0; k < D; ++k) {
        I[k][k] = 1;
    }
    return I;
}

template <std::size_t D, class T>
[[nodiscard]] inline T dot(const std::array<T, D>& a, const std::array<T, D>& b) {
    T sum = a[0] * b[0];
    for (std::size_t k = 1; k < D; ++k) {
        sum = sum + a[k] * b[k];
    }
    return sum;
}

/// (a, b) := (c a - s b, s a + c b).
template <class T>
inline void turn(T& a, T& b, T c, T s) {
    const T a_old = a;
    a = c * a_old - s * b;
    b = s * a_old + c * b;
}

/// One Jacobi rotation of `diagonalise`, in the plane of axes I < J. Returns whether it was wanted.
template <std::size_t I, std::size_t J, std::size_t D, class T>
inline bool rotate(Columns<D, T>& A, Columns<D, T>& V) {
    constexpr double u2 = 0x1p-106; // square of the unit roundoff
    const T g = A[J][I];
    const auto wanted = g * g > u2 * magnitude(A[I][I] * A[J][J]);
    if (!any(wanted)) {
        return false;
    }
    // tan(angle) = y / x is the smaller root of t^2 + (d/g) t - 1 = 0.
    const T d = A[J][J] - A[I][I];
    const T x = select(wanted, magnitude(d) + root(d * d + 4.0 * g * g), T(1));
    const T y = select(wanted, with_sign(2.0 * g, d * g), T{});
    const T radius = 1.0 / root(x * x + y * y);
    const T c = x * radius;
    const T s = y * radius;
    const T shift = y * g / x;
    A[I][I] = A[I][I] - shift;
    A[J][J] = A[J][J] + shift;
    A[J][I] = select(wanted, T{}, g);
    if constexpr (D == 3) {
        constexpr std::size_t K = 3 - I - J;
        turn(A[std::max(I, K)][std::min(I, K)], A[std::max(J, K)][std::min(J, K)], c, s);
    }
    for (std::size_t k = 0; k < D; ++k) {
        turn(V[I][k], V[J][k], c, s);
    }
    return true;
}

/// Turns the symmetric matrix `A` into a diagonal one by Jacobi rotations, A := R^T A R, and
/// the columns of `V` along with it, V := V R. Uses and leaves the upper triangle of `A` only.
///
/// A rotation is skipped only when the off-diagonal entry is negligible beside *both* diagonal
/// ones, |a_ij| <= u sqrt(a_ii a_jj). So where A is positive definite and graded (A = S B S with S
/// diagonal and B well conditioned), even its smallest eigenvalue comes out to full relative
/// precision: Demmel and Veselic, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal.
/// Appl. 13, 1992. Indefinite matrices converge as well. NaN in, NaN out.
template <std::size_t D, class T>
inline void diagonalise(Columns<D, T>& A, Columns<D, T>& V) {
    constexpr int most_sweeps = 40; // 3 or 4 are usual
    bool rotated = true;
    for (int sweep = 0; rotated && sweep < most_sweeps; ++sweep) {
        rotated = rotate<0, 1>(A, V);
        if constexpr (D == 3) {
            rotated = rotate<0, 2>(A, V) || rotated;
            rotated = rotate<1, 2>(A, V) || rotated;
        }
    }
}

/// Brings `values` into ascending order and the columns of `V` along with them.
template <std::size_t D, class T>
inline void sort_ascending(std::array<T, D>& values, Columns<D, T>& V) {
    const auto order = [&](std::size_t i, std::size_t j) {
        const auto swap = values[j] < values[i];
        const auto exchange = [&](T& x, T& y) {
            const T x_old = x;
            x = select(swap, y, x_old);
            y = select(swap, x_old, y);
        };
        exchange(values[i], values[j]);
        for (std::size_t k = 0; k < D; ++k) {
            exchange(V[i][k], V[j][k]);
        }
    };
    order(0, 1);
    if constexpr (D == 3) {
        order(1, 2);
        order(0, 1);
    }
}

/// Makes nearly orthonormal columns orthonormal to the last bits: one Newton step to the polar
/// factor, V := V (3 I - V^T V) / 2.
template <std::size_t D, class T>
inline void orthonormalise(Columns<D, T>& V) {
    Columns<D, T> C; // (I - V^T V) / 2, a few roundings in size
    for (std::size_t i = 0; i < D; ++i) {
        C[i][i] = 0.5 * (1.0 - dot(V[i], V[i]));
        for (std::size_t j = 0; j < i; ++j) {
            C[i][j] = C[j][i] = -0.5 * dot(V[i], V[j]);
        }
    }
    const Columns<D, T> old = V;
    for (std::size_t j = 0; j < D; ++j) {
        for (std::size_t k = 0; k < D; ++k) {
            T correction = old[0][k] * C[j][0];
            for (std::size_t i = 1; i < D; ++i) {
                correction = correction + old[i][k] * C[j][i];
            }
            V[j][k] = old[j][k] + correction;
        }
    }
}

/// Fixes the signs of orthonormal columns: the largest component of each is positive (the first of
/// equals), but the last column makes the frame right-handed.
template <std::size_t D, class T>
inline void fix_signs(Columns<D, T>& V) {
    const auto flip = [](std::array<T, D>& v, T sign) {
        for (T& x : v) {
            x = with_sign(x, x * sign);
        }
    };
    for (std::size_t j = 0; j < D - 1; ++j) {
        T largest = V[j][0];
        for (std::size_t k = 1; k < D; ++k) {
            largest = select(magnitude(V[j][k]) > magnitude(largest), V[j][k], largest);
        }
        flip(V[j], largest);
    }
    if constexpr (D == 2) {
        flip(V[1], V[0][0] * V[1][1] - V[0][1] * V[1][0]);
    } else {
        flip(V[2], V[2][0] * (V[0][1] * V[1][2] - V[0][2] * V[1][1]) +
                       V[2][1] * (V[0][2] * V[1][0] - V[0][0] * V[1][2]) +
                       V[2][2] * (V[0][0] * V[1][1] - V[0][1] * V[1][0]));
    }
}

/// The metric with these sizes and directions, in any order, once they are sorted and their signs
/// fixed.
template <int D>
[[nodiscard]] inline Metric<D> metric_from(std::array<double, D> sizes, Columns<D, double> V) {
    sort_ascending(sizes, V);
    orthonormalise(V);
    fix_signs(V);
    Metric<D> metric;
    std::copy(sizes.begin(), sizes.end(), metric.sizes.data());
    for (int k = 0; k < D; ++k) {
        std::copy(V[k].begin(), V[k].end(), metric.directions.col(k).data());
    }
    return metric;
}

} // namespace ameco
