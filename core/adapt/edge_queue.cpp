// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/edge_queue.h"

#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco {

template <int D>
std::vector<LongEdge> edges_by_length(const UnitMesh<D>& mesh, int since,
                                      const std::function<bool(double)>& wanted) {
    std::vector<LongEdge> edges;
    std::vector<NodeId> neighbours;
    for (const NodeId v : mesh.edit.nodes()) {
        if (mesh.edit.is_removed(v) || !mesh.changed_since(v, since)) {
            continue;
        }
        mesh.edit.neighbours(v, neighbours);
        for (const NodeId w : neighbours) {
            if (w < v && mesh.changed_since(w, since)) {
                continue; // seen from w
            }
            const double length = mesh.length(v, w);
            if (wanted(length)) {
                edges.push_back({length, sorted(Edge{v, w})});
            }
        }
    }
    std::sort(edges.begin(), edges.end(), [](const LongEdge& a, const LongEdge& b) {
        return a.length != b.length ? a.length < b.length : a.nodes < b.nodes;
    });
    return edges;
}

template std::vector<LongEdge> edges_by_length(const UnitMesh<2>&, int,
                                               const std::function<bool(double)>&);
template std::vector<LongEdge> edges_by_length(const UnitMesh<3>&, int,
                                               const std::function<bool(double)>&);

} // namespace ameco
