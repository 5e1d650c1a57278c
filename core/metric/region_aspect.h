// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How stretched the metric is around a node, not at it alone.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

namespace ameco {

/// Aspect ratio [n] of the mean (8) of the metrics in the two rings of elements around each node.
///
/// In an unstructured isotropic mesh each node is stretched a little, its neighbours in other
/// directions: they cancel, and the region is isotropic. Where a mesh is stretched on purpose,
/// neighbours agree and the region is as stretched as its nodes.
///
/// The mean is taken in two rounds: elements take the mean of M^-1/2 of their nodes, nodes that of
/// their elements.
/// \see docs/theory/coarsening.md, "Isotropic regions"
template <int D>
[[nodiscard]] IdVector<NodeId, float> region_aspect_ratios(const Mesh<D>& mesh,
                                                           const MetricField<D>& field);

} // namespace ameco
