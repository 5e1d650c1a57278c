// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How strongly neighbouring nodes are coupled in a Laplacian on the mesh.
#pragma once

#include "core/mesh/adjacency.h"

namespace ameco {

/// Couplings c_vw = -a_vw of the stiffness matrix a_vw = integral of grad(phi_v) . grad(phi_w) of
/// linear finite elements. A point smoother reduces an error along strong couplings only: they,
/// not the metric, decide which nodes multigrid can do without.
struct Couplings {
    NodeNodes neighbours;             ///< in ascending order
    std::vector<float> values;        ///< c_vw, beside neighbours.values [L^(D-2)]
    IdVector<NodeId, float> diagonal; ///< a_vv

    /// c_vw, or 0 where v and w share no edge.
    [[nodiscard]] float between(NodeId v, NodeId w) const;
    [[nodiscard]] std::span<const float> at(NodeId v) const {
        const auto b = static_cast<std::size_t>(neighbours.start[v.index()]);
        return {values.data() + b, neighbours[v].size()};
    }
};

template <int D>
[[nodiscard]] Couplings make_couplings(const Mesh<D>& mesh);

/// Gives couplings that know their neighbours their values.
/// \param ball  `node_elements` of the mesh
template <int D>
void measure_couplings(const Mesh<D>& mesh, const NodeElements& ball, Couplings& couplings);

} // namespace ameco
