// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/lines.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <span>

namespace ameco {
namespace {

/// Of one node; the valid ones first.
using Links = std::array<NodeId, 2>;

/// Whether the first of two strongest neighbours is much farther than a third one: in the long
/// direction of a needle, where each of many elements around an edge adds to its coupling, and
/// diagonals with negative couplings take as much away.
template <int D>
bool is_longest(const Mesh<D>& mesh, std::span<const NodeId> neighbours, NodeId v,
                const std::array<NodeId, 3>& best) {
    constexpr double much = 3;
    const auto distance = [&](NodeId w) { return (mesh.points[w] - mesh.points[v]).norm(); };
    const double most = distance(best[0]) / much;
    return std::any_of(neighbours.begin(), neighbours.end(), [&](NodeId w) {
        return w != best[0] && w != best[1] && distance(w) < most;
    });
}

/// The one or two neighbours a node wants to be linked with.
template <int D>
Links wanted_links(const Mesh<D>& mesh, const Couplings& couplings, NodeId v, double dominance,
                   const LineOptions& options) {
    std::array<NodeId, 3> best;
    std::array<float, 3> c{0, 0, 0};
    const auto neighbours = couplings.neighbours[v];
    const auto values = couplings.at(v);
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        // Equal couplings keep the order of the ids, so that the choice is the same everywhere.
        for (std::size_t k = 0; k < 3; ++k) {
            if (values[i] > c[k]) {
                std::move_backward(c.begin() + k, c.end() - 1, c.end());
                std::move_backward(best.begin() + k, best.end() - 1, best.end());
                c[k] = values[i];
                best[k] = neighbours[i];
                break;
            }
        }
    }
    if (!best[0].valid() || is_longest(mesh, neighbours, v, best)) {
        return {};
    }
    const auto tau = static_cast<float>(dominance);
    if (best[1].valid() && c[1] >= tau * c[2]) {
        const Vec<D> a = mesh.points[best[0]] - mesh.points[v];
        const Vec<D> b = mesh.points[best[1]] - mesh.points[v];
        if (a.dot(b) < options.largest_cosine * a.norm() * b.norm()) {
            return {best[0], best[1]};
        }
    }
    if (c[0] >= tau * c[1]) {
        return {best[0], NodeId()};
    }
    return {};
}

bool wants(const Links& links, NodeId v) {
    return links[0] == v || links[1] == v;
}

/// Follows the links from one end of a chain.
std::vector<NodeId> walk(const LineLinks& links, NodeId end) {
    std::vector<NodeId> chain{end};
    NodeId before;
    NodeId at = end;
    while (true) {
        const auto& l = links[at];
        const NodeId onward = l[0].valid() && l[0] != before ? l[0] : l[1];
        if (!onward.valid() || onward == before) {
            return chain;
        }
        before = at;
        at = onward;
        chain.push_back(at);
    }
}

bool is_end(const Links& links) {
    return links[0].valid() && !links[1].valid();
}

/// The other end of the chain of each end; itself for a node without links.
IdVector<NodeId, NodeId> other_ends(const LineLinks& links) {
    IdVector<NodeId, NodeId> other(links.size());
    for (const NodeId v : links.ids()) {
        if (!links[v][0].valid()) {
            other[v] = v;
        } else if (is_end(links[v]) && !other[v].valid()) {
            const NodeId end = walk(links, v).back();
            other[v] = end;
            other[end] = v;
        }
    }
    return other;
}

/// Lengthens chains from their ends along couplings that dominate less.
template <int D>
void continue_chains(const Mesh<D>& mesh, const Couplings& couplings, const LineOptions& options,
                     LineLinks& links) {
    const auto wanted = [&](NodeId v) {
        return wanted_links(mesh, couplings, v, options.continuation, options);
    };
    IdVector<NodeId, NodeId> other = other_ends(links);
    // Both ends must want each other beside the links they have, whichever is looked at first.
    const auto agrees = [&](NodeId v, NodeId w) {
        const Links onward = wanted(v);
        return !links[v][1].valid() && wants(onward, w) &&
               (!links[v][0].valid() || wants(onward, links[v][0]));
    };
    const auto next_beyond = [&](NodeId end) {
        for (const NodeId w : wanted(end)) {
            if (w.valid() && w != links[end][0] && w != other[end] && agrees(end, w) &&
                agrees(w, end)) {
                return w;
            }
        }
        return NodeId();
    };
    for (const NodeId v : mesh.points.ids()) {
        NodeId end = v;
        while (is_end(links[end])) {
            const NodeId w = next_beyond(end);
            if (!w.valid()) {
                break;
            }
            const NodeId first = other[end], last = other[w];
            links[end][1] = w;
            links[w][links[w][0].valid() ? 1 : 0] = end;
            other[first] = last;
            other[last] = first;
            end = last;
        }
    }
}

/// Whether a line is to be numbered from `a` and not from `b`, its other end. Where both are on
/// walls, the axis along which they lie apart decides: neighbouring lines then start on the same
/// side, however the nodes are numbered, and lose the nodes of the same layers.
template <int D>
bool starts_at(const Mesh<D>& mesh, const IdVector<NodeId, double>& key, NodeId a, NodeId b) {
    if (key[a] != key[b]) {
        return key[a] < key[b];
    }
    const Vec<D> across = mesh.points[b] - mesh.points[a];
    int axis = 0;
    across.cwiseAbs().maxCoeff(&axis);
    return across[axis] > 0;
}

} // namespace

void Lines::remove(NodeId v) {
    const NodeId before = previous[v], after = next[v];
    if (before.valid()) {
        next[before] = after;
        gap_used[before] = 1;
    } else if (after.valid()) {
        gap_used[after] = 1; // the end is gone: its neighbour is the end now, and stays
    }
    if (after.valid()) {
        previous[after] = before;
    }
    previous[v] = next[v] = NodeId();
    position[v] = -1;
}

template <int D>
LineLinks link_lines(const Mesh<D>& mesh, const Couplings& couplings, const LineOptions& options) {
    const std::size_t n = mesh.points.size();
    LineLinks wanted(n), links(n);
    parallel_for(n, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const NodeId v(i);
            wanted[v] = wanted_links(mesh, couplings, v, options.dominance, options);
        }
    });
    for (const NodeId v : mesh.points.ids()) {
        std::size_t k = 0;
        for (const NodeId w : wanted[v]) {
            if (w.valid() && wants(wanted[w], v)) {
                links[v][k++] = w;
            }
        }
    }
    continue_chains(mesh, couplings, options, links);
    return links;
}

template <int D>
Lines number_lines(const Mesh<D>& mesh, const LineLinks& links,
                   const IdVector<NodeId, double>& key) {
    const std::size_t n = mesh.points.size();
    Lines lines;
    lines.previous.resize(n);
    lines.next.resize(n);
    lines.position.assign(n, -1);
    lines.gap_used.assign(n, 0);
    for (const NodeId v : mesh.points.ids()) {
        if (!is_end(links[v]) || lines.position[v] >= 0) {
            continue; // closed chains have no end, and stay off the lines
        }
        std::vector<NodeId> chain = walk(links, v);
        if (starts_at(mesh, key, chain.back(), v)) {
            std::reverse(chain.begin(), chain.end());
        }
        for (std::size_t i = 0; i < chain.size(); ++i) {
            lines.position[chain[i]] = static_cast<std::int32_t>(i);
            lines.previous[chain[i]] = i > 0 ? chain[i - 1] : NodeId();
            lines.next[chain[i]] = i + 1 < chain.size() ? chain[i + 1] : NodeId();
        }
        ++lines.count;
        lines.node_count += static_cast<std::int64_t>(chain.size());
    }
    return lines;
}

template <int D>
Lines find_lines(const Mesh<D>& mesh, const Couplings& couplings,
                 const IdVector<NodeId, double>& key, const LineOptions& options) {
    return number_lines(mesh, link_lines(mesh, couplings, options), key);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template LineLinks link_lines(const Mesh<D>&, const Couplings&, const LineOptions&);           \
    template Lines number_lines(const Mesh<D>&, const LineLinks&,                                  \
                                const IdVector<NodeId, double>&);                                  \
    template Lines find_lines(const Mesh<D>&, const Couplings&, const IdVector<NodeId, double>&,   \
                              const LineOptions&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
