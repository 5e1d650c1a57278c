// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The metric of the next coarser level.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

#include <array>
#include <optional>
#include <string_view>

namespace ameco {

/// How the sizes of a node take notice of its neighbours.
enum class TargetAlgorithm {
    basic,        ///< not at all: Algorithm 1
    maca,         ///< Algorithm 2, in our reading
    maca_literal, ///< Algorithm 2, to the letter
    graded        ///< Algorithm 1, then gradation (metric/gradation.h)
};

inline constexpr std::array all_target_algorithms{TargetAlgorithm::basic, TargetAlgorithm::maca,
                                                  TargetAlgorithm::maca_literal,
                                                  TargetAlgorithm::graded};

[[nodiscard]] std::string_view name(TargetAlgorithm algorithm);
[[nodiscard]] std::optional<TargetAlgorithm> target_algorithm_from_name(std::string_view name);

struct TargetOptions {
    double factor = 2.0; ///< coarse size over fine size [-], > 1
    double slack = 1.0;  ///< how far a size may pass the one before it [-], >= 1; the paper has 1
    double isotropic_below = 1.6; ///< regions with a lower aspect ratio count as isotropic [-],
                                  ///< >= 1; the paper knows none, which is 1
    TargetAlgorithm algorithm = TargetAlgorithm::basic;
    double gradation = 1.5; ///< `graded`: most growth of coarsened sizes per fine edge [-], > 1

    friend bool operator==(const TargetOptions&, const TargetOptions&) = default;
};

/// Sizes of the coarsened metric: the paper's Algorithm 1 at one node, with a slack.
///
///     h'_0 := C h_1;   h'_k := max(h_k, min(C h_k, s_{k-1} h'_{k-1})),  k = 1 ... D, in this order
///     s_0 = 1,   s_k = min(s, h'_k / h_k)
///
/// Where the sizes are equal all of them double; where h_1 is much smaller than the others only h_1
/// does. With a slack s > 1, nodes whose aspect ratio is a little above 1 are still coarsened in
/// all directions. A size may pass the one before it only as far as that one has grown: in a layer
/// with sizes 1e-6, 1, 1 the second does not grow, and so the third does not either. Directions
/// stay.
/// \see docs/theory/coarsening.md; paper, Algorithm 1
template <int D>
[[nodiscard]] Vec<D> coarsened_sizes(const Vec<D>& sizes, const TargetOptions& options);

/// The slack in a region of a given aspect ratio r (metric/region_aspect.h): where r is below
/// r_0 = `isotropic_below` at least C^w, w falling smoothly from 1 at r = 1 to 0 at r = r_0 over
/// log r. In an isotropic region all sizes double, however the sizes of single nodes differ.
[[nodiscard]] double slack_in_region(double aspect_ratio, const TargetOptions& options);

/// The metric of the next coarser level: `coarsened_sizes` at every node with the slack of its
/// region, and what the algorithm makes of them beside each other.
///
/// `maca` is the paper's Algorithm 2 as we read it: a node that would be coarsened by C in all
/// directions keeps its sizes if a neighbour has a smaller h_1 and is not itself coarsened so. To
/// the letter (`maca_literal`) its condition is h_D = h_{D-1} after coarsening - three equal sizes,
/// which rounding hardly ever leaves - and any neighbour of a smaller number with a smaller h_1.
///
/// \param natural  [n] natural metric at the nodes of `mesh`
template <int D>
[[nodiscard]] MetricField<D> target_metric(const Mesh<D>& mesh, const MetricField<D>& natural,
                                           const TargetOptions& options = {});

/// The same with the regions' aspect ratios given, for those who want it with many factors.
/// \param regions  [n] `region_aspect_ratios` of the natural metric
template <int D>
[[nodiscard]] MetricField<D> target_metric(const Mesh<D>& mesh, const MetricField<D>& natural,
                                           const IdVector<NodeId, float>& regions,
                                           const TargetOptions& options);

} // namespace ameco
