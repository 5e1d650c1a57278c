// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/element_metric.h"

#include "core/metric/compensated.h"
#include "core/metric/symmetric_eigen.h"

#include <cmath>

#include <Eigen/Geometry> // cross products

namespace ameco {
namespace {

/// `v` to length 1, or, if it has none, any unit vector perpendicular to the unit vector `q`.
Vec<3> unit_or_perpendicular(const Vec<3>& v, const Vec<3>& q) {
    const double norm = v.norm();
    if (norm > 0) {
        return v / norm;
    }
    Eigen::Index k = 0;
    q.cwiseAbs().minCoeff(&k);
    return q.cross(Vec<3>::Unit(k)).normalized();
}

/// Number of the longest of the vectors.
template <std::size_t N, int D>
std::size_t longest(const std::array<Vec<D>, N>& v) {
    std::size_t best = 0;
    double most = v[0].squaredNorm();
    for (std::size_t i = 1; i < N; ++i) {
        const double length2 = v[i].squaredNorm();
        if (length2 > most) {
            most = length2;
            best = i;
        }
    }
    return best;
}

/// An orthonormal frame in which the element is as long as it is along the first column, as wide as
/// it is along the second, as flat as it is along the last (Gram-Schmidt with pivoting). It need
/// not be accurate to serve, only orthonormal.
Mat<2> frame_of(const std::array<Vec<2>, 2>& e) {
    const Vec<2>& first = e[longest(e)];
    const double norm = first.norm();
    const Vec<2> q = norm > 0 ? Vec<2>(first / norm) : Vec<2>(1, 0);
    Mat<2> Q;
    Q << q[0], -q[1], q[1], q[0];
    return Q;
}

Mat<3> frame_of(const std::array<Vec<3>, 3>& e) {
    const Vec<3>& first = e[longest(e)];
    const double norm = first.norm();
    const Vec<3> q = norm > 0 ? Vec<3>(first / norm) : Vec<3>(1, 0, 0);
    std::array<Vec<3>, 3> across;
    for (std::size_t i = 0; i < 3; ++i) {
        across[i] = e[i] - q * q.dot(e[i]);
    }
    // Twice is enough: after the second time the width of a needle is free of its length.
    Vec<3> wide = across[longest(across)];
    wide -= q * q.dot(wide);
    const Vec<3> r = unit_or_perpendicular(wide, q);
    Mat<3> Q;
    Q.col(0) = q;
    Q.col(1) = r;
    Q.col(2) = q.cross(r);
    return Q;
}

/// Columns of J = E W^-1 from those of E, W the edge vectors of the regular simplex of edge 1.
Mat<2> from_regular(const Mat<2>& E) {
    Mat<2> J;
    J.col(0) = E.col(0);
    J.col(1) = (2 * E.col(1) - E.col(0)) * 0.57735026918962576451; // 1/sqrt(3)
    return J;
}

Mat<3> from_regular(const Mat<3>& E) {
    Mat<3> J;
    J.col(0) = E.col(0);
    J.col(1) = (2 * E.col(1) - E.col(0)) * 0.57735026918962576451;            // 1/sqrt(3)
    J.col(2) = (3 * E.col(2) - E.col(0) - E.col(1)) * 0.40824829046386301637; // 1/sqrt(6)
    return J;
}

} // namespace

template <int D>
Metric<D> element_metric(const std::array<Vec<D>, D + 1>& points) {
    std::array<TwoPartVec<D>, D> edges;
    std::array<Vec<D>, D> rounded;
    for (int i = 0; i < D; ++i) {
        edges[i] = exact_difference<D>(points[0], points[i + 1]);
        rounded[i] = edges[i].value;
    }
    // Rows of Q^T E are as small as the element is in their direction, and known to their own
    // precision: the first as it is, the others because of the accurate product.
    Metric<D> metric;
    Mat<D>& Q = metric.directions;
    Q = frame_of(rounded);
    Mat<D> E;
    for (int i = 0; i < D; ++i) {
        E(0, i) = Q.col(0).dot(rounded[i]);
        for (int k = 1; k < D; ++k) {
            E(k, i) = accurate_dot<D>(Q.col(k), edges[i]);
        }
    }
    const Mat<D> J = from_regular(E);
    Mat<D> A = J * J.transpose(); // M^-1 in the frame Q: graded
    diagonalise<D>(A, Q);
    metric.sizes = A.diagonal().cwiseMax(0.0).cwiseSqrt();
    sort_ascending<D>(metric.sizes, Q);
    fix_signs<D>(Q);
    return metric;
}

template Metric<2> element_metric<2>(const std::array<Vec<2>, 3>&);
template Metric<3> element_metric<3>(const std::array<Vec<3>, 4>&);

} // namespace ameco
