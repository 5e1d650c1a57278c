// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/limited_metric.h"

#include <algorithm>

#include <Eigen/LU>
#include <Eigen/SVD>

namespace ameco {
namespace {

/// The metric F^T F.
template <int D>
Metric<D> metric_of(const Mat<D>& factor) {
    // Jacobi rotations on the columns of F^T keep the small singular values of a graded matrix.
    const Eigen::JacobiSVD<Mat<D>> svd(factor.transpose(), Eigen::ComputeFullU);
    Metric<D> m;
    m.sizes = svd.singularValues().cwiseInverse(); // descending values: ascending sizes
    m.directions = svd.matrixU();
    if (m.directions.determinant() < 0) {
        m.directions.col(D - 1) *= -1;
    }
    return m;
}

} // namespace

template <int D>
Metric<D> limited_metric(const Metric<D>& from, const Metric<D>& target, double most,
                         double& excess) {
    const Mat<D> ratio =
        length_factor(target) * from.directions * from.sizes.asDiagonal().toDenseMatrix();
    const Eigen::JacobiSVD<Mat<D>> svd(ratio, Eigen::ComputeFullV);
    const Vec<D> values = svd.singularValues();
    excess = std::max({1.0, values.maxCoeff() / most, 1 / (most * values.minCoeff())});
    if (excess == 1) {
        return target;
    }
    const Vec<D> clamped = values.cwiseMin(most).cwiseMax(1 / most);
    return metric_of<D>(clamped.asDiagonal() * svd.matrixV().transpose() * length_factor(from));
}

template Metric<2> limited_metric(const Metric<2>&, const Metric<2>&, double, double&);
template Metric<3> limited_metric(const Metric<3>&, const Metric<3>&, double, double&);

} // namespace ameco
