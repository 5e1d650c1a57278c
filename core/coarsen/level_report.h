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

/// The metric of the fine mesh at the nodes that are left of it.
/// \param parent  fine node of each coarse one
template <int D>
[[nodiscard]] MetricField<D> at_parents(const MetricField<D>& field,
                                        const IdVector<NodeId, NodeId>& parent);

/// Sets how far the boundary is from the finest one: the largest bound of a face, and the largest
/// one over the mean edge of its face.
template <int D>
void measure_deviation(const Mesh<D>& mesh, const GeometryClasses<D>& geometry,
                       CoarsenReport& report);

} // namespace ameco
