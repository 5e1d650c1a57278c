// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Edges that are too short in the metric lose one of their nodes.
#pragma once

#include "core/adapt/unit_mesh.h"

namespace ameco {

struct CollapseOptions {
    double below = shortest_in_band; ///< edges shorter than this, 1/sqrt(2), are collapsed [-]
    double longest = 1.6;            ///< no new edge may be longer than this, or than one it
                                     ///< replaces [-]
    bool by_excess = false;     ///< instead of that: the sum of the excesses of lengths must fall
    double quality_share = 1.0; ///< the worst quality may fall to this share of what it was ...
    double quality_floor = 0.2; ///< ... and to this, where it was better [-]
};

/// Collapses edges, the shortest first, onto whichever end leaves the better elements.
/// \param since  only edges with an end that has changed since are looked at
/// \return  number of nodes removed
/// \see length_excess.h
template <int D>
std::int64_t collapse_short_edges(UnitMesh<D>& mesh, const CollapseOptions& options,
                                  const SurfaceRules& surface, int since, VerdictCounts& verdicts,
                                  const Monitor& monitor = Monitor::silent());

} // namespace ameco
