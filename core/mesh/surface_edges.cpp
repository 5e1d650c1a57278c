// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/surface_edges.h"

#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco {

std::vector<EdgeUse> edge_uses(const IdVector<FaceId, Facet<3>>& faces) {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * faces.size());
    for (const FaceId f : faces.ids()) {
        for (int k = 0; k < 3; ++k) {
            const auto from = static_cast<std::size_t>(k);
            const Edge edge{faces[f][from], faces[f][(from + 1) % 3]};
            uses.push_back({sorted(edge), f, (k + 2) % 3, edge[0] < edge[1]});
        }
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::pair(a.edge, a.face) < std::pair(b.edge, b.face);
    });
    return uses;
}

void for_each_edge(const std::vector<EdgeUse>& uses,
                   const std::function<void(std::span<const EdgeUse>)>& visit) {
    for (std::size_t i = 0; i < uses.size();) {
        std::size_t j = i + 1;
        while (j < uses.size() && uses[j].edge == uses[i].edge) {
            ++j;
        }
        visit({uses.data() + i, j - i});
        i = j;
    }
}

} // namespace ameco
