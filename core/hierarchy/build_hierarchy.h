// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Coarsen again and again, and measure each level.
#pragma once

#include "core/hierarchy/hierarchy.h"

#include <functional>
#include <optional>

namespace ameco {

/// Receives each level when it is finished, finest first; a good place to write it to disk. What it
/// throws ends the hierarchy.
template <int D>
using LevelSink = std::function<void(const Level<D>& level, const LevelStatistics& statistics,
                                     LevelTiming timing)>;

/// How the making of a hierarchy ended.
struct HierarchyEnd {
    HierarchyStatus status = HierarchyStatus::complete;
    /// The step that removed too little, when the status is `exhausted`.
    std::optional<CoarsenReport> refused;
};

/// Says no to what cannot be had with this mesh, before anything is made.
/// \throws UsageError, Error
template <int D>
void require_possible(const Mesh<D>& mesh, const HierarchyOptions& options);

/// Makes level 0 and up to `options.levels` coarser ones from a valid mesh.
///
/// Only two levels are in memory at a time. A request to stop ends the hierarchy with the status
/// `cancelled`; the levels the sink has received are good.
///
/// \param mesh  valid (mesh/check.h)
/// \throws UsageError, Error  as `require_possible`
template <int D>
HierarchyEnd build_hierarchy(Mesh<D> mesh, const HierarchyOptions& options,
                             const LevelSink<D>& sink, Monitor& monitor = Monitor::silent());

/// Adds coarser levels to a hierarchy whose coarsest level is `last`, up to `options.levels`.
///
/// \param number     number of the level `last`
/// \param max_aspect_ratio  upper edge of the aspect-ratio classes: that of level 0
template <int D>
HierarchyEnd extend_hierarchy(Level<D> last, int number, double max_aspect_ratio,
                              const HierarchyOptions& options, const LevelSink<D>& sink,
                              Monitor& monitor = Monitor::silent());

/// Largest amount of memory the process has used so far [bytes].
[[nodiscard]] std::int64_t peak_memory();

} // namespace ameco
