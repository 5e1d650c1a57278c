// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The metric of the next coarser level.
#pragma once

#include "core/metric/metric.h"

namespace ameco {

struct TargetOptions {
    double factor = 2.0; ///< coarse size over fine size [-], > 1
    double slack = 1.15; ///< how far a size may pass the one before it [-], >= 1; the paper has 1
};

/// Sizes of the coarsened metric: the paper's Algorithm 1 at one node, with a slack.
///
///     h'_0 := C h_1;   h'_k := max(h_k, min(C h_k, s_{k-1} h'_{k-1})),  k = 1 ... D, in this order
///     s_0 = 1,   s_k = min(s, h'_k / h_k)
///
/// Where the sizes are equal all of them double; where h_1 is much smaller than the others only h_1
/// does. With a slack s > 1, nodes whose aspect ratio is a little above 1 - the corrected mean
/// overstates it in unstructured isotropic regions - are still coarsened in all directions. A size
/// may pass the one before it only as far as that one has grown: in a layer with sizes 1e-6, 1, 1
/// the second does not grow, and so the third does not either. Directions stay.
/// \see docs/theory/coarsening.md; paper, Algorithm 1
template <int D>
[[nodiscard]] Vec<D> coarsened_sizes(const Vec<D>& sizes, const TargetOptions& options);

/// `coarsened_sizes` at every node.
template <int D>
[[nodiscard]] MetricField<D> target_metric(const MetricField<D>& natural,
                                           const TargetOptions& options = {});

} // namespace ameco
