// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The edges of a mesh that want an operation, in the order of their length.
#pragma once

#include "core/adapt/unit_mesh.h"

#include <limits>
#include <vector>

namespace ameco {

struct LongEdge {
    double length; ///< in the metric [-]
    Edge nodes;    ///< ascending
};

/// Lengths of edges that are looked for: those outside a band [-].
struct LengthsWanted {
    double below = 0;
    double above = std::numeric_limits<double>::infinity();
};

inline constexpr LengthsWanted all_lengths{.below = std::numeric_limits<double>::infinity()};

/// All edges whose length is wanted, each once, the shortest first; equal ones by their nodes.
/// \param since  only edges with an end that has changed since that time of the mesh's clock
template <int D>
[[nodiscard]] std::vector<LongEdge> edges_by_length(const UnitMesh<D>& mesh, int since,
                                                    const LengthsWanted& wanted);

} // namespace ameco
