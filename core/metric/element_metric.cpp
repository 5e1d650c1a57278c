// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/element_metric.h"

#include "core/metric/compensated.h"
#include "core/metric/symmetric_eigen.h"

namespace ameco {
namespace {

template <std::size_t D, class T>
using Row = std::array<T, D>;

/// Sizes and directions of `pack_lanes` elements.
template <std::size_t D>
struct PackMetric {
    Row<D, Pack> sizes;
    Columns<D, Pack> directions;
};

/// The longest of the vectors (the first of equals).
template <std::size_t D>
Row<D, Pack> longest(const Columns<D, Pack>& v) {
    Row<D, Pack> best = v[0];
    Pack most = dot(best, best);
    for (std::size_t i = 1; i < D; ++i) {
        const Pack square = dot(v[i], v[i]);
        const auto longer = square > most;
        most = select(longer, square, most);
        for (std::size_t k = 0; k < D; ++k) {
            best[k] = select(longer, v[i][k], best[k]);
        }
    }
    return best;
}

/// `v` to length 1, or `otherwise` where it has none.
template <std::size_t D>
Row<D, Pack> unit(const Row<D, Pack>& v, const Row<D, Pack>& otherwise) {
    const Pack norm = root(dot(v, v));
    const auto fine = norm > Pack{};
    const Pack inverse = 1.0 / norm;
    Row<D, Pack> u;
    for (std::size_t k = 0; k < D; ++k) {
        u[k] = select(fine, v[k] * inverse, otherwise[k]);
    }
    return u;
}

/// A unit vector perpendicular to the unit vector `q` (Duff et al., Building an orthonormal basis,
/// revisited, JCGT 6, 2017).
Row<3, Pack> perpendicular(const Row<3, Pack>& q) {
    const Pack sign = with_sign(pack_of(1), q[2]);
    const Pack a = -1.0 / (sign + q[2]);
    return {1.0 + sign * q[0] * q[0] * a, sign * q[0] * q[1] * a, -sign * q[0]};
}

/// v - q q^T v.
Row<3, Pack> across(const Row<3, Pack>& v, const Row<3, Pack>& q) {
    const Pack along = dot(q, v);
    return {v[0] - q[0] * along, v[1] - q[1] * along, v[2] - q[2] * along};
}

/// An orthonormal frame in which the element is as long as it is along the first column, as wide as
/// it is along the second, as flat as it is along the last (Gram-Schmidt with pivoting). It serves
/// without being accurate; it has to be orthonormal.
Columns<2, Pack> frame_of(const Columns<2, Pack>& e) {
    const Row<2, Pack> q = unit<2>(longest<2>(e), {pack_of(1), Pack{}});
    return {q, {-q[1], q[0]}};
}

Columns<3, Pack> frame_of(const Columns<3, Pack>& e) {
    const Row<3, Pack> q = unit<3>(longest<3>(e), {pack_of(1), Pack{}, Pack{}});
    // Twice is enough: after the second time the width of a needle is free of its length.
    const Row<3, Pack> wide = longest<3>({across(e[0], q), across(e[1], q), across(e[2], q)});
    const Row<3, Pack> r = unit<3>(across(wide, q), perpendicular(q));
    return {
        q, r, {q[1] * r[2] - q[2] * r[1], q[2] * r[0] - q[0] * r[2], q[0] * r[1] - q[1] * r[0]}};
}

/// One row of J = E W^-1 from that of E, with W the edge vectors of the regular simplex of edge 1.
Row<2, Pack> over_regular(const Row<2, Pack>& e) {
    constexpr double one_over_sqrt_3 = 0.57735026918962576451;
    return {e[0], (2.0 * e[1] - e[0]) * one_over_sqrt_3};
}

Row<3, Pack> over_regular(const Row<3, Pack>& e) {
    constexpr double one_over_sqrt_3 = 0.57735026918962576451;
    constexpr double one_over_sqrt_6 = 0.40824829046386301637;
    return {e[0], (2.0 * e[1] - e[0]) * one_over_sqrt_3,
            (3.0 * e[2] - (e[0] + e[1])) * one_over_sqrt_6};
}

/// \param x  corners of the elements
template <std::size_t D>
PackMetric<D> natural_metric(const std::array<Row<D, Pack>, D + 1>& x) {
    std::array<AccurateVec<D, Pack>, D> edges;
    Columns<D, Pack> rounded;
    for (std::size_t i = 0; i < D; ++i) {
        for (std::size_t k = 0; k < D; ++k) {
            edges[i].x[k] = exact_difference(x[i + 1][k], x[0][k]);
            edges[i].half[k] = halves(edges[i].x[k].value);
            rounded[i][k] = edges[i].x[k].value;
        }
    }
    PackMetric<D> metric;
    Columns<D, Pack>& Q = metric.directions;
    Q = frame_of(rounded);
    // The rows of J in this frame are as small as the element is in their direction, and known to
    // their own precision: the first as it is, the others because of the accurate product.
    std::array<Row<D, Pack>, D> J;
    for (std::size_t k = 0; k < D; ++k) {
        Row<D, Pack> e;
        std::array<TwoPart<Pack>, D> q_half;
        for (std::size_t i = 0; i < D; ++i) {
            q_half[i] = halves(Q[k][i]);
        }
        for (std::size_t i = 0; i < D; ++i) {
            e[i] = k == 0 ? dot(Q[k], rounded[i]) : accurate_dot(Q[k], q_half, edges[i]);
        }
        J[k] = over_regular(e);
    }
    Columns<D, Pack> A; // J J^T = M^-1 in the frame Q: graded
    for (std::size_t i = 0; i < D; ++i) {
        for (std::size_t j = i; j < D; ++j) {
            A[j][i] = dot(J[i], J[j]);
        }
    }
    diagonalise(A, Q);
    for (std::size_t k = 0; k < D; ++k) {
        const Pack square = select(A[k][k] > Pack{}, A[k][k], Pack{});
        metric.sizes[k] = root(square);
    }
    sort_ascending(metric.sizes, Q);
    orthonormalise(Q);
    fix_signs(Q);
    return metric;
}

template <int D>
Metric<D> lane_of(const PackMetric<D>& pack, int lane) {
    Metric<D> metric;
    for (std::size_t j = 0; j < D; ++j) {
        metric.sizes[j] = pack.sizes[j][lane];
        for (std::size_t i = 0; i < D; ++i) {
            metric.directions(i, j) = pack.directions[j][i][lane];
        }
    }
    return metric;
}

} // namespace

template <int D>
Metric<D> element_metric(const std::array<Vec<D>, D + 1>& points) {
    std::array<Row<D, Pack>, D + 1> x;
    for (std::size_t i = 0; i <= D; ++i) {
        for (std::size_t k = 0; k < D; ++k) {
            x[i][k] = pack_of(points[i][k]);
        }
    }
    return lane_of<D>(natural_metric<D>(x), 0);
}

template <int D>
void element_metrics(const Mesh<D>& mesh, ElementId first, std::span<Metric<D>> metrics) {
    for (std::size_t n = 0; n < metrics.size(); n += pack_lanes) {
        const int lanes = n + 1 < metrics.size() ? 2 : 1;
        const Simplex<D>& a = mesh.elements[ElementId(first.index() + n)];
        const Simplex<D>& b = mesh.elements[ElementId(first.index() + n + lanes - 1)];
        std::array<Row<D, Pack>, D + 1> x;
        for (std::size_t i = 0; i <= D; ++i) {
            for (std::size_t k = 0; k < D; ++k) {
                x[i][k] = Pack{mesh.points[a[i]][k], mesh.points[b[i]][k]};
            }
        }
        const PackMetric<D> pack = natural_metric<D>(x);
        for (int lane = 0; lane < lanes; ++lane) {
            metrics[n + lane] = lane_of<D>(pack, lane);
        }
    }
}

template Metric<2> element_metric<2>(const std::array<Vec<2>, 3>&);
template Metric<3> element_metric<3>(const std::array<Vec<3>, 4>&);
template void element_metrics<2>(const Mesh<2>&, ElementId, std::span<Metric<2>>);
template void element_metrics<3>(const Mesh<3>&, ElementId, std::span<Metric<3>>);

} // namespace ameco
