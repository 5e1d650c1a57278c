// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/bench/analytic_metric.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace ameco {
namespace {

constexpr double far_size = 0.1;
constexpr double growth = 0.198; ///< of a size with the distance

/// The metric with size h[k] along column k of the orthonormal `frame`.
Metric<3> metric_along(const Mat<3>& frame, const Vec<3>& h) {
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return h[i] < h[j]; });
    Metric<3> m;
    for (int k = 0; k < 3; ++k) {
        m.sizes[k] = h[order[static_cast<std::size_t>(k)]];
        m.directions.col(k) = frame.col(order[static_cast<std::size_t>(k)]);
    }
    return m;
}

Metric<3> polar(const Vec<3>& p, bool around) {
    const double r = std::hypot(p[0], p[1]);
    const double c = r > 0 ? p[0] / r : 1, s = r > 0 ? p[1] / r : 0;
    Mat<3> frame;
    frame << c, -s, 0, s, c, 0, 0, 0, 1;
    const double distance = std::abs(r - 0.5);
    const double near = std::min(distance / 0.1, 1.0);
    const double along = around ? 0.025 + (far_size - 0.025) * near : far_size;
    return metric_along(frame, {0.001 + growth * distance, along, far_size});
}

} // namespace

Metric<3> analytic_metric(AnalyticMetric kind, double first, const Vec<3>& p) {
    const Mat<3> axes = Mat<3>::Identity();
    switch (kind) {
    case AnalyticMetric::linear:
        return metric_along(axes, {far_size, far_size, 0.001 + growth * std::abs(p[2] - 0.5)});
    case AnalyticMetric::polar_1:
        return polar(p, false);
    case AnalyticMetric::polar_2:
        return polar(p, true);
    case AnalyticMetric::layer:
        return metric_along(axes, {far_size, far_size, std::min(first + growth * p[2], far_size)});
    case AnalyticMetric::skew:
        break;
    }
    Mat<3> frame;
    frame.col(2) = Vec<3>(1, 2, 3).normalized();
    frame.col(0) = frame.col(2).cross(Vec<3>(1, 0, 0)).normalized();
    frame.col(1) = frame.col(2).cross(frame.col(0));
    const double distance = std::abs(frame.col(2).dot(p - Vec<3>::Constant(0.5)));
    return metric_along(frame, {far_size, far_size, std::min(first + growth * distance, far_size)});
}

} // namespace ameco
