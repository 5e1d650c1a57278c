// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The levels of a branch as charts.
#pragma once

#include "core/coarsen/prediction.h"
#include "core/multigrid/convergence_plot.h"
#include "gui/model/document.h"
#include "gui/panels/chart.h"

#include <optional>

namespace ameco::gui {

/// The colour of level `number` in all charts.
[[nodiscard]] QColor level_colour(int number);

/// Nodes in classes of powers of two, from 1 upwards: chart class c is class n - 1 - c of
/// AspectRatioClasses, see `mirrored`.
/// \param prediction  of the level after number `from`
/// \param selection   some nodes of a level, as a series of their own; empty for none
[[nodiscard]] Chart aspect_ratio_chart(const Branch& branch,
                                       const std::optional<Prediction>& prediction, int from,
                                       const std::vector<double>& selection,
                                       const QString& selection_title);

/// From classes of AspectRatioClasses to those of the chart, and back.
[[nodiscard]] std::set<int> mirrored(const std::set<int>& classes, int count);

/// How many of the nodes are in each class, in the order of the chart.
[[nodiscard]] std::vector<double> count_nodes(const CaseLevel& level,
                                              const std::vector<NodeId>& nodes);

[[nodiscard]] Chart quality_chart(const Branch& branch);
[[nodiscard]] Chart length_chart(const Branch& branch);
[[nodiscard]] Chart convergence_chart(const std::vector<ConvergenceCurve>& curves);

} // namespace ameco::gui
