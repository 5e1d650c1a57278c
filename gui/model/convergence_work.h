// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How multigrid converges on the levels of a branch; for a worker thread.
#pragma once

#include "core/multigrid/convergence_plot.h"
#include "gui/model/case_level.h"

#include <vector>

namespace ameco::gui {

/// Residuals of conjugate gradients with a V(1,1) cycle for Poisson's equation, Dirichlet
/// conditions all around, f = 1: one curve per smoother, as `ameco multigrid` measures them. \param
/// branch  two levels or more, finest first \throws Cancelled
[[nodiscard]] std::vector<ConvergenceCurve>
measure_convergence(const std::vector<CaseLevel>& branch, Monitor& monitor);

} // namespace ameco::gui
