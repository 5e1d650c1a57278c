// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/edge_queue.h"

#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco {

template <int D>
std::vector<LongEdge> edges_by_length(const UnitMesh<D>& mesh, int since,
                                      const LengthsWanted& wanted) {
    std::vector<LongEdge> edges;
    for (std::size_t i = 0; i < mesh.edit.slot_count(); ++i) {
        const ElementId e(i);
        if (mesh.edit.is_free(e) || mesh.edit.is_ghost(e)) {
            continue;
        }
        const Simplex<D>& s = mesh.edit.nodes(e);
        for (const auto& [p, q] : SimplexNumbering<D>::edges) {
            const Edge edge = sorted(Edge{s[p], s[q]});
            if ((!mesh.changed_since(edge[0], since) && !mesh.changed_since(edge[1], since)) ||
                mesh.is_surely_between(edge[0], edge[1], wanted.below, wanted.above)) {
                continue;
            }
            const double length = mesh.length(edge[0], edge[1]);
            if (length < wanted.below || length > wanted.above) {
                edges.push_back({length, edge});
            }
        }
    }
    std::sort(edges.begin(), edges.end(), [](const LongEdge& a, const LongEdge& b) {
        return a.length != b.length ? a.length < b.length : a.nodes < b.nodes;
    });
    const auto is_same = [](const LongEdge& a, const LongEdge& b) { return a.nodes == b.nodes; };
    edges.erase(std::unique(edges.begin(), edges.end(), is_same), edges.end());
    return edges;
}

template std::vector<LongEdge> edges_by_length(const UnitMesh<2>&, int, const LengthsWanted&);
template std::vector<LongEdge> edges_by_length(const UnitMesh<3>&, int, const LengthsWanted&);

} // namespace ameco
