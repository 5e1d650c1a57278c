// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/adjacency.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace ameco {
namespace {

/// Appends the neighbours of `v`, ascending, to `out`.
/// \param met  of whom each node was met as a neighbour last
template <int D>
void append_neighbours(const Mesh<D>& mesh, const NodeElements& ball, NodeId v,
                       IdVector<NodeId, NodeId>& met, std::vector<NodeId>& out) {
    const auto begin = static_cast<std::ptrdiff_t>(out.size());
    for (const ElementId e : ball[v]) {
        for (const NodeId w : mesh.elements[e]) {
            if (w != v && met[w] != v) {
                met[w] = v;
                out.push_back(w);
            }
        }
    }
    std::sort(out.begin() + begin, out.end());
}

} // namespace

template <int D>
NodeElements node_elements(const Mesh<D>& mesh) {
    return file_under<NodeId, ElementId>(
        mesh.points.size(), mesh.elements.size(),
        [&](ElementId e) -> const Simplex<D>& { return mesh.elements[e]; });
}

template <int D>
NodeNodes node_neighbours(const Mesh<D>& mesh, const NodeElements& ball) {
    const std::size_t n = mesh.points.size();
    // Few pieces: each has an entry for every node.
    const std::size_t nodes_per_piece = std::max<std::size_t>(8192, (n + 31) / 32);
    std::vector<std::vector<NodeId>> pieces((n + nodes_per_piece - 1) / nodes_per_piece);
    NodeNodes result;
    result.start.assign(n + 1, 0);
    parallel_for(n, nodes_per_piece, [&](std::size_t begin, std::size_t end) {
        std::vector<NodeId>& piece = pieces[begin / nodes_per_piece];
        IdVector<NodeId, NodeId> met(n);
        for (std::size_t v = begin; v < end; ++v) {
            const std::size_t before = piece.size();
            append_neighbours(mesh, ball, NodeId(v), met, piece);
            result.start[v + 1] = static_cast<std::int64_t>(piece.size() - before);
        }
    });
    for (std::size_t v = 0; v < n; ++v) {
        result.start[v + 1] += result.start[v];
    }
    result.values.resize(static_cast<std::size_t>(result.start[n]));
    parallel_for(pieces.size(), 1, [&](std::size_t p, std::size_t) {
        std::copy(pieces[p].begin(), pieces[p].end(),
                  result.values.begin() + result.start[p * nodes_per_piece]);
    });
    return result;
}

template <int D>
NodeNodes node_neighbours(const Mesh<D>& mesh) {
    return node_neighbours(mesh, node_elements(mesh));
}

std::vector<Edge> edges_of(const NodeNodes& neighbours) {
    std::vector<Edge> edges;
    edges.reserve(neighbours.values.size() / 2);
    for (std::size_t i = 0; i < neighbours.rows(); ++i) {
        const NodeId v(i);
        for (const NodeId w : neighbours[v]) {
            if (v < w) {
                edges.push_back({v, w});
            }
        }
    }
    return edges;
}

template NodeElements node_elements(const Mesh<2>&);
template NodeElements node_elements(const Mesh<3>&);
template NodeNodes node_neighbours(const Mesh<2>&, const NodeElements&);
template NodeNodes node_neighbours(const Mesh<3>&, const NodeElements&);
template NodeNodes node_neighbours(const Mesh<2>&);
template NodeNodes node_neighbours(const Mesh<3>&);

} // namespace ameco
