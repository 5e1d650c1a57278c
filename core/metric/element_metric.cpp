// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/element_metric.h"

#include "core/metric/compensated.h"
#include "core/metric/symmetric_eigen.h"

#include <algorithm>

namespace ameco {
namespace {

// T is double for one element or Pack for several side by side.

template <std::size_t D, class T>
using Row = std::array<T, D>;

template <std::size_t D, class T>
struct SizesAndDirections {
    Row<D, T> sizes;
    Columns<D, T> directions;
};

/// The longest of the vectors (the first of equals).
template <std::size_t D, class T>
Row<D, T> longest(const Columns<D, T>& v) {
    Row<D, T> best = v[0];
    T most = dot(best, best);
    for (std::size_t i = 1; i < D; ++i) {
        const T square = dot(v[i], v[i]);
        const auto longer = square > most;
        most = select(longer, square, most);
        for (std::size_t k = 0; k < D; ++k) {
            best[k] = select(longer, v[i][k], best[k]);
        }
    }
    return best;
}

/// `v` to length 1, or `otherwise` where it has none.
template <std::size_t D, class T>
Row<D, T> unit(const Row<D, T>& v, const Row<D, T>& otherwise) {
    const T norm = root(dot(v, v));
    const auto fine = norm > T{};
    const T inverse = 1.0 / norm;
    Row<D, T> u;
    for (std::size_t k = 0; k < D; ++k) {
        u[k] = select(fine, v[k] * inverse, otherwise[k]);
    }
    return u;
}

/// A unit vector perpendicular to the unit vector `q` (Duff et al., Building an orthonormal basis,
/// revisited, JCGT 6, 2017).
template <class T>
Row<3, T> perpendicular(const Row<3, T>& q) {
    const T sign = with_sign(T(1), q[2]);
    const T a = -1.0 / (sign + q[2]);
    return {1.0 + sign * q[0] * q[0] * a, sign * q[0] * q[1] * a, -sign * q[0]};
}

/// v - q q^T v.
template <class T>
Row<3, T> across(const Row<3, T>& v, const Row<3, T>& q) {
    const T along = dot(q, v);
    return {v[0] - q[0] * along, v[1] - q[1] * along, v[2] - q[2] * along};
}

/// An orthonormal frame in which the element is as long as it is along the first column, as wide as
/// it is along the second, as flat as it is along the last (Gram-Schmidt with pivoting). It serves
/// without being accurate; it has to be orthonormal.
template <class T>
Columns<2, T> frame_of(const Columns<2, T>& e) {
    const Row<2, T> q = unit<2, T>(longest(e), {T(1), T{}});
    return {q, {-q[1], q[0]}};
}

template <class T>
Columns<3, T> frame_of(const Columns<3, T>& e) {
    const Row<3, T> q = unit<3, T>(longest(e), {T(1), T{}, T{}});
    // Twice is enough: after the second time the width of a needle is free of its length.
    const Row<3, T> wide = longest<3, T>({across(e[0], q), across(e[1], q), across(e[2], q)});
    const Row<3, T> r = unit(across(wide, q), perpendicular(q));
    return {
        q, r, {q[1] * r[2] - q[2] * r[1], q[2] * r[0] - q[0] * r[2], q[0] * r[1] - q[1] * r[0]}};
}

/// One row of J = E W^-1 from that of E, with W the edge vectors of the regular simplex of edge 1.
template <std::size_t D, class T>
Row<D, T> over_regular(const Row<D, T>& e) {
    constexpr double one_over_sqrt_3 = 0.57735026918962576451;
    constexpr double one_over_sqrt_6 = 0.40824829046386301637;
    Row<D, T> j;
    j[0] = e[0];
    j[1] = (2.0 * e[1] - e[0]) * one_over_sqrt_3;
    if constexpr (D == 3) {
        j[2] = (3.0 * e[2] - (e[0] + e[1])) * one_over_sqrt_6;
    }
    return j;
}

/// M^-1 = J J^T in the orthonormal frame Q, upper triangle, and Q in `directions`.
///
/// The frame follows the element, so the rows of J are as small as the element is in their
/// direction and have to be known to their own precision: the first as it is, the others because
/// edges and products are taken to twice the digits.
template <std::size_t D, class T>
Columns<D, T> graded_inverse(const std::array<Row<D, T>, D + 1>& x, Columns<D, T>& Q) {
    std::array<AccurateVec<D, T>, D> edges;
    Columns<D, T> rounded;
    for (std::size_t i = 0; i < D; ++i) {
        for (std::size_t k = 0; k < D; ++k) {
            edges[i].x[k] = exact_difference(x[i + 1][k], x[0][k]);
            edges[i].half[k] = halves(edges[i].x[k].value);
            rounded[i][k] = edges[i].x[k].value;
        }
    }
    Q = frame_of(rounded);
    std::array<Row<D, T>, D> J;
    Row<D, T> e;
    for (std::size_t i = 0; i < D; ++i) {
        e[i] = dot(Q[0], rounded[i]);
    }
    J[0] = over_regular(e);
    for (std::size_t k = 1; k < D; ++k) {
        std::array<TwoPart<T>, D> q_half;
        for (std::size_t i = 0; i < D; ++i) {
            q_half[i] = halves(Q[k][i]);
        }
        for (std::size_t i = 0; i < D; ++i) {
            e[i] = accurate_dot(Q[k], q_half, edges[i]);
        }
        J[k] = over_regular(e);
    }
    Columns<D, T> A;
    for (std::size_t i = 0; i < D; ++i) {
        for (std::size_t j = i; j < D; ++j) {
            A[j][i] = dot(J[i], J[j]);
        }
    }
    return A;
}

/// The natural metric of the element with corners `x`.
template <std::size_t D, class T>
SizesAndDirections<D, T> natural_metric(const std::array<Row<D, T>, D + 1>& x) {
    SizesAndDirections<D, T> metric;
    Columns<D, T>& Q = metric.directions;
    Columns<D, T> A = graded_inverse(x, Q);
    diagonalise(A, Q);
    for (std::size_t k = 0; k < D; ++k) {
        metric.sizes[k] = root(select(A[k][k] > T{}, A[k][k], T{}));
    }
    sort_ascending(metric.sizes, Q);
    orthonormalise(Q);
    fix_signs(Q);
    return metric;
}

template <int D, class IdOf>
void natural_metrics(const Mesh<D>& mesh, const IdOf& id_of, std::span<Metric<D>> metrics) {
    for (std::size_t n = 0; n < metrics.size(); n += pack_lanes) {
        const std::size_t lanes = std::min(pack_lanes, metrics.size() - n);
        std::array<Row<D, Pack>, D + 1> x;
        for (std::size_t lane = 0; lane < pack_lanes; ++lane) {
            const ElementId e = id_of(n + std::min(lane, lanes - 1));
            for (std::size_t i = 0; i <= D; ++i) {
                for (std::size_t k = 0; k < D; ++k) {
                    x[i][k].set_lane(lane, mesh.points[mesh.elements[e][i]][k]);
                }
            }
        }
        const SizesAndDirections<D, Pack> natural = natural_metric(x);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            Metric<D>& metric = metrics[n + lane];
            for (std::size_t j = 0; j < D; ++j) {
                metric.sizes[j] = natural.sizes[j].lane(lane);
                for (std::size_t i = 0; i < D; ++i) {
                    metric.directions(i, j) = natural.directions[j][i].lane(lane);
                }
            }
        }
    }
}

} // namespace

template <int D>
Metric<D> element_metric(const std::array<Vec<D>, D + 1>& points) {
    std::array<Row<D, double>, D + 1> x;
    for (std::size_t i = 0; i <= D; ++i) {
        for (std::size_t k = 0; k < D; ++k) {
            x[i][k] = points[i][k];
        }
    }
    const SizesAndDirections<D, double> natural = natural_metric(x);
    Metric<D> metric;
    for (std::size_t j = 0; j < D; ++j) {
        metric.sizes[j] = natural.sizes[j];
        for (std::size_t i = 0; i < D; ++i) {
            metric.directions(i, j) = natural.directions[j][i];
        }
    }
    return metric;
}

template <int D>
void element_metrics(const Mesh<D>& mesh, ElementId first, std::span<Metric<D>> metrics) {
    natural_metrics<D>(
        mesh, [&](std::size_t n) { return ElementId(first.index() + n); }, metrics);
}

template <int D>
void element_metrics(const Mesh<D>& mesh, std::span<const ElementId> elements,
                     std::span<Metric<D>> metrics) {
    natural_metrics<D>(
        mesh, [&](std::size_t n) { return elements[n]; }, metrics);
}

template Metric<2> element_metric<2>(const std::array<Vec<2>, 3>&);
template Metric<3> element_metric<3>(const std::array<Vec<3>, 4>&);
template void element_metrics<2>(const Mesh<2>&, ElementId, std::span<Metric<2>>);
template void element_metrics<3>(const Mesh<3>&, ElementId, std::span<Metric<3>>);
template void element_metrics<2>(const Mesh<2>&, std::span<const ElementId>, std::span<Metric<2>>);
template void element_metrics<3>(const Mesh<3>&, std::span<const ElementId>, std::span<Metric<3>>);

} // namespace ameco
