// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A picture of residuals over iterations.
#pragma once

#include <string>
#include <vector>

namespace ameco {

struct ConvergenceCurve {
    std::string title;
    std::vector<double> residuals; ///< relative, of iterations 0, 1, ...; > 0
};

/// SVG with a logarithmic axis of residuals, one curve each.
[[nodiscard]] std::string convergence_plot(const std::vector<ConvergenceCurve>& curves);

} // namespace ameco
