// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A prism between two layers of columns, cut into simplices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ameco {

/// The end of a column of a prism.
struct PrismCorner {
    std::size_t column;
    bool top; ///< of the two layers that bound the prism
};

/// Splits the prism over a facet of N columns into N simplices of N + 1 corners, each given to
/// `emit` in positive order if the facet is seen counter-clockwise from the top (N = 3), or has the
/// top on its left (N = 2). With the columns in order of rank, simplex i has the feet of columns
/// 0 ... i and the tops of columns i ... N-1.
/// \param rank  by column; equal ranks are ordered by column
template <std::size_t N, class Emit>
void split_prism(std::array<int, N> facet, const std::vector<std::uint64_t>& rank,
                 const Emit& emit) {
    bool odd = false;
    for (std::size_t i = 1; i < N; ++i) { // insertion sort that keeps count of the swaps
        for (std::size_t j = i; j > 0; --j) {
            const auto a = static_cast<std::size_t>(facet[j - 1]);
            const auto b = static_cast<std::size_t>(facet[j]);
            if (std::pair(rank[a], a) < std::pair(rank[b], b)) {
                break;
            }
            std::swap(facet[j - 1], facet[j]);
            odd = !odd;
        }
    }
    for (std::size_t i = 0; i < N; ++i) {
        std::array<PrismCorner, N + 1> s;
        for (std::size_t k = 0; k <= i; ++k) {
            s[k] = {static_cast<std::size_t>(facet[k]), false};
        }
        for (std::size_t k = i; k < N; ++k) {
            s[k + 1] = {static_cast<std::size_t>(facet[k]), true};
        }
        if (odd != ((N - 1 - i) % 2 == 1)) {
            std::swap(s[N - 1], s[N]);
        }
        emit(s);
    }
}

} // namespace ameco
