// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/metric_quality.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

template <int D>
Tensor<D> mean_root(const RootField<D>& root, const Simplex<D>& s) {
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
struct Inverse {
    Tensor<D> adj;
    double det;
};

Inverse<2> invert(const Tensor<2>& s) {
    return {{s[2], -s[1], s[0]}, s[0] * s[2] - s[1] * s[1]};
}

Inverse<3> invert(const Tensor<3>& s) {
    const Tensor<3> adj{s[3] * s[5] - s[4] * s[4], s[2] * s[4] - s[1] * s[5],
                        s[1] * s[4] - s[2] * s[3], s[0] * s[5] - s[2] * s[2],
                        s[1] * s[2] - s[0] * s[4], s[0] * s[3] - s[1] * s[1]};
    return {adj, s[0] * adj[0] + s[1] * adj[1] + s[2] * adj[2]};
}

/// |a e|^2 for a symmetric matrix a.
double squared_norm(const Tensor<2>& a, const Vec<2>& e) {
    const double x = a[0] * e[0] + a[1] * e[1];
    const double y = a[1] * e[0] + a[2] * e[1];
    return x * x + y * y;
}

double squared_norm(const Tensor<3>& a, const Vec<3>& e) {
    const double x = a[0] * e[0] + a[1] * e[1] + a[2] * e[2];
    const double y = a[1] * e[0] + a[3] * e[1] + a[4] * e[2];
    const double z = a[2] * e[0] + a[4] * e[1] + a[5] * e[2];
    return x * x + y * y + z * z;
}

double edge_determinant(const std::array<Vec<2>, 3>& x) {
    const Vec<2> a = x[1] - x[0], b = x[2] - x[0];
    return a[0] * b[1] - a[1] * b[0];
}

double edge_determinant(const std::array<Vec<3>, 4>& x) {
    const Vec<3> a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Squares of the edges' lengths and the volume over the regular simplex's, in the metric S^-2.
template <int D>
struct Measures {
    std::array<double, SimplexNumbering<D>::edge_count> squares;
    double volume = 0;
    double h2 = 0; ///< mean square length (18)
};

template <int D>
Measures<D> measure(const std::array<Vec<D>, D + 1>& x, const Tensor<D>& s) {
    const Inverse<D> inverse = invert(s);
    const double det = inverse.det;
    Measures<D> m;
    double sum = 0;
    int k = 0;
    for (const auto& [i, j] : SimplexNumbering<D>::edges) {
        m.squares[k] = squared_norm(inverse.adj, x[j] - x[i]);
        sum += m.squares[k];
        m.squares[k++] /= det * det;
    }
    m.h2 = sum / (det * det) / SimplexNumbering<D>::edge_count;
    const double regular = D == 2 ? std::sqrt(3.0) / 2 : std::sqrt(0.5);
    m.volume = edge_determinant(x) / (det * regular);
    return m;
}

/// h_M^D.
template <int D>
double rms_power(const Measures<D>& m) {
    return D == 2 ? m.h2 : m.h2 * std::sqrt(m.h2);
}

template <int D>
double shape_quality(const Measures<D>& m) {
    return std::max(0.0, m.volume / rms_power(m));
}

template <int D>
double original_quality(const Measures<D>& m) {
    const double h_d = rms_power(m);
    const double size = std::min(h_d, 1 / h_d);
    return std::max(0.0, m.volume / h_d * size);
}

template <int D>
double modified_quality(const Measures<D>& m) {
    double worst = 1;
    for (const double square : m.squares) {
        worst = std::min({worst, square, 1 / square});
    }
    const double sizes = D == 2 ? worst : worst * std::sqrt(worst);
    const double volume = std::min(m.volume, 1 / m.volume);
    return shape_quality(m) * sizes * std::max(0.0, volume);
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
Tensor<D> root_of(const Metric<D>& m) {
    const Mat<D> s = m.directions * m.sizes.asDiagonal() * m.directions.transpose();
    Tensor<D> tensor;
    int k = 0;
    for (int r = 0; r < D; ++r) {
        for (int c = r; c < D; ++c) {
            tensor[k++] = s(r, c);
        }
    }
    return tensor;
}

template <int D>
RootField<D> make_root_field(const MetricField<D>& target) {
    RootField<D> root(target.size());
    parallel_for(target.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            root[NodeId(i)] = root_of<D>(target[NodeId(i)]);
        }
    });
    return root;
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
    const Measures<D> m = measure<D>(x, mean);
    return {original_quality(m), modified_quality(m)};
}

template <int D>
double metric_quality(const EditMesh<D>& mesh, const RootField<D>& root, const Simplex<D>& element,
                      Quality quality) {
    std::array<Vec<D>, D + 1> x;
    for (int i = 0; i <= D; ++i) {
        x[i] = mesh.point(element[i]);
    }
    if (edge_determinant(x) <= 0) {
        return 0; // no quality is more; half of the elements that swaps propose are such
    }
    const Measures<D> m = measure<D>(x, mean_root<D>(root, element));
    switch (quality) {
    case Quality::shape:
        return shape_quality(m);
    case Quality::original:
        return original_quality(m);
    case Quality::modified:
        break;
    }
    return modified_quality(m);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template Tensor<D> root_of(const Metric<D>&);                                                  \
    template RootField<D> make_root_field(const MetricField<D>&);                                  \
    template MetricQualities metric_qualities(const std::array<Vec<D>, D + 1>&,                    \
                                              const std::array<Metric<D>, D + 1>&);                \
    template double metric_quality(const EditMesh<D>&, const RootField<D>&, const Simplex<D>&,     \
                                   Quality);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
