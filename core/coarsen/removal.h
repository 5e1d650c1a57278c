// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The pass that removes nodes: in front order, along strong couplings, lines kept whole.
#pragma once

#include "core/base/monitor.h"
#include "core/metric/metric.h"
#include "core/remesh/collapse.h"
#include "core/remesh/couplings.h"
#include "core/remesh/edit_notes.h"
#include "core/remesh/lines.h"
#include "core/remesh/partition.h"
#include "core/remesh/removed_nodes.h"

namespace ameco {

struct RemovalOptions {
    QualityFloor quality;
    SurfaceRules surface;
    double reach = 0.73; ///< edges that shall go are shorter than this in the target metric [-]
    double later_reach = 1.4;    ///< the same of edges along which nodes may leave after the first
                                 ///< pass, when they are crowded by another [-]
    double coupling_bound = 0.9; ///< most of a_vv that may go to removed neighbours [-], where
                                 ///< few directions are coarsened ...
    double isotropic_coupling = 1; ///< ... and what is added times the square of the isotropy:
                                   ///< where all are, everything may go
    double crowded = 1; ///< after the first pass a node leaves only if its edges are shorter than
                        ///< this on average in the target metric, where all directions are
                        ///< coarsened [-] ...
    double crowded_layer = 0.5; ///< ... and this is added where only one is
    InterpolationBound interpolation;
};

/// What the removal looks at, beside the mesh; all of it of the mesh before any removal.
template <int D>
struct RemovalInput {
    const std::vector<NodeId>& order; ///< front order
    const Couplings& couplings;
    const SizeField<D>& sizes;
    const IdVector<NodeId, Mat<D>>& natural;   ///< length factors of the natural metric
    const IdVector<NodeId, Mat<D>>& target;    ///< length factors of the target metric
    const IdVector<NodeId, float>& short_size; ///< natural h_1 [L]
    const IdVector<NodeId, float>& directions; ///< `coarsened_directions`
    RemovedNodes<D>& removed;                  ///< kept up to date
    EditNotes& notes;                          ///< the same
    std::span<const Partition> partitions{};   ///< for threads; none: the whole mesh in order
};

/// Which nodes are gone, and how much of each node's stencil went with them.
struct RemovalState {
    /// \param lines  before any removal
    explicit RemovalState(const Lines& lines)
        : removed_coupling(lines.position.size(), 0), kept(lines.position.size(), 0),
          layer(lines.position) {}
    IdVector<NodeId, float> removed_coupling; ///< sum of c_vw over removed neighbours w
    IdVector<NodeId, std::uint8_t> kept;      ///< looked at and kept, in the first pass
    IdVector<NodeId, std::int32_t> layer;     ///< place on its line in the fine mesh; -1: on none
};

/// First pass: nodes in front order. On a line every odd node goes, onto a neighbour on the line.
/// Off the lines a node goes onto a kept neighbour that is too close in the target metric; among
/// several the one that leaves the best elements. All removed nodes must stay well interpolated.
///
/// Both passes work on the parts of each partition side by side; nodes at their borders and on
/// ridges come after, see `work_in_patches`.
template <int D>
void remove_first_pass(EditMesh<D>& mesh, Lines& lines, RemovalState& state,
                       const RemovalInput<D>& input, const RemovalOptions& options,
                       VerdictCounts& verdicts, Monitor& monitor);

/// Later passes: nodes that still have a neighbour too close leave onto any that is not far, unless
/// their other neighbours are far already. (Without the latter, isotropic regions would end with
/// half the nodes that were asked for: one short edge is found at almost every node.) A node that
/// had to stay is looked at again only after an element at it has changed.
template <int D>
void remove_again(EditMesh<D>& mesh, Lines& lines, RemovalState& state,
                  const RemovalInput<D>& input, const RemovalOptions& options,
                  VerdictCounts& verdicts, Monitor& monitor);

} // namespace ameco
