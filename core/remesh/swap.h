// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Edge and face swaps: bad elements are mended without touching nodes.
#pragma once

#include "core/base/monitor.h"
#include "core/remesh/edit_notes.h"
#include "core/remesh/lines.h"
#include "core/remesh/metric_quality.h"
#include "core/remesh/partition.h"
#include "core/remesh/removed_nodes.h"
#include "core/remesh/swap_search.h"

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
};

/// Swaps around elements of low quality `metric_quality`, best proposal first, round by round. An
/// element is tried again only after an element at one of its edges may have changed.
///
/// No swap may raise the number of layer elements without an edge along a line (all nodes on lines,
/// none linked): such elements couple columns diagonally, and multigrid diverges on them.
///
/// Elements inside a part are mended side by side with those of other parts, the others after, see
/// `work_in_patches`.
template <int D>
void swap_bad_elements(EditMesh<D>& mesh, const SwapInput<D>& input, const SwapOptions& options,
                       const SurfaceRules& surface, VerdictCounts& verdicts,
                       Monitor& monitor = Monitor::silent());

/// Whether all nodes of an element are on lines, but no two follow each other on one.
template <int D>
[[nodiscard]] bool is_lineless(const Lines& lines, const Simplex<D>& element);

} // namespace ameco
