// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Swaps that raise the quality in the metric.
#pragma once

#include "core/adapt/unit_mesh.h"
#include "core/remesh/swap_search.h"

namespace ameco {

/// Swaps around elements whose quality is below `options.below`, best proposal first.
/// \param since  only elements with a node that has changed since are looked at
/// \return  number of swaps made
template <int D>
std::int64_t swap_to_quality(UnitMesh<D>& mesh, const SwapOptions& options,
                             const SurfaceRules& surface, int since, VerdictCounts& verdicts,
                             const Monitor& monitor = Monitor::silent());

} // namespace ameco
