// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The metric in which an element is equilateral.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

#include <array>
#include <span>

namespace ameco {

/// Volume of the regular simplex of edge 1: sqrt(3)/4 or sqrt(2)/12.
template <int D>
inline constexpr double regular_simplex_volume =
    D == 2 ? 0.43301270189221932338 : 0.11785113019775792073;

/// The natural metric of a simplex: the only one in which all its edges have length 1.
///
/// The paper's equation (5) inverts a sum of x x^T, whose condition number is the square of the
/// aspect ratio. Here J = E W^-1 maps the regular simplex of edge 1 onto the element (E: its edge
/// vectors from node 0, W: those of the regular simplex); M = J^-T J^-1, and the singular values
/// and left singular vectors of J are the sizes and directions. One-sided Jacobi rotations keep the
/// smallest of them to full relative precision as far as the coordinates have it.
///
/// \param points  the corners, positively oriented [L]
/// \return        the metric; sizes may be zero or tiny for a flat element
/// \see docs/theory/element_metric.md; paper, Lemma 2.1
template <int D>
[[nodiscard]] Metric<D> element_metric(const std::array<Vec<D>, D + 1>& points);

/// `element_metric` of the consecutive elements from `first` on: the same numbers in half the time.
///
/// \param metrics  as many as there are elements wanted; overwritten
template <int D>
void element_metrics(const Mesh<D>& mesh, ElementId first, std::span<Metric<D>> metrics);

/// The same of any elements: `metrics[n]` becomes that of `elements[n]`.
template <int D>
void element_metrics(const Mesh<D>& mesh, std::span<const ElementId> elements,
                     std::span<Metric<D>> metrics);

} // namespace ameco
