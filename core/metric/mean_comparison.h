// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// All means at one node, beside each other: figures 2 and 3 of the paper at any node of any mesh.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/means.h"

#include <string>
#include <vector>

namespace ameco {

/// What one of the means makes of the elements at a node.
template <int D>
struct ComparedMean {
    Mean mean = Mean::corrected;
    std::string failure; ///< why there is none; "" where there is
    Metric<D> metric;
    double turn_deg = 0; ///< angle of its short direction to that of the corrected mean [deg]
    double distance = 0; ///< invariant distance to the corrected mean [-]
};

template <int D>
struct MeanComparison {
    NodeId node;
    std::vector<Metric<D>> elements;    ///< natural metrics of the elements at the node
    std::vector<ComparedMean<D>> means; ///< of all means, in their order
};

/// \param node  used by an element
template <int D>
[[nodiscard]] MeanComparison<D> compare_means(const Mesh<D>& mesh, NodeId node);

/// The unit balls as SVG, in the plane of the corrected mean's longest (to the right) and shortest
/// direction (upwards). The picture is scaled upwards so that the corrected mean's ball is as
/// high as it is wide, and shows four times its height; balls that are higher are cut, and their
/// sizes stand beside the picture. Means that agree to 1 % share a line.
template <int D>
[[nodiscard]] std::string unit_balls_svg(const MeanComparison<D>& comparison);

} // namespace ameco
