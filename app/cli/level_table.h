// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The levels of a hierarchy as a table, printed row by row while they are made.
#pragma once

#include "app/cli/report.h"
#include "core/hierarchy/hierarchy.h"

namespace ameco::cli {

/// One row per level: size, how far the metric's prediction was reached, stretching, conformity.
class LevelTable {
public:
    /// \param dimension  2 or 3, for the name of the elements
    explicit LevelTable(std::ostream& out, int dimension);

    void add(const LevelStatistics& level, double seconds);

private:
    std::ostream& out_;
    Table table_;
};

/// How often each verdict was given: a column per level.
void print_verdicts(std::ostream& out, const Hierarchy& hierarchy);

} // namespace ameco::cli
