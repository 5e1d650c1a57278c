// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/metric.h"

#include "core/metric/symmetric_eigen.h"

#include <cmath>
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
    Columns<D, double> A{};
    std::size_t n = 0;
    bool finite = true;
    for (std::size_t i = 0; i < D; ++i) {
        for (std::size_t j = i; j < D; ++j) {
            finite = finite && std::isfinite(tensor[n]);
            A[j][i] = tensor[n++];
        }
    }
    Metric<D> metric;
    metric.sizes.setConstant(std::numeric_limits<double>::quiet_NaN());
    if (!finite) {
        return metric;
    }
    Columns<D, double> V = identity<D>();
    diagonalise(A, V);
    std::array<double, D> sizes;
    for (std::size_t k = 0; k < D; ++k) {
        if (!(A[k][k] > 0)) {
            return metric;
        }
        sizes[k] = 1 / std::sqrt(A[k][k]);
    }
    return metric_from<D>(sizes, V);
}

template Tensor<2> to_tensor<2>(const Metric<2>&);
template Tensor<3> to_tensor<3>(const Metric<3>&);
template Metric<2> from_tensor<2>(const Tensor<2>&);
template Metric<3> from_tensor<3>(const Tensor<3>&);

} // namespace ameco
