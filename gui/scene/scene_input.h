// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What a view is made from.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

#include <memory>
#include <string>
#include <vector>

namespace ameco::gui {

/// One level. Pointers into larger things (a Level) are made by shared_ptr's
/// aliasing constructor; nothing is copied.
template <int D>
struct SceneInput {
    std::shared_ptr<const Mesh<D>> mesh;           ///< valid
    std::shared_ptr<const MetricField<D>> natural; ///< natural metric at its nodes; null:
                                                   ///< see AbsentMetric
    std::vector<int> removed_at; ///< [n] or empty: level on which the node is missing first, 0 for
                                 ///< one that is on all levels
    std::string name;            ///< "level 2", over the picture; may be empty
};

/// On which level each node is missing first; 0 for a node that is on all levels.
///
/// \param nodes    number of nodes of the level that is asked about
/// \param level    its number
/// \param parents  of the levels level + 1, level + 2, ...: the node of the next finer level at the
///                 same place (Level::parent)
[[nodiscard]] std::vector<int>
removal_levels(std::size_t nodes, int level,
               const std::vector<const IdVector<NodeId, NodeId>*>& parents);

} // namespace ameco::gui
