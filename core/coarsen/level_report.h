// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the report of a level says, however the level was made.
#pragma once

#include "core/coarsen/coarsen.h"

namespace ameco {

/// Number of nodes of the level, times the quotient of what the target and the natural metric ask
/// for (metric/expected_nodes.h).
template <int D>
[[nodiscard]] double predicted_nodes(const Level<D>& fine, const MetricField<D>& target);

/// The target at the nodes of a level made from `fine`: that of the fine node, or, if the node was
/// moved, of its new place in the fine mesh.
template <int D>
[[nodiscard]] MetricField<D> wanted_metric(const Mesh<D>& fine, const MetricField<D>& target,
                                           const Level<D>& coarse);

/// Sets how far the boundary is from the finest one: the largest bound of a face, and the largest
/// one over the mean edge of its face.
template <int D>
void measure_deviation(const Mesh<D>& mesh, const GeometryClasses<D>& geometry,
                       CoarsenReport& report);

} // namespace ameco
