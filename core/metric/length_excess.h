// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How far edges are from the lengths they have in a unit mesh.
#pragma once

#include <cmath>

namespace ameco {

/// Lengths that edges of a unit mesh may have.
inline constexpr double shortest_in_band = 0.70710678118654752;
inline constexpr double longest_in_band = 1.4142135623730951;

/// How far a length l is out of the band: 0 within, else 1 + 4 e, where l is 1 + e times as far
/// from 1 as the end of the band, in logarithms.
///
/// What lowers the sum over the edges of a mesh brings edges into the band or, of equally many that
/// stay out of it, nearer to it.
[[nodiscard]] inline double length_excess(double l) {
    if (l >= shortest_in_band && l <= longest_in_band) {
        return 0;
    }
    constexpr double weight = 4;
    return 1 + weight * (std::abs(std::log(l)) / std::log(longest_in_band) - 1);
}

/// A sum of excesses falls when it does by more than this: not by rounding, nor by steps so small
/// that they never end.
inline constexpr double least_excess_fall = 0.02;

} // namespace ameco
