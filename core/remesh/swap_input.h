// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What swaps look at while a mesh is coarsened.
#pragma once

#include "core/remesh/edit_notes.h"
#include "core/remesh/lines.h"
#include "core/remesh/metric_quality.h"
#include "core/remesh/partition.h"
#include "core/remesh/removed_nodes.h"

namespace ameco {

/// What decides about swaps beside the mesh.
template <int D>
struct SwapInput {
    const SizeField<D>& sizes;
    const RootField<D>& root;
    const IdVector<NodeId, float>& short_size; ///< natural h_1 [L]
    const Lines& lines;
    RemovedNodes<D>& removed;
    EditNotes& notes;                        ///< kept up to date
    std::span<const Partition> partitions{}; ///< for threads; none: the whole mesh in order
    double least_stiffness = 0; ///< no swap may bring a_vv below this times the fine mesh's [-]
};

} // namespace ameco
