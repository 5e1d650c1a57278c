// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Where to put nodes along a line: layers off a wall, and nodes along a curve of varying size.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace ameco {

/// Distances of the layers 0 ... n from the wall [L]: heights `first`, `first * growth`, ... until
/// they would exceed `largest`, which then repeats. Sums of positive terms, so that every height
/// keeps its relative precision.
[[nodiscard]] std::vector<double> growing_layers(double first, double growth, double largest,
                                                 std::size_t n);

/// The ratio r with  height * (r + r^2 + ... + r^n) = length:  the growth with which n more layers
/// after one of `height` fill `length`. Bisection to the last bit; all arguments positive.
[[nodiscard]] double filling_ratio(double height, double length, std::size_t n);

/// Abscissae 0 = s_0 < ... < s_n = length that equidistribute 1 / size: every interval holds the
/// same part of the integral of ds / size(s), so its length is proportional to the size there.
[[nodiscard]] std::vector<double> equidistribute(double length, std::size_t n,
                                                 const std::function<double(double)>& size);

} // namespace ameco
