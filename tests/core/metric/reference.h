// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Stretched elements at random, and what to compare their metrics with; for tests and benches.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ameco::reference {

/// The edge vectors of the regular simplex of edge 1 from its first node, as columns.
template <int D>
[[nodiscard]] Mat<D> regular_edges() {
    Mat<D> W = Mat<D>::Zero();
    W.col(0)[0] = 1;
    W.col(1)[0] = 0.5;
    W.col(1)[1] = std::sqrt(0.75);
    if constexpr (D == 3) {
        W.col(2) << 0.5, std::sqrt(1.0 / 12), std::sqrt(2.0 / 3);
    }
    return W;
}

/// A rotation, uniform enough.
template <int D>
[[nodiscard]] Mat<D> random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    Mat<D> A;
    for (int i = 0; i < D * D; ++i) {
        A.data()[i] = normal(random);
    }
    Mat<D> Q = Eigen::HouseholderQR<Mat<D>>(A).householderQ();
    if (Q.determinant() < 0) {
        Q.col(0) = -Q.col(0);
    }
    return Q;
}

/// An element of about that aspect ratio, turned and placed at random near the origin: a regular
/// simplex with its edge vectors shaken by 30 %, squeezed along one or two of the axes.
template <int D>
[[nodiscard]] std::array<Vec<D>, D + 1> stretched_simplex(std::mt19937& random, double ratio) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    Vec<D> sizes = Vec<D>::Ones();
    sizes[0] = 1 / ratio;
    if constexpr (D == 3) {
        sizes[1] = std::pow(ratio, -0.5 - 0.5 * uniform(random)); // from a slab to a needle
    }
    Mat<D> edges = regular_edges<D>();
    for (int i = 0; i < D * D; ++i) {
        edges.data()[i] += 0.15 * uniform(random);
    }
    const Mat<D> turned = random_rotation<D>(random) * sizes.asDiagonal() * edges;
    std::array<Vec<D>, D + 1> points;
    for (int k = 0; k < D; ++k) {
        points[0][k] = uniform(random);
    }
    for (int i = 0; i < D; ++i) {
        points[i + 1] = points[0] + turned.col(i);
    }
    return points;
}

/// Elements with the given metrics around node 0, which lies at the origin. They overlap in space;
/// no matter.
template <int D>
[[nodiscard]] Mesh<D> star_of(const std::vector<Metric<D>>& metrics) {
    Mesh<D> mesh;
    mesh.points.push_back(Vec<D>::Zero());
    for (const Metric<D>& metric : metrics) {
        const Mat<D> edges = metric.directions * metric.sizes.asDiagonal() * regular_edges<D>();
        Simplex<D> s;
        s[0] = NodeId(0);
        for (int i = 0; i < D; ++i) {
            s[i + 1] = mesh.points.next_id();
            mesh.points.push_back(edges.col(i));
        }
        mesh.elements.push_back(s);
    }
    mesh.region.resize(mesh.elements.size(), 1);
    return mesh;
}

/// Metrics turned by up to `angle` [rad] from each other, as around a node of a curved layer.
template <int D>
[[nodiscard]] std::vector<Metric<D>> fan(std::mt19937& random, double ratio, double angle) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const Mat<D> Q = random_rotation<D>(random);
    std::vector<Metric<D>> metrics;
    for (int n = 0; n < 12; ++n) {
        const double a = angle * uniform(random);
        Mat<D> turn = Mat<D>::Identity();
        turn.template topLeftCorner<2, 2>() << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
        Metric<D> metric;
        metric.sizes = Vec<D>::Constant(1 + 0.4 * uniform(random));
        metric.sizes[0] *= (1 + 0.4 * uniform(random)) / ratio;
        metric.sizes[D - 1] *= 2;
        metric.directions = Q * turn;
        metrics.push_back(metric);
    }
    return metrics;
}

/// The corners of all elements of a mesh.
template <int D>
[[nodiscard]] std::vector<std::array<Vec<D>, D + 1>> all_corners(const Mesh<D>& mesh) {
    std::vector<std::array<Vec<D>, D + 1>> corners;
    for (const Simplex<D>& s : mesh.elements) {
        corners.push_back(corners_of<D>(mesh, s));
    }
    return corners;
}

/// The paper's equation (5) as it stands, in doubles, inverted by a stable factorisation.
template <int D>
[[nodiscard]] Mat<D> inverted_sum(const std::array<Vec<D>, D + 1>& points) {
    Mat<D> sum = Mat<D>::Zero();
    for (int a = 0; a <= D; ++a) {
        for (int b = 0; b < a; ++b) {
            const Vec<D> x = points[a] - points[b];
            sum += x * x.transpose();
        }
    }
    return (D + 1) / 2.0 * sum.ldlt().solve(Mat<D>::Identity());
}

/// Calls `body(x)` for every edge vector of an element.
template <int D, class Body>
void for_each_edge(const std::array<Vec<D>, D + 1>& points, const Body& body) {
    for (int a = 0; a <= D; ++a) {
        for (int b = 0; b < a; ++b) {
            body(Vec<D>(points[a] - points[b]));
        }
    }
}

/// Largest |x^T M x - 1| over the edges x.
template <int D>
[[nodiscard]] double residual(const Metric<D>& metric, const std::array<Vec<D>, D + 1>& points) {
    double worst = 0;
    for_each_edge<D>(points, [&](const Vec<D>& x) {
        const double l = length<D>(metric, x);
        worst = std::max(worst, std::abs(l * l - 1));
    });
    return worst;
}

/// Largest relative difference of two vectors' components; infinite where one is not a number.
template <int D>
[[nodiscard]] double relative_difference(const Vec<D>& a, const Vec<D>& b) {
    double worst = 0;
    for (int i = 0; i < D; ++i) {
        const double d = std::abs(a[i] / b[i] - 1);
        worst = std::isfinite(d) ? std::max(worst, d) : HUGE_VAL;
    }
    return worst;
}

} // namespace ameco::reference
