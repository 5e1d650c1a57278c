// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One symmetric positive definite D x D tensor, as a value.
#pragma once

#include "core/base/id.h"
#include "core/base/vec.h"

#include <array>

namespace ameco {

/// A metric M = V diag(h)^-2 V^T, kept as directions and sizes.
///
/// The sizes h_i = lambda_i^(-1/2) are the lengths [L] of the half axes of the unit ball of M, in
/// ascending order; column i of `directions` is the unit vector of h_i. Kept apart, sizes that
/// differ by 1e8 lose nothing; the tensor itself, whose condition number is the square of the
/// aspect ratio, is formed for files only.
/// \see docs/theory/metric.md; paper, section 2.1
template <int D>
struct Metric {
    Vec<D> sizes = Vec<D>::Ones();          ///< h_1 <= ... <= h_D [L]
    Mat<D> directions = Mat<D>::Identity(); ///< orthonormal columns

    friend bool operator==(const Metric&, const Metric&) = default;
};

/// One metric per node of a mesh.
template <int D>
using MetricField = IdVector<NodeId, Metric<D>>;

/// Number of different components of a symmetric tensor: 3 or 6.
template <int D>
inline constexpr int tensor_size = D*(D + 1) / 2;

/// Components of a symmetric tensor, upper triangle by rows: xx xy yy, or xx xy xz yy yz zz [L^-2].
template <int D>
using Tensor = std::array<double, tensor_size<D>>;

/// Matrix F = diag(1/h) V^T with |F e| the length of e in the metric; M = F^T F.
template <int D>
[[nodiscard]] Mat<D> length_factor(const Metric<D>& metric) {
    return metric.sizes.cwiseInverse().asDiagonal() * metric.directions.transpose();
}

/// Length of the vector `e` [L] in the metric [-]; equation (2).
template <int D>
[[nodiscard]] double length(const Metric<D>& metric, const Vec<D>& e) {
    return (metric.directions.transpose() * e).cwiseQuotient(metric.sizes).norm();
}

/// Largest over smallest size, h_D / h_1, >= 1.
template <int D>
[[nodiscard]] double aspect_ratio(const Metric<D>& metric) {
    return metric.sizes[D - 1] / metric.sizes[0];
}

/// sqrt(det M) = 1 / (h_1 ... h_D) [L^-D]: how many unit cubes a unit of volume holds.
template <int D>
[[nodiscard]] double density(const Metric<D>& metric) {
    return 1.0 / metric.sizes.prod();
}

/// The tensor M, for files.
template <int D>
[[nodiscard]] Tensor<D> to_tensor(const Metric<D>& metric);

/// Directions and sizes of the tensor M. A tensor with an eigenvalue that is not positive (or not
/// finite) is not a metric: returns sizes of NaN, which the caller reports with its place.
template <int D>
[[nodiscard]] Metric<D> from_tensor(const Tensor<D>& tensor);

/// Whether all sizes are finite and positive.
template <int D>
[[nodiscard]] bool is_valid(const Metric<D>& metric) {
    return metric.sizes.allFinite() && metric.sizes.minCoeff() > 0 && metric.directions.allFinite();
}

} // namespace ameco
