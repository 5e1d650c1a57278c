// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The paper's own engine: cavities of nodes and edges are re-starred as long as that makes their
/// sets of qualities better (section 4.3).
#pragma once

#include "core/adapt/unit_mesh.h"

namespace ameco {

struct MtcOptions {
    int sweeps = 100;        ///< at most; it ends earlier when one changes nothing
    double insert_above = 1; ///< only edges longer than this get a node [-]: the halves of others
                             ///< would be shorter than 1/2
    bool new_places = true;  ///< nodes may be put in and moved
};

/// What became of the candidates, by the operation they stand for.
struct MtcVerdicts {
    VerdictCounts& collapses; ///< ball of a node, starred from a neighbour
    VerdictCounts& moves;     ///< ... from its barycentre
    VerdictCounts& swaps;     ///< shell of an edge, starred from a node of its ring
    VerdictCounts& splits;    ///< ... from a new node in the middle of the edge
};

/// Fills the ball of a node anew from the best place there is, if that beats it as it stands.
/// \return  whether it was filled anew
template <int D>
bool mend_ball(UnitMesh<D>& mesh, NodeId v, const MtcOptions& options, const SurfaceRules& surface,
               const MtcVerdicts& verdicts);

/// The same for the shell of an edge.
template <int D>
bool mend_shell(UnitMesh<D>& mesh, Edge edge, const MtcOptions& options,
                const SurfaceRules& surface, const MtcVerdicts& verdicts);

/// One sweep over the balls of all nodes, then over the shells of all edges, in the order of ids.
/// Every cavity is starred from each of its nodes in turn, then from a new place; what beats the
/// best so far in the order of sets (quality_order.h) takes its place. Stars are admissible by
/// minimal volume (15); the boundary has the rules of all other operators.
///
/// \param since  a cavity is looked at if something in it has changed since that time of the
///               mesh's clock: the answer for others is known
/// \return  number of cavities that were filled anew; 0 is stagnation
template <int D>
std::int64_t mtc_sweep(UnitMesh<D>& mesh, const MtcOptions& options, const SurfaceRules& surface,
                       int since, const MtcVerdicts& verdicts,
                       const Monitor& monitor = Monitor::silent());

} // namespace ameco
