// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// All that is known about one node.
#pragma once

#include "core/metric/mean_comparison.h"
#include "core/remesh/geometry_classes.h"
#include "gui/model/case_level.h"

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
};

/// \param level  with elements
/// \param node   of it
[[nodiscard]] Inspection inspect(const CaseLevel& level, NodeId node, const TargetOptions& target);

/// As text, for the clipboard.
[[nodiscard]] std::string inspection_text(const Inspection& inspection);

} // namespace ameco::gui
