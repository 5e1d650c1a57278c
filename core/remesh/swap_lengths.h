// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Edge swaps that bring the lengths of edges to what a metric asks for.
#pragma once

#include "core/base/monitor.h"
#include "core/remesh/surface_rules.h"
#include "core/remesh/swap_input.h"
#include "core/remesh/verdict.h"

namespace ameco {

struct LengthSwapOptions {
    double quality_floor = 0.1; ///< `metric_quality` of new elements must reach this, or that of
                                ///< the worst they replace [-]
    double stiffening = 3; ///< what the elements of a swap add to the stiffness matrix's diagonal
                           ///< may grow by this factor at most, at no node by more [-]
    double line_stiffening = 1.5;   ///< the same at nodes of lines: what makes them stiff couples
                                    ///< them to the side, and every node of a layer feels it [-]
    double size_floor = 0.1;        ///< the size quality must stay above this or not fall [-]
    std::size_t largest_shell = 10; ///< elements around an edge that is swapped
    int rounds = 2;                 ///< over the edges; 0: none
};

/// Takes away edges whose length (`edge_length`) is out of [1/sqrt(2), sqrt(2)], where the edges
/// that come instead have less excess (`length_excess`) together. To be called when quality is as
/// it shall be: elements may get worse, down to the floor.
///
/// Edges of the boundary stay: lengths are no reason for it to move.
///
/// Thin elements that such swaps leave make the coarse matrix stiff at single nodes, and point
/// smoothers slow; this is what `stiffening` is for.
///
/// Shells inside a part are swapped side by side with those of other parts, the others after, see
/// `work_in_patches`.
/// \param target  \f$F\f$ of each node, |F e| is the length of e at the node
/// \see docs/theory/remeshing.md, "Lengths last"
template <int D>
void swap_lengths(EditMesh<D>& mesh, const SwapInput<D>& input,
                  const IdVector<NodeId, Mat<D>>& target, const LengthSwapOptions& options,
                  const SurfaceRules& surface, VerdictCounts& verdicts,
                  Monitor& monitor = Monitor::silent());

} // namespace ameco
