// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Edge lengths and volume of an element in the metric of its nodes, without an eigenproblem.
#pragma once

#include "core/mesh/simplex.h"
#include "core/metric/metric.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ameco {

/// S = M^(-1/2) at every node, components as in Tensor [L]: what the metric of an element is the
/// mean of.
template <int D>
using RootField = IdVector<NodeId, Tensor<D>>;

/// S = V diag(h) V^T of one metric, upper triangle by rows [L].
template <int D>
[[nodiscard]] Tensor<D> root_of(const Metric<D>& metric);

template <int D>
[[nodiscard]] RootField<D> make_root_field(const MetricField<D>& field);

/// Mean of S over an element's nodes.
template <int D>
[[nodiscard]] Tensor<D> mean_root(const RootField<D>& root, const Simplex<D>& s) {
    Tensor<D> m{};
    for (const NodeId v : s) {
        for (int i = 0; i < tensor_size<D>; ++i) {
            m[i] += root[v][i];
        }
    }
    for (double& x : m) {
        x /= D + 1;
    }
    return m;
}

/// S^-1 = adj / det of a symmetric matrix.
template <int D>
struct SymmetricInverse {
    Tensor<D> adj;
    double det;
};

[[nodiscard]] inline SymmetricInverse<2> invert(const Tensor<2>& s) {
    return {{s[2], -s[1], s[0]}, s[0] * s[2] - s[1] * s[1]};
}

[[nodiscard]] inline SymmetricInverse<3> invert(const Tensor<3>& s) {
    const Tensor<3> adj{s[3] * s[5] - s[4] * s[4], s[2] * s[4] - s[1] * s[5],
                        s[1] * s[4] - s[2] * s[3], s[0] * s[5] - s[2] * s[2],
                        s[1] * s[2] - s[0] * s[4], s[0] * s[3] - s[1] * s[1]};
    return {adj, s[0] * adj[0] + s[1] * adj[1] + s[2] * adj[2]};
}

/// |a e|^2 for a symmetric matrix a.
[[nodiscard]] inline double squared_norm(const Tensor<2>& a, const Vec<2>& e) {
    const double x = a[0] * e[0] + a[1] * e[1];
    const double y = a[1] * e[0] + a[2] * e[1];
    return x * x + y * y;
}

[[nodiscard]] inline double squared_norm(const Tensor<3>& a, const Vec<3>& e) {
    const double x = a[0] * e[0] + a[1] * e[1] + a[2] * e[2];
    const double y = a[1] * e[0] + a[3] * e[1] + a[4] * e[2];
    const double z = a[2] * e[0] + a[4] * e[1] + a[5] * e[2];
    return x * x + y * y + z * z;
}

/// D! times the signed volume, as rounded.
[[nodiscard]] inline double edge_determinant(const std::array<Vec<2>, 3>& x) {
    const Vec<2> a = x[1] - x[0], b = x[2] - x[0];
    return a[0] * b[1] - a[1] * b[0];
}

[[nodiscard]] inline double edge_determinant(const std::array<Vec<3>, 4>& x) {
    const Vec<3> a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// D! times the volume of the regular simplex with edges of length 1.
template <int D>
[[nodiscard]] double regular_determinant() {
    return D == 2 ? std::sqrt(3.0) / 2 : std::sqrt(0.5);
}

/// Squares of the edges' lengths, and the volume over the regular simplex's, in a metric S^-2.
template <int D>
struct ElementMeasures {
    std::array<double, SimplexNumbering<D>::edge_count> squares;
    double volume = 0;
    double h2 = 0; ///< mean square length (18)
};

/// h_M^2 (18).
/// \param x        corners
/// \param inverse  of S
template <int D>
[[nodiscard]] double mean_square_length(const std::array<Vec<D>, D + 1>& x,
                                        const SymmetricInverse<D>& inverse) {
    double sum = 0;
    for (const auto& [i, j] : SimplexNumbering<D>::edges) {
        sum += squared_norm(inverse.adj, x[j] - x[i]);
    }
    return sum / (inverse.det * inverse.det) / SimplexNumbering<D>::edge_count;
}

/// \param x        corners
/// \param inverse  of S
template <int D>
[[nodiscard]] ElementMeasures<D> element_measures(const std::array<Vec<D>, D + 1>& x,
                                                  const SymmetricInverse<D>& inverse) {
    const double det = inverse.det;
    ElementMeasures<D> m;
    double sum = 0;
    int k = 0;
    for (const auto& [i, j] : SimplexNumbering<D>::edges) {
        m.squares[k] = squared_norm(inverse.adj, x[j] - x[i]);
        sum += m.squares[k];
        m.squares[k++] /= det * det;
    }
    m.h2 = sum / (det * det) / SimplexNumbering<D>::edge_count;
    m.volume = edge_determinant(x) / (det * regular_determinant<D>());
    return m;
}

/// h_M^D.
template <int D>
[[nodiscard]] double rms_power(const ElementMeasures<D>& m) {
    return D == 2 ? m.h2 : m.h2 * std::sqrt(m.h2);
}

/// Q_F of (17).
template <int D>
[[nodiscard]] double shape_quality(const ElementMeasures<D>& m) {
    return std::max(0.0, m.volume / rms_power(m));
}

} // namespace ameco
