// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Straight columns on a surface that do not cross; the first half of surface_layers.h.
#pragma once

#include "core/cases/surface_layers.h"

#include <vector>

namespace ameco {

/// The columns of layers on a surface, one per node.
struct SurfaceColumns {
    IdVector<NodeId, Vec<3>> step;  ///< [n] from the foot to distance 1 from the faces
    IdVector<NodeId, double> share; ///< [n] height over what was asked for [-], 0 ... 1
    std::vector<double> distance;   ///< [layers + 1] of the layers from the surface; 0 first [L]

    [[nodiscard]] bool collapsed(NodeId v) const { return share[v] == 0; }
    [[nodiscard]] Vec<3> point(const Mesh<3>& surface, NodeId v, std::size_t layer) const {
        return collapsed(v) ? surface.points[v]
                            : Vec<3>(surface.points[v] + distance[layer] * share[v] * step[v]);
    }
};

/// Order of the columns for cutting prisms, the same in all layers.
[[nodiscard]] std::vector<std::uint64_t> column_ranks(const Mesh<3>& surface,
                                                      const SurfaceLayerOptions& options);

/// Finds directions and shares so that all tets are positive and the last layer meets neither
/// itself nor the surface.
/// \throws InputError  where that cannot be had
[[nodiscard]] SurfaceColumns find_columns(const Mesh<3>& surface,
                                          const SurfaceLayerOptions& options,
                                          const std::string& name, Monitor& monitor);

} // namespace ameco
