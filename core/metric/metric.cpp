// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/metric.h"

#include "core/metric/compensated.h"
#include "core/metric/symmetric_eigen.h"

#include <limits>

namespace ameco {

template <int D>
Tensor<D> to_tensor(const Metric<D>& metric) {
    const Mat<D> F = length_factor(metric);
    Tensor<D> tensor;
    std::size_t n = 0;
    for (int i = 0; i < D; ++i) {
        for (int j = i; j < D; ++j) {
            tensor[n++] = F.col(i).dot(F.col(j));
        }
    }
    return tensor;
}

template <int D>
Metric<D> from_tensor(const Tensor<D>& tensor) {
    Mat<D> M;
    std::size_t n = 0;
    for (int i = 0; i < D; ++i) {
        for (int j = i; j < D; ++j) {
            M(i, j) = M(j, i) = tensor[n++];
        }
    }
    Metric<D> metric;
    metric.sizes.setConstant(std::numeric_limits<double>::quiet_NaN());
    if (!M.allFinite()) {
        return metric;
    }
    Mat<D>& V = metric.directions;
    Mat<D> A = M;
    diagonalise<D>(A, V);
    const Vec<D> eigenvalues = A.diagonal();
    if (eigenvalues.minCoeff() > 0 && eigenvalues.allFinite()) {
        metric.sizes = eigenvalues.cwiseSqrt().cwiseInverse();
        sort_ascending<D>(metric.sizes, V);
        fix_signs<D>(V);
    }
    return metric;
}

template Tensor<2> to_tensor<2>(const Metric<2>&);
template Tensor<3> to_tensor<3>(const Metric<3>&);
template Metric<2> from_tensor<2>(const Tensor<2>&);
template Metric<3> from_tensor<3>(const Tensor<3>&);

} // namespace ameco
