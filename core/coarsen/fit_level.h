// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Nodes of a coarse level move to where the target metric wants them.
#pragma once

#include "core/coarsen/coarsen.h"

namespace ameco {

/// Brings a level nearer to the metric it was made for: swaps of edges and faces and moves of nodes
/// in turns (core/adapt). No node comes or goes. In layers, which lines must cross unbroken for
/// multigrid's sake, all stays as it is. Corners and the nodes of curved patches stay where
/// they are, those of planar patches in their plane, those of straight ridges on their line.
///
/// The metric at a node is that of its place in the fine mesh.
///
/// \param fine    mesh that `target` belongs to, one metric per node
/// \param coarse  made of nodes of `fine`, none of them moved yet
/// \throws Cancelled when asked to stop
template <int D>
void fit_level(const Mesh<D>& fine, const MetricField<D>& target, const CoarsenOptions& options,
               Level<D>& coarse, CoarsenReport& report, Monitor& monitor);

} // namespace ameco
