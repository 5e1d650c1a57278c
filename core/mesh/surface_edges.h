// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The edges of a surface, and which faces run through each.
#pragma once

#include "core/mesh/mesh.h"

#include <functional>
#include <span>
#include <vector>

namespace ameco {

/// An edge as one face runs through it.
struct EdgeUse {
    Edge edge; ///< ascending
    FaceId face;
    int opposite = 0;       ///< which of the face's nodes is not on the edge
    bool ascending = false; ///< the face runs from edge[0] to edge[1]
};

/// All uses of edges by the faces of `mesh`, sorted by edge, then by face. [3 k]
[[nodiscard]] std::vector<EdgeUse> edge_uses(const IdVector<FaceId, Facet<3>>& faces);

/// Calls `visit` once for each edge, with all of its uses, in ascending order of edges.
void for_each_edge(const std::vector<EdgeUse>& uses,
                   const std::function<void(std::span<const EdgeUse>)>& visit);

} // namespace ameco
