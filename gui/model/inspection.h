// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// All that is known about one node, and about the element that was clicked.
#pragma once

#include "core/metric/mean_comparison.h"
#include "core/remesh/geometry_classes.h"
#include "gui/model/case_level.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ameco::gui {

/// One of the means at the node, whatever the dimension.
struct InspectedMean {
    std::string name;
    std::string failure; ///< why there is none; "" where there is
    std::vector<double> sizes;
    double aspect_ratio = 1;
    double turn_deg = 0;
};

/// The element that was hit.
struct InspectedElement {
    ElementId id;
    std::vector<int> nodes;
    int region = 0;
    double volume = 0;         ///< area in 2-D [L^D]
    double quality = 0;        ///< in the nodes' natural metric, in [0, 1]
    double aspect_ratio = 1;   ///< of its own natural metric
    std::vector<double> sizes; ///< of that metric [L]
};

struct Inspection {
    int level_id = -1;
    int level = 0;
    NodeId node;
    std::vector<double> point;
    std::vector<std::string> patches;            ///< names of those that meet at the node
    std::string node_class;                      ///< "interior", "patch", "ridge", "frozen"
    std::size_t elements = 0;                    ///< around the node
    double worst_quality = 0;                    ///< of those, in the natural metric, in [0, 1]
    std::vector<double> sizes;                   ///< of the natural metric [L]
    std::vector<double> target_sizes;            ///< of the next level's [L]
    std::vector<std::vector<double>> directions; ///< unit vector of each size
    double aspect_ratio = 1;
    std::vector<InspectedMean> means;
    std::optional<InspectedElement> element; ///< nothing when the node was named by its number
};

/// \param level  with elements
/// \param node   of it
/// \param element  that was hit; none: nothing is said about one
[[nodiscard]] Inspection inspect(const CaseLevel& level, NodeId node, const TargetOptions& target,
                                 ElementId element = {});

/// As text, for the clipboard.
[[nodiscard]] std::string inspection_text(const Inspection& inspection);

} // namespace ameco::gui
