// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Singular values and left singular vectors of small matrices, the tiny values included.
#pragma once

#include "core/metric/symmetric_eigen.h"

#include <algorithm>
#include <array>

#include <Eigen/QR>

namespace ameco {

/// A A^T = U diag(squares) U^T.
template <int D>
struct LeftSingular {
    std::array<double, D> squares;
    Columns<D, double> vectors;
};

/// Squares of the singular values of `A`, in no particular order, and its left singular vectors.
///
/// Where A = S C T with S and T diagonal and C well conditioned, as products of metrics are, even
/// the smallest value comes out to full relative precision, however far S and T reach: Householder
/// reflections with sorted rows and pivoted columns leave a triangle R whose rows are graded and
/// otherwise well conditioned (Cox and Higham, Stability of Householder QR factorization for
/// weighted least squares problems, 1998; Higham, QR factorization with complete pivoting and
/// accurate computation of the SVD, Linear Algebra Appl. 309, 2000), and Jacobi rotations keep the
/// small eigenvalues of R R^T (`diagonalise`).
template <int D>
[[nodiscard]] LeftSingular<D> left_singular(const Mat<D>& A) {
    std::array<int, D> order;
    std::array<double, D> largest;
    for (int i = 0; i < D; ++i) {
        order[i] = i;
        largest[i] = A.row(i).cwiseAbs().maxCoeff();
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return largest[i] > largest[j]; });
    Mat<D> sorted;
    for (int i = 0; i < D; ++i) {
        sorted.row(i) = A.row(order[i]);
    }
    const Eigen::ColPivHouseholderQR<Mat<D>> qr(sorted);
    const Mat<D> R = qr.matrixR().template triangularView<Eigen::Upper>();
    const Mat<D> Q = qr.householderQ();
    LeftSingular<D> result;
    Columns<D, double> square{};
    for (int j = 0; j < D; ++j) {
        for (int i = 0; i <= j; ++i) {
            square[j][i] = R.row(i).dot(R.row(j));
        }
        for (int i = 0; i < D; ++i) {
            result.vectors[j][order[i]] = Q(i, j);
        }
    }
    diagonalise(square, result.vectors);
    for (int k = 0; k < D; ++k) {
        result.squares[k] = square[k][k];
    }
    return result;
}

} // namespace ameco
