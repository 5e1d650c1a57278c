// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The order in which nodes are looked at: layer by layer from the walls.
#pragma once

#include "core/mesh/adjacency.h"
#include "core/metric/metric.h"

namespace ameco {

struct FrontOrder {
    IdVector<NodeId, double> key; ///< distance from the walls, in layers [-]
    std::vector<NodeId> order;    ///< all nodes by key, then by id
};

struct FrontOptions {
    double seed_anisotropy = 4; ///< h_2 / h_1 above which a boundary node belongs to a wall [-]
    double seed_cosine =
        0.7; ///< least cosine between the short direction and the boundary's normal
};

/// Numbers the layers of a mesh by its own metric: the key of a node is its shortest path from the
/// walls, where an edge e costs, with the natural metric of its cheaper end,
///
///     sqrt( sum_i ((h_1 / h_i) (v_i . e) / h_i)^2 )
///
/// so that a step across a layer costs 1 and steps along it next to nothing. Walls are the boundary
/// nodes whose short direction is normal to the boundary; without any, all of the boundary.
template <int D>
[[nodiscard]] FrontOrder front_order(const Mesh<D>& mesh, const MetricField<D>& natural,
                                     const NodeNodes& neighbours, const FrontOptions& options = {});

} // namespace ameco
