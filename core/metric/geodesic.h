// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The metrics as a curved space: exponential and logarithm map, distance, scalar product.
#pragma once

#include "core/metric/metric.h"

namespace ameco {

/// A tangent vector at a metric M, W = F^T X F with F = `length_factor(M)` and X symmetric.
///
/// The tensor W itself, like M, loses the square of the aspect ratio. X is
/// V^T M^(-1/2) W M^(-1/2) V, the vector moved to the identity and seen in the frame of M, and its
/// entries are logarithms of quotients of sizes.
/// \see docs/theory/geodesic.md, "The space of metrics"; paper, appendix B.4
template <int D>
struct Tangent {
    Mat<D> X = Mat<D>::Zero(); ///< symmetric [-]
};

/// The tangent vector at `base` that is the symmetric matrix `W` [L^-2].
template <int D>
[[nodiscard]] Tangent<D> to_tangent(const Metric<D>& base, const Mat<D>& W);

/// The symmetric matrix W [L^-2] of a tangent vector at `base`.
template <int D>
[[nodiscard]] Mat<D> to_matrix(const Metric<D>& base, const Tangent<D>& tangent);

/// (W_1, W_2)_M = tr(M^(-1/2) W_1 M^-1 W_2 M^(-1/2)) = tr(X_1 X_2), of two tangent vectors at the
/// same metric; equation (24).
template <int D>
[[nodiscard]] double scalar_product(const Tangent<D>& a, const Tangent<D>& b) {
    return a.X.cwiseProduct(b.X).sum();
}

/// Logarithm map: the tangent vector at `base` of the geodesic that is at `other` after unit time,
/// log_M(N) = M^(1/2) log(M^(-1/2) N M^(-1/2)) M^(1/2).
///
/// Accurate as if the directions of the two metrics had been changed by a few units in their last
/// place; seen at the smallest size that is an error of 1e-16 times the aspect ratio.
template <int D>
[[nodiscard]] Tangent<D> log_map(const Metric<D>& base, const Metric<D>& other);

/// Exponential map: where the geodesic through `base` with that tangent vector is after unit time,
/// exp_M(W) = M^(1/2) exp(M^(-1/2) W M^(-1/2)) M^(1/2); equation (26). Inverse of `log_map`.
///
/// Geodesics part exponentially: over a distance d an error of the tangent vector grows by up to
/// sinh(d/2) / (d/2).
template <int D>
[[nodiscard]] Metric<D> exp_map(const Metric<D>& base, const Tangent<D>& tangent);

/// The metric at time `t` of the geodesic that is at `a` for t = 0 and at `b` for t = 1.
template <int D>
[[nodiscard]] Metric<D> geodesic(const Metric<D>& a, const Metric<D>& b, double t);

/// Length of the geodesic between two metrics [-], the root of (23): the root of the sum of
/// log(lambda)^2 over the eigenvalues lambda of M^-1 N. (The paper's first definition lacks the
/// root, without which it is no distance.) Not changed by any linear map of space, nor by inverting
/// both metrics. Where both have the same directions, twice the distance of the logarithms of
/// their sizes.
template <int D>
[[nodiscard]] double invariant_distance(const Metric<D>& a, const Metric<D>& b);

/// M^-1: the same directions, the inverse sizes [L^-1].
template <int D>
[[nodiscard]] Metric<D> inverse(const Metric<D>& metric);

} // namespace ameco
