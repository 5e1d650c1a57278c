// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Edge and face swaps: bad elements are mended without touching nodes.
#pragma once

#include "core/base/monitor.h"
#include "core/remesh/swap_input.h"
#include "core/remesh/swap_search.h"

namespace ameco {

/// Swaps around elements of low quality `metric_quality`, best proposal first, round by round. An
/// element is tried again only after an element at one of its edges may have changed.
///
/// What else is asked of them say the `CoarseningRules`.
///
/// Elements inside a part are mended side by side with those of other parts, the others after, see
/// `work_in_patches`.
template <int D>
void swap_bad_elements(EditMesh<D>& mesh, const SwapInput<D>& input, const SwapOptions& options,
                       const SurfaceRules& surface, VerdictCounts& verdicts,
                       Monitor& monitor = Monitor::silent());

} // namespace ameco
