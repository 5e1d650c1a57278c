// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A hierarchy as one page for the engineer's file.
#pragma once

#include "core/hierarchy/hierarchy.h"
#include "core/multigrid/study.h"

#include <optional>
#include <string>
#include <vector>

namespace ameco {

/// How multigrid converges on the hierarchy.
struct ReportedCycle {
    std::string title; ///< "V(2,2), Gauss-Seidel, stiffened"
    double operator_complexity = 1;
    CycleStudy study;
};

struct ReportContent {
    std::string folder; ///< as the user named it
    Hierarchy hierarchy;
    std::vector<LevelTiming> timings;  ///< empty: nothing is said about them
    std::string sections;              ///< SVG of the layers, level by level; may be empty
    std::vector<ReportedCycle> cycles; ///< of Poisson's equation, best last; empty: not measured
};

/// The page as HTML: everything is inside, nothing is fetched. The same content gives the same
/// bytes; without timings, the same for every run.
/// \pre the hierarchy has a level
[[nodiscard]] std::string report_page(const ReportContent& content);

} // namespace ameco
