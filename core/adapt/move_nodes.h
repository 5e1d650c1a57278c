// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Nodes go where the elements around them are better.
#pragma once

#include "core/adapt/unit_mesh.h"

#include <optional>

namespace ameco {

struct MoveOptions {
    double below = 0.9;     ///< nodes with an element of a quality below this are tried [-]
    double gain = 1.002;    ///< the harmonic mean of the qualities must grow by this factor [-]
    int halvings = 3;       ///< of a step that is refused
    bool by_excess = false; ///< first to where the sum of the excesses of lengths falls, and never
                            ///< to where it rises; the worst quality may fall by that ...
    double excess_quality = 0.4; ///< ... to this [-], as on the way to the surface below
    double farthest = 1e300;     ///< from a node's first place in the UnitMesh, in the metric [-]
    std::optional<SurfaceRules> curved = {}; ///< for nodes of curved patches and ridges, which move
                                             ///< on the original surface; those that are off it go
                                             ///< there first; none: they stay
};

/// Moves one node, as `move_nodes` does.
/// \return  accepted, geometry_class or no_improvement
template <int D>
Verdict move_node(UnitMesh<D>& mesh, NodeId v, const MoveOptions& options);

/// Moves nodes, in the order of their ids, towards the place from which their neighbours are one
/// unit away. Nodes of planar patches stay in their plane, nodes of straight ridges on their line.
/// Those of curved ones stay where they are, or move on the original surface, along its ridges.
/// \param since  only nodes that have changed since are looked at
/// \return  number of moves made
/// \see length_excess.h
template <int D>
std::int64_t move_nodes(UnitMesh<D>& mesh, const MoveOptions& options, int since,
                        VerdictCounts& verdicts, const Monitor& monitor = Monitor::silent());

} // namespace ameco
