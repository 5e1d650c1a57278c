// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Numbering inside a simplex.
///
///     3-D, positive volume:              2-D, counter-clockwise:
///
///          3                                  2
///         /|\                                / \                                                .
///        / | \         face i lies           /   \        face i lies
///       0--|--2        opposite node i      0-----1       opposite node i
///        \ | /
///          1
///
/// The facets returned here have normals that point out of the simplex.
#pragma once

#include "core/geometry/predicates.h"
#include "core/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace ameco {

template <int D>
struct SimplexNumbering;

template <>
struct SimplexNumbering<2> {
    static constexpr int edge_count = 3;
    static constexpr std::array<std::array<int, 2>, 3> edges{{{0, 1}, {1, 2}, {2, 0}}};
    static constexpr std::array<std::array<int, 2>, 3> facets{{{1, 2}, {2, 0}, {0, 1}}};
};

template <>
struct SimplexNumbering<3> {
    static constexpr int edge_count = 6;
    static constexpr std::array<std::array<int, 2>, 6> edges{
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
    static constexpr std::array<std::array<int, 3>, 4> facets{
        {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
};

/// Facet `i` of a simplex (the one opposite its node `i`), normal outwards.
template <int D>
[[nodiscard]] Facet<D> facet_of(const Simplex<D>& s, int i) {
    Facet<D> f;
    for (int k = 0; k < D; ++k) {
        f[k] = s[SimplexNumbering<D>::facets[i][k]];
    }
    return f;
}

/// Sign of an element's volume, exact: +1 for the numbering drawn above.
template <int D>
[[nodiscard]] int orientation(const Mesh<D>& mesh, const Simplex<D>& s) {
    return std::apply([](const auto&... x) { return orientation(x...); }, corners_of(mesh, s));
}

/// The same nodes in ascending order: equal for equal facets, edges or elements.
template <std::size_t N>
[[nodiscard]] std::array<NodeId, N> sorted(std::array<NodeId, N> nodes) {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

/// Whether two orderings of the same nodes differ by an odd permutation.
template <std::size_t N>
[[nodiscard]] bool oppositely_oriented(std::array<NodeId, N> a, const std::array<NodeId, N>& b) {
    bool odd = false;
    for (std::size_t i = 0; i < N; ++i) {
        const auto j = static_cast<std::size_t>(std::find(a.begin(), a.end(), b[i]) - a.begin());
        if (j != i && j < N) {
            std::swap(a[i], a[j]);
            odd = !odd;
        }
    }
    return odd;
}

} // namespace ameco
