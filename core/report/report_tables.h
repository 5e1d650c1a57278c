// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What was measured on a hierarchy, as tables: for the report, and as files beside it.
#pragma once

#include "core/hierarchy/hierarchy.h"
#include "core/report/html.h"

namespace ameco {

/// Nodes, ratios, predicted: the paper's tables 2 and 4, one row per level.
[[nodiscard]] html::Table levels_table(const Hierarchy& hierarchy);

/// Nodes by classes of the aspect ratio: the paper's table 3, one row per class, two columns per
/// level.
[[nodiscard]] html::Table classes_table(const Hierarchy& hierarchy);

/// Lengths of edges and qualities of elements in the metric asked for, one row per level.
[[nodiscard]] html::Table conformity_table(const Hierarchy& hierarchy);

/// Volume, and distance of the boundary from the finest one, one row per level.
[[nodiscard]] html::Table geometry_table(const Hierarchy& hierarchy);

/// Why nodes stayed, one row per verdict, one column per level.
[[nodiscard]] html::Table removals_table(const Hierarchy& hierarchy);

/// Seconds by phase and memory, one row per level.
[[nodiscard]] html::Table times_table(const std::vector<LevelTiming>& timings);

} // namespace ameco
