// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/geodesic.h"

#include "core/metric/graded_svd.h"

#include <cmath>

namespace ameco {
namespace {

/// V diag(values) V^T.
template <int D>
Mat<D> composed(const std::array<double, D>& values, const Columns<D, double>& V) {
    Mat<D> A = Mat<D>::Zero();
    for (int k = 0; k < D; ++k) {
        const Eigen::Map<const Vec<D>> v(V[k].data());
        A += values[k] * v * v.transpose();
    }
    return A;
}

/// G = F^-1 = V diag(h), M^-1 = G G^T.
template <int D>
Mat<D> size_factor(const Metric<D>& metric) {
    return metric.directions * metric.sizes.asDiagonal();
}

/// The eigenvalues of M^-1 N, and the vectors that diagonalise it, in the frame of `base`.
template <int D>
LeftSingular<D> relative(const Metric<D>& base, const Metric<D>& other) {
    // Of the angles first, then of the sizes: the products of small and large numbers come last.
    const Mat<D> angles = base.directions.transpose() * other.directions;
    return left_singular<D>(base.sizes.asDiagonal() * angles *
                            other.sizes.cwiseInverse().asDiagonal());
}

} // namespace

template <int D>
Tangent<D> to_tangent(const Metric<D>& base, const Mat<D>& W) {
    const Mat<D> G = size_factor(base);
    return {G.transpose() * W * G};
}

template <int D>
Mat<D> to_matrix(const Metric<D>& base, const Tangent<D>& tangent) {
    const Mat<D> F = length_factor(base);
    return F.transpose() * tangent.X * F;
}

template <int D>
Tangent<D> log_map(const Metric<D>& base, const Metric<D>& other) {
    LeftSingular<D> r = relative(base, other);
    for (double& square : r.squares) {
        square = std::log(square);
    }
    return {composed<D>(r.squares, r.vectors)};
}

template <int D>
Metric<D> exp_map(const Metric<D>& base, const Tangent<D>& tangent) {
    Columns<D, double> X{};
    for (int j = 0; j < D; ++j) {
        for (int i = 0; i <= j; ++i) {
            X[j][i] = tangent.X(i, j);
        }
    }
    Columns<D, double> Q = identity<D>();
    diagonalise(X, Q);
    // The inverse of the result is Y Y^T in the frame of `base`.
    Mat<D> Y;
    for (int j = 0; j < D; ++j) {
        const double scale = std::exp(-X[j][j] / 2);
        for (int i = 0; i < D; ++i) {
            Y(i, j) = base.sizes[i] * Q[j][i] * scale;
        }
    }
    const LeftSingular<D> r = left_singular<D>(Y);
    std::array<double, D> sizes;
    Columns<D, double> V;
    for (int k = 0; k < D; ++k) {
        sizes[k] = std::sqrt(r.squares[k]);
        Eigen::Map<Vec<D>>(V[k].data()) =
            base.directions * Eigen::Map<const Vec<D>>(r.vectors[k].data());
    }
    return metric_from<D>(sizes, V);
}

template <int D>
Metric<D> geodesic(const Metric<D>& a, const Metric<D>& b, double t) {
    return exp_map(a, Tangent<D>{t * log_map(a, b).X});
}

template <int D>
double invariant_distance(const Metric<D>& a, const Metric<D>& b) {
    double sum = 0;
    for (const double square : relative(a, b).squares) {
        const double l = std::log(square);
        sum += l * l;
    }
    return std::sqrt(sum);
}

template <int D>
Metric<D> inverse(const Metric<D>& metric) {
    std::array<double, D> sizes;
    Columns<D, double> V;
    for (int k = 0; k < D; ++k) {
        sizes[k] = 1 / metric.sizes[k];
        Eigen::Map<Vec<D>>(V[k].data()) = metric.directions.col(k);
    }
    return metric_from<D>(sizes, V);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template Tangent<D> to_tangent(const Metric<D>&, const Mat<D>&);                               \
    template Mat<D> to_matrix(const Metric<D>&, const Tangent<D>&);                                \
    template Tangent<D> log_map(const Metric<D>&, const Metric<D>&);                               \
    template Metric<D> exp_map(const Metric<D>&, const Tangent<D>&);                               \
    template Metric<D> geodesic(const Metric<D>&, const Metric<D>&, double);                       \
    template double invariant_distance(const Metric<D>&, const Metric<D>&);                        \
    template Metric<D> inverse(const Metric<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
