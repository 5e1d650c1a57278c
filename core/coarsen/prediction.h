// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the next level will be like, from the metric alone, before anything is removed.
#pragma once

#include "core/coarsen/coarsen.h"
#include "core/metric/aspect_ratio.h"

namespace ameco {

struct Prediction {
    double factor = 0;          ///< coarse size over fine size
    double nodes = 0;           ///< nodes the target metric asks for
    AspectRatioClasses classes; ///< expected nodes by aspect ratio, rounded
};

/// Nodes as `coarsen` predicts them (metric/expected_nodes.h). Node v of the fine mesh stands for
/// sqrt(det M'(v) / det M(v)) nodes of the coarse one with the aspect ratio of M'(v), M' the target
/// metric; the sum is brought to the predicted number.
///
/// \param target_ratio      nodes of `fine` over those wanted, > 1; 0: as `options.factor` makes it
/// \param max_aspect_ratio  upper edge of the first class: that of level 0
template <int D>
[[nodiscard]] Prediction predict(const Mesh<D>& fine, const MetricField<D>& natural,
                                 TargetOptions options, double target_ratio,
                                 double max_aspect_ratio);

} // namespace ameco
