// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Edges that are too long in the metric get a node in the middle.
#pragma once

#include "core/adapt/unit_mesh.h"

#include <optional>

namespace ameco {

struct SplitOptions {
    double above = longest_in_band; ///< edges longer than this, sqrt(2), are split [-]
    double shortest = 0.70;  ///< no new edge beside the halves may be shorter than this [-] ...
    double much_above = 2.5; ///< ... and where the edge is longer than this,
    double shortest_among_long = 0.8; ///< than this [-]
    bool by_excess = false;     ///< instead of these: the sum of the excesses of lengths must fall
    double quality_share = 0.5; ///< the worst quality may fall to this share of what it was
    std::optional<SurfaceRules> curved = {}; ///< nodes on curved patches and ridges are put on the
                                             ///< original surface; none: they stay on the edge
    double surface_quality = 0.4;            ///< there the worst quality may fall to this [-]
};

/// Adds the node that halves an edge in the metric. No element has it yet.
/// \param shell  of the edge a, b
template <int D>
NodeId add_middle_node(UnitMesh<D>& mesh, NodeId a, NodeId b, const Cavity<D>& shell);

/// Splits edges, the longest first: the shell of the edge is starred from a new node on it. Where
/// the boundary is curved the node then goes to the nearest place on the original surface, or stays
/// on the edge if an element would be inverted or too bad there, or the rules refuse the boundary.
/// Edges made on the way are left to the next call.
/// \param since  only edges with an end that has changed since are looked at
/// \return  number of splits made
/// \see length_excess.h
template <int D>
std::int64_t split_long_edges(UnitMesh<D>& mesh, const SplitOptions& options, int since,
                              VerdictCounts& verdicts, const Monitor& monitor = Monitor::silent());

} // namespace ameco
