// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/conformity.h"

#include "core/base/parallel.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/simplex.h"
#include "core/metric/edge_length.h"
#include "core/metric/element_measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace ameco {

namespace {

// Lengths and volume are those of the edges X = S^-1 E. Cholesky's factors keep more digits of
// S^-1 than `invert` at aspect ratios of 1e6, which a measure that is reported should have.
template <int D>
double shape_quality_in(const Mesh<D>& mesh, const Tensor<D>& mean, const Simplex<D>& s) {
    Mat<D> edges, root;
    int k = 0;
    for (int i = 0; i < D; ++i) {
        edges.col(i) = mesh.points[s[i + 1]] - mesh.points[s[0]];
        for (int j = i; j < D; ++j) {
            root(i, j) = root(j, i) = mean[k++];
        }
    }
    const Eigen::LLT<Mat<D>> cholesky(root);
    Mat<D> X;
    for (int i = 0; i < D; ++i) { // column by column Eigen unrolls it
        const Vec<D> half = cholesky.matrixL().solve(edges.col(i));
        X.col(i) = cholesky.matrixU().solve(half);
    }
    double squares = X.squaredNorm();
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < i; ++j) {
            squares += (X.col(i) - X.col(j)).squaredNorm();
        }
    }
    const double mean_square = squares / (D * (D + 1) / 2);
    const double rms_power = D == 2 ? mean_square : mean_square * std::sqrt(mean_square);
    const double q = X.determinant() / (regular_determinant<D>() * rms_power);
    return std::min(q, 1.0); // the regular simplex may come out above by rounding
}

} // namespace

template <int D>
double shape_quality(const Mesh<D>& mesh, const MetricField<D>& field, const Simplex<D>& s) {
    Tensor<D> mean{};
    for (const NodeId v : s) {
        const Tensor<D> root = root_of<D>(field[v]);
        for (int k = 0; k < tensor_size<D>; ++k) {
            mean[k] += root[k] / (D + 1);
        }
    }
    return shape_quality_in(mesh, mean, s);
}

namespace {

constexpr std::size_t piece_size = 4096;

/// What one piece of a loop has counted; pieces are joined in their order.
struct Count {
    std::int64_t edges = 0;
    std::int64_t in_band = 0;
    std::int64_t below_half = 0;
    std::int64_t above_two = 0;
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0;
    double quality = 0;
    double worst_quality = 1;

    void add_length(double l) {
        ++edges;
        in_band += l >= std::sqrt(0.5) && l <= std::sqrt(2.0) ? 1 : 0;
        below_half += l < 0.5 ? 1 : 0;
        above_two += l > 2 ? 1 : 0;
        shortest = std::min(shortest, l);
        longest = std::max(longest, l);
    }
    void add_quality(double q) {
        quality += q;
        worst_quality = std::min(worst_quality, q);
    }
    void add(const Count& c) {
        edges += c.edges;
        in_band += c.in_band;
        below_half += c.below_half;
        above_two += c.above_two;
        shortest = std::min(shortest, c.shortest);
        longest = std::max(longest, c.longest);
        quality += c.quality;
        worst_quality = std::min(worst_quality, c.worst_quality);
    }
};

/// The same for classes.
struct ClassCount : ConformityClasses {
    void add_length(double l) {
        const double k = std::floor(4 * std::log2(l)) + length_classes / 2;
        ++length[static_cast<std::size_t>(std::clamp(k, 0.0, length_classes - 1.0))];
    }
    void add_quality(double q) {
        const double k = std::floor(q * quality_classes);
        ++quality[static_cast<std::size_t>(std::clamp(k, 0.0, quality_classes - 1.0))];
    }
    void add(const ClassCount& c) {
        std::transform(quality.begin(), quality.end(), c.quality.begin(), quality.begin(),
                       std::plus<>());
        std::transform(length.begin(), length.end(), c.length.begin(), length.begin(),
                       std::plus<>());
    }
};

/// Runs `body(begin, end, count)` on the pieces of [0, n) and joins what they counted.
template <class Counts, class Body>
Counts count_pieces(std::size_t n, const Body& body) {
    std::vector<Counts> pieces((n + piece_size - 1) / piece_size);
    parallel_for(n, piece_size, [&](std::size_t begin, std::size_t end) {
        body(begin, end, pieces[begin / piece_size]);
    });
    Counts all;
    for (const Counts& piece : pieces) {
        all.add(piece);
    }
    return all;
}

/// Length of a vector in a metric: |F e|, the factor made once per node for all its edges.
template <int D, class Counts>
void add_lengths(const Mesh<D>& mesh, const MetricField<D>& field, NodeId i,
                 std::span<const NodeId> neighbours, Counts& count) {
    const Mat<D> F = length_factor<D>(field[i]);
    for (const NodeId j : neighbours) {
        if (i < j) {
            const Vec<D> e = mesh.points[j] - mesh.points[i];
            count.add_length(edge_length((F * e).norm(), length<D>(field[j], e)));
        }
    }
}

template <int D, class Counts>
Counts count_lengths(const Mesh<D>& mesh, const MetricField<D>& field) {
    const NodeNodes neighbours = node_neighbours(mesh);
    return count_pieces<Counts>(
        mesh.points.size(), [&](std::size_t begin, std::size_t end, Counts& count) {
            for (std::size_t i = begin; i < end; ++i) {
                add_lengths(mesh, field, NodeId(i), neighbours[NodeId(i)], count);
            }
        });
}

template <int D, class Counts>
Counts count_shapes(const Mesh<D>& mesh, const MetricField<D>& field) {
    const RootField<D> root = make_root_field(field);
    return count_pieces<Counts>(
        mesh.elements.size(), [&](std::size_t begin, std::size_t end, Counts& count) {
            for (std::size_t e = begin; e < end; ++e) {
                const Simplex<D>& s = mesh.elements[ElementId(e)];
                count.add_quality(shape_quality_in(mesh, mean_root<D>(root, s), s));
            }
        });
}

} // namespace

template <int D>
Conformity conformity(const Mesh<D>& mesh, const MetricField<D>& field) {
    const Count lengths = count_lengths<D, Count>(mesh, field);
    const Count shapes = count_shapes<D, Count>(mesh, field);
    Conformity result;
    result.edges = lengths.edges;
    if (lengths.edges > 0) {
        const auto n = static_cast<double>(lengths.edges);
        result.in_band = static_cast<double>(lengths.in_band) / n;
        result.below_half = static_cast<double>(lengths.below_half) / n;
        result.above_two = static_cast<double>(lengths.above_two) / n;
        result.shortest = lengths.shortest;
        result.longest = lengths.longest;
        result.mean_quality = shapes.quality / static_cast<double>(mesh.elements.size());
        result.worst_quality = shapes.worst_quality;
    }
    return result;
}

template <int D>
ConformityClasses classify_conformity(const Mesh<D>& mesh, const MetricField<D>& field) {
    ConformityClasses classes = count_lengths<D, ClassCount>(mesh, field);
    classes.quality = count_shapes<D, ClassCount>(mesh, field).quality;
    return classes;
}

template double shape_quality(const Mesh<2>&, const MetricField<2>&, const Simplex<2>&);
template double shape_quality(const Mesh<3>&, const MetricField<3>&, const Simplex<3>&);
template Conformity conformity<2>(const Mesh<2>&, const MetricField<2>&);
template Conformity conformity<3>(const Mesh<3>&, const MetricField<3>&);
template ConformityClasses classify_conformity(const Mesh<2>&, const MetricField<2>&);
template ConformityClasses classify_conformity(const Mesh<3>&, const MetricField<3>&);

} // namespace ameco
