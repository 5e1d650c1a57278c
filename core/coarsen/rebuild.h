// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A coarser level made anew by TetGen, where local operations do not get there.
#pragma once

#include "core/coarsen/coarsen.h"

namespace ameco {

/// Says no to a mesh that cannot be made anew, and in a build that cannot make any.
/// \throws UsageError  the mesh has several regions, faces inside, or required edges, faces or
///                     elements
/// \throws Error       a build without TetGen or OpenMesh
void require_rebuildable(const Mesh<3>& mesh);

/// Makes the next coarser level without regard to the elements of the fine one:
///
/// 1. the surface is thinned alone, in the target metric (surface/thin_surface.h);
/// 2. nodes inside stay or go: every other one on lines across layers, elsewhere those that are too
///    close in the target metric to one that stays, from the walls inwards (as in
///    coarsen/removal.h, but nobody asks whether elements can follow); those that the coarse
///    surface comes too near to go as well;
/// 3. TetGen makes a mesh of the coarse surface and the nodes that stay; nodes that it adds are
///    collapsed;
/// 4. swaps bring the mesh near the target metric, and moves of nodes if the options say so.
///
/// The level is like one made by `coarsen`: of nodes of the fine one, and valid.
///
/// \throws UsageError, Error  as `require_rebuildable`
/// \throws InputError, CheckFailed  TetGen could not, or a node that it added could not be
/// collapsed \throws Cancelled  when asked to stop
[[nodiscard]] Level<3> rebuild_level(const Level<3>& fine, const CoarsenOptions& options,
                                     CoarsenReport& report, Monitor& monitor = Monitor::silent());

} // namespace ameco
