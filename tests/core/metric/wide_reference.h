// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Metrics and their means in fifty digits, for elements whose coordinates are exactly the given
/// doubles. A library of its own, so that only its one source pays for the wide numbers.
#pragma once

#include "core/metric/geodesic.h"
#include "core/metric/means.h"

#include <array>
#include <vector>

namespace ameco::wide {

template <int D>
using Corners = std::array<Vec<D>, D + 1>;

/// Sizes of the natural metric of an element, from the paper's equation (5).
template <int D>
[[nodiscard]] Vec<D> sizes(const Corners<D>& points);

/// Sizes of the metric with that tensor.
template <int D>
[[nodiscard]] Vec<D> sizes_of_tensor(const Tensor<D>& tensor);

/// The mean of the natural metrics of some elements; one of those that come from sums.
template <int D>
[[nodiscard]] Metric<D> mean(const std::vector<Corners<D>>& elements, Mean mean);

/// Norm of the mean of the tangent vectors at `R` to the natural metrics of some elements: a bound
/// of the invariant distance of `R` to their geodesic mean.
template <int D>
[[nodiscard]] double geodesic_residual(const std::vector<Corners<D>>& elements, const Metric<D>& R);

/// `log_map`.
template <int D>
[[nodiscard]] Tangent<D> log_map(const Metric<D>& base, const Metric<D>& other);

} // namespace ameco::wide
