// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/metric_quality.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

/// Q_F Q_S = V / h_M^D min(h_M^D, h_M^-D).
/// \param h2  h_M^2
template <int D>
double original_quality(double volume, double h2) {
    return std::max(0.0, h2 <= 1 ? volume : volume / (D == 2 ? h2 * h2 : h2 * h2 * h2));
}

template <int D>
double modified_quality(const ElementMeasures<D>& m) {
    double worst = 1;
    for (const double square : m.squares) {
        worst = std::min({worst, square, 1 / square});
    }
    const double sizes = D == 2 ? worst : worst * std::sqrt(worst);
    const double volume = std::min(m.volume, 1 / m.volume);
    return shape_quality(m) * sizes * std::max(0.0, volume);
}

/// Squares of all edges of a simplex that has the edges a, b (, c) at a corner, each times a
/// symmetric matrix, added up: D + 1 times those at the corner less the square of their sum. In
/// plain numbers: vectors would go through memory.
double sum_of_squares(const Tensor<2>& m, const std::array<Vec<2>, 3>& x) {
    double squares = 0, sum_x = 0, sum_y = 0;
    for (std::size_t i = 1; i <= 2; ++i) {
        const double ex = x[i][0] - x[0][0], ey = x[i][1] - x[0][1];
        const double px = m[0] * ex + m[1] * ey;
        const double py = m[1] * ex + m[2] * ey;
        squares += px * px + py * py;
        sum_x += px;
        sum_y += py;
    }
    return 3 * squares - (sum_x * sum_x + sum_y * sum_y);
}

double sum_of_squares(const Tensor<3>& m, const std::array<Vec<3>, 4>& x) {
    double squares = 0, sum_x = 0, sum_y = 0, sum_z = 0;
    for (std::size_t i = 1; i <= 3; ++i) {
        const double ex = x[i][0] - x[0][0], ey = x[i][1] - x[0][1], ez = x[i][2] - x[0][2];
        const double px = m[0] * ex + m[1] * ey + m[2] * ez;
        const double py = m[1] * ex + m[3] * ey + m[4] * ez;
        const double pz = m[2] * ex + m[4] * ey + m[5] * ez;
        squares += px * px + py * py + pz * pz;
        sum_x += px;
        sum_y += py;
        sum_z += pz;
    }
    return 4 * squares - (sum_x * sum_x + sum_y * sum_y + sum_z * sum_z);
}

/// Q_F of (17) in a metric S^-2, from the corners and D! times the volume. The shape has no size:
/// any multiple of S will do, and of the factors 1 / det S in lengths and volume, D - 1 are left.
template <int D>
double shape_quality_in(const Tensor<D>& root, const std::array<Vec<D>, D + 1>& x,
                        double determinant) {
    const SymmetricInverse<D> inverse = invert(root);
    const double det = inverse.det;
    const double squares = sum_of_squares(inverse.adj, x);
    constexpr double n = SimplexNumbering<D>::edge_count; // h_M^2 = squares / n
    if constexpr (D == 2) {
        return n / regular_determinant<D>() * (determinant * det) / squares;
    } else {
        const double factor = n * std::sqrt(n) / regular_determinant<D>();
        return factor * (determinant * det * det) / (squares * std::sqrt(squares));
    }
}

template <int D>
Tensor<D> sum_of_roots(const RootField<D>& root, const Simplex<D>& s) {
    Tensor<D> sum = root[s[0]];
    for (int i = 1; i <= D; ++i) {
        for (int k = 0; k < tensor_size<D>; ++k) {
            sum[k] += root[s[i]][k];
        }
    }
    return sum;
}

} // namespace

std::string_view name(Quality quality) {
    switch (quality) {
    case Quality::shape:
        return "shape";
    case Quality::original:
        return "original";
    case Quality::modified:
        break;
    }
    return "modified";
}

std::optional<Quality> quality_from_name(std::string_view text) {
    for (const Quality quality : all_qualities) {
        if (name(quality) == text) {
            return quality;
        }
    }
    return {};
}

template <int D>
MetricQualities metric_qualities(const std::array<Vec<D>, D + 1>& x,
                                 const std::array<Metric<D>, D + 1>& natural) {
    Tensor<D> mean{};
    for (const Metric<D>& metric : natural) {
        const Tensor<D> root = root_of<D>(metric);
        for (int k = 0; k < tensor_size<D>; ++k) {
            mean[k] += root[k] / (D + 1);
        }
    }
    const ElementMeasures<D> m = element_measures<D>(x, invert(mean));
    return {original_quality<D>(m.volume, m.h2), modified_quality(m)};
}

template <int D>
double metric_quality(const EditMesh<D>& mesh, const RootField<D>& root, const Simplex<D>& element,
                      Quality quality) {
    const auto x = corners_of(mesh, element);
    const double determinant = edge_determinant(x);
    if (determinant <= 0) {
        return 0;
    }
    if (quality == Quality::shape) {
        return shape_quality_in<D>(sum_of_roots<D>(root, element), x, determinant);
    }
    const ElementMeasures<D> m = element_measures<D>(x, invert(mean_root<D>(root, element)));
    return quality == Quality::original ? original_quality<D>(m.volume, m.h2) : modified_quality(m);
}

template <int D>
double metric_quality_above(const EditMesh<D>& mesh, const RootField<D>& root,
                            const Simplex<D>& element, double least) {
    const auto x = corners_of(mesh, element);
    const double determinant = edge_determinant(x);
    if (determinant <= 0) {
        return 0;
    }
    // Of equal volume the regular simplex has the shortest edges: Q_F Q_S is at most the volume.
    const SymmetricInverse<D> inverse = invert(mean_root<D>(root, element));
    const double volume = determinant / (inverse.det * regular_determinant<D>());
    if (volume <= least) {
        return volume;
    }
    return original_quality<D>(volume, mean_square_length<D>(x, inverse));
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template MetricQualities metric_qualities(const std::array<Vec<D>, D + 1>&,                    \
                                              const std::array<Metric<D>, D + 1>&);                \
    template double metric_quality(const EditMesh<D>&, const RootField<D>&, const Simplex<D>&,     \
                                   Quality);                                                       \
    template double metric_quality_above(const EditMesh<D>&, const RootField<D>&,                  \
                                         const Simplex<D>&, double);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
