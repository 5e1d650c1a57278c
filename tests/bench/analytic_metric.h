// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Metrics by formula on the unit cube: what mesh adaptation is measured with.
#pragma once

#include "core/metric/metric.h"

namespace ameco {

/// Families of metrics on [0, 1]^3; lengths in units of the cube's edge. All but `layer` and `skew`
/// are those of the Unstructured Grid Adaptation Working Group (Ibanez et al., First benchmark of
/// the UGAWG, Procedia Engineering 203, 2017).
enum class AnalyticMetric {
    linear,  ///< h_z = 0.001 + 0.198 |z - 1/2|, else 0.1
    polar_1, ///< h_r = 0.001 + 0.198 |r - 1/2|, else 0.1, around the z axis
    polar_2, ///< as polar_1, but along the circle 0.025 at r = 1/2, rising to 0.1 within 0.1
    layer,   ///< a wall at z = 0: h_z = min(h + 0.198 z, 0.1), else 0.1
    skew     ///< the same across an oblique plane through the cube's middle
};

/// \param first  h of `layer` and `skew` [L]
[[nodiscard]] Metric<3> analytic_metric(AnalyticMetric kind, double first, const Vec<3>& p);

} // namespace ameco
