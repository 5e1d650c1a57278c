// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Eigenvalues and eigenvectors of a small symmetric matrix, the tiny ones included.
#pragma once

#include "core/base/vec.h"

#include <cmath>
#include <limits>
#include <utility>

namespace ameco {

/// Turns the symmetric matrix `A` into a diagonal one by Jacobi rotations, A := R^T A R, and
/// the columns of `V` along with it, V := V R.
///
/// A rotation is skipped only when the off-diagonal entry is negligible beside *both* diagonal
/// ones, |a_ij| <= u sqrt(a_ii a_jj). So where A is positive definite and graded (A = S B S with S
/// diagonal and B well conditioned), even its smallest eigenvalue comes out to full relative
/// precision: Demmel and Veselic, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal.
/// Appl. 13, 1992. Indefinite matrices converge as well. NaN in, NaN out.
template <int D>
inline void diagonalise(Mat<D>& A, Mat<D>& V) {
    constexpr double u2 = std::numeric_limits<double>::epsilon() * 0.5 *
                          (std::numeric_limits<double>::epsilon() * 0.5);
    constexpr int most_sweeps = 40; // 3 or 4 are usual
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        bool rotated = false;
        for (int i = 0; i < D - 1; ++i) {
            for (int j = i + 1; j < D; ++j) {
                const double g = A(i, j);
                if (!(g * g > u2 * std::abs(A(i, i) * A(j, j)))) {
                    continue;
                }
                rotated = true;
                // The smaller root t = tan(angle) of t^2 + 2 d/(2g) t - 1 = 0.
                const double d = A(j, j) - A(i, i);
                const double t =
                    std::copysign(2.0, d) * g / (std::abs(d) + std::sqrt(d * d + 4 * g * g));
                const double c = 1 / std::sqrt(1 + t * t);
                const double s = t * c;
                A(i, i) -= t * g;
                A(j, j) += t * g;
                A(i, j) = A(j, i) = 0;
                for (int k = 0; k < D; ++k) {
                    if (k != i && k != j) {
                        const double a_ik = A(i, k);
                        const double a_jk = A(j, k);
                        A(i, k) = A(k, i) = c * a_ik - s * a_jk;
                        A(j, k) = A(k, j) = s * a_ik + c * a_jk;
                    }
                    const double v_i = V(k, i);
                    const double v_j = V(k, j);
                    V(k, i) = c * v_i - s * v_j;
                    V(k, j) = s * v_i + c * v_j;
                }
            }
        }
        if (!rotated) {
            return;
        }
    }
}

/// Brings `values` into ascending order and the columns of `V` along with them.
template <int D>
inline void sort_ascending(Vec<D>& values, Mat<D>& V) {
    const auto order = [&](int i, int j) {
        if (values[j] < values[i]) {
            std::swap(values[i], values[j]);
            V.col(i).swap(V.col(j));
        }
    };
    order(0, 1);
    if constexpr (D == 3) {
        order(1, 2);
        order(0, 1);
    }
}

/// Fixes the signs of orthonormal columns: the largest component of each is positive (the first of
/// equals), but the last column makes the frame right-handed.
template <int D>
inline void fix_signs(Mat<D>& V) {
    for (int j = 0; j < D - 1; ++j) {
        Eigen::Index k = 0;
        V.col(j).cwiseAbs().maxCoeff(&k);
        if (V(k, j) < 0) {
            V.col(j) = -V.col(j);
        }
    }
    double determinant = 0;
    if constexpr (D == 2) {
        determinant = V(0, 0) * V(1, 1) - V(1, 0) * V(0, 1);
    } else {
        determinant = V(0, 2) * (V(1, 0) * V(2, 1) - V(2, 0) * V(1, 1)) +
                      V(1, 2) * (V(2, 0) * V(0, 1) - V(0, 0) * V(2, 1)) +
                      V(2, 2) * (V(0, 0) * V(1, 1) - V(1, 0) * V(0, 1));
    }
    if (determinant < 0) {
        V.col(D - 1) = -V.col(D - 1);
    }
}

} // namespace ameco
