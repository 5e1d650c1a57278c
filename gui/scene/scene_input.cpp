// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/scene_input.h"

namespace ameco::gui {

std::vector<int> removal_levels(std::size_t nodes, int level,
                                const std::vector<const IdVector<NodeId, NodeId>*>& parents) {
    std::vector<int> gone(nodes, 0);
    std::vector<NodeId> origin; // [nodes of a level] their ids on the level asked about
    origin.reserve(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
        origin.push_back(NodeId(i));
    }
    for (const auto* parent : parents) {
        ++level;
        std::vector<NodeId> kept;
        kept.reserve(parent->size());
        std::vector<std::uint8_t> stays(nodes, 0);
        for (const NodeId p : *parent) {
            kept.push_back(origin[p.index()]);
            stays[kept.back().index()] = 1;
        }
        for (const NodeId i : origin) {
            if (stays[i.index()] == 0) {
                gone[i.index()] = level;
            }
        }
        origin = std::move(kept);
    }
    return gone;
}

} // namespace ameco::gui
