// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/hierarchy.h"

namespace ameco {
namespace {

double sum_over_finest(const Hierarchy& hierarchy, std::int64_t LevelStatistics::*count) {
    if (hierarchy.levels.empty()) {
        return 0;
    }
    double sum = 0;
    for (const HierarchyLevel& level : hierarchy.levels) {
        sum += static_cast<double>(level.statistics.*count);
    }
    return sum / static_cast<double>(hierarchy.levels.front().statistics.*count);
}

} // namespace

std::string_view name(HierarchyStatus status) {
    switch (status) {
    case HierarchyStatus::in_progress:
        return "in progress";
    case HierarchyStatus::complete:
        return "complete";
    case HierarchyStatus::exhausted:
        return "cannot be coarsened further";
    case HierarchyStatus::cancelled:
        return "cancelled";
    }
    return "unknown";
}

bool is_isotropic_end(const LevelStatistics& level, const HierarchyOptions& options) {
    return options.until_isotropic && level.aspect_ratio.share_isotropic >= isotropic_share;
}

double grid_complexity(const Hierarchy& hierarchy) {
    return sum_over_finest(hierarchy, &LevelStatistics::nodes);
}

double element_complexity(const Hierarchy& hierarchy) {
    return sum_over_finest(hierarchy, &LevelStatistics::elements);
}

} // namespace ameco
