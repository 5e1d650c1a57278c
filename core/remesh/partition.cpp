// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/partition.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace ameco {
namespace {

/// A line, or a node off the lines.
template <int D>
struct Column {
    Vec<D> place;
    NodeId first;
    std::int64_t weight = 0; ///< number of its nodes that count
};

template <int D>
std::vector<Column<D>> columns_of(const IdVector<NodeId, Vec<D>>& points, const Lines& lines,
                                  const NodeMarks& counts) {
    std::vector<Column<D>> columns;
    for (const NodeId v : points.ids()) {
        if (lines.on_line(v) && lines.previous[v].valid()) {
            continue;
        }
        Column<D> column{points[v], v};
        for (NodeId w = v; w.valid(); w = lines.next[w]) {
            column.weight += counts[w];
        }
        columns.push_back(column);
    }
    return columns;
}

/// A piece of the mesh, its lower side along an axis first.
template <int D>
struct Cut {
    std::vector<Column<D>> columns;
    std::size_t at = 0;     ///< the first column of the upper side
    std::int64_t edges = 0; ///< between the two sides, at nodes that count
};

template <int D>
std::int64_t weight_of(std::span<const Column<D>> columns) {
    return std::accumulate(columns.begin(), columns.end(), std::int64_t{0},
                           [](std::int64_t sum, const Column<D>& c) { return sum + c.weight; });
}

/// Puts the columns first that come first along an axis, as few as have half of the weight. In
/// linear time: selection, not sorting.
/// \return  how many these are
template <int D>
std::size_t halve(int axis, std::span<Column<D>> columns) {
    const auto comes_first = [axis](const Column<D>& a, const Column<D>& b) {
        return std::pair(a.place[axis], a.first) < std::pair(b.place[axis], b.first);
    };
    const std::int64_t total = weight_of<D>(columns);
    std::size_t begin = 0, end = columns.size(); // the count is in [begin, end]
    std::int64_t below = 0;                      // weight of the first `begin`
    while (begin < end) {
        const std::size_t middle = begin + (end - begin) / 2;
        std::nth_element(columns.begin() + begin, columns.begin() + middle, columns.begin() + end,
                         comes_first);
        const std::int64_t lower = weight_of<D>(columns.subspan(begin, middle - begin));
        if (2 * (below + lower) >= total) {
            end = middle;
        } else {
            below += lower + columns[middle].weight;
            begin = middle + 1;
        }
    }
    return begin;
}

/// What the ways to cut a piece are compared on.
template <int D>
struct Bisection {
    const NodeNodes& neighbours;
    const Lines& lines;
    const NodeMarks& counts;
    const IdVector<NodeId, std::uint16_t>& part; ///< so far
    std::array<NodeMarks, D> upper = {};         ///< side of each node, by axis

    template <class Visit>
    void visit_nodes(std::span<const Column<D>> columns, const Visit& visit) const {
        for (const Column<D>& column : columns) {
            for (NodeId v = column.first; v.valid(); v = lines.next[v]) {
                visit(v);
            }
        }
    }

    [[nodiscard]] Cut<D> across(int axis, const std::vector<Column<D>>& columns) {
        Cut<D> cut{columns};
        cut.at = halve<D>(axis, cut.columns);
        auto& side = upper[static_cast<std::size_t>(axis)];
        const auto all = std::span<const Column<D>>(cut.columns);
        visit_nodes(all.first(cut.at), [&](NodeId v) { side[v] = 0; });
        visit_nodes(all.subspan(cut.at), [&](NodeId v) { side[v] = 1; });
        visit_nodes(all.first(cut.at), [&](NodeId v) {
            for (const NodeId w : neighbours[v]) {
                const bool is_cut = part[w] == part[v] && side[w] == 1;
                cut.edges += is_cut && (counts[v] != 0 || counts[w] != 0) ? 1 : 0;
            }
        });
        return cut;
    }
};

/// Nodes that have one of a set as a neighbour, or are one.
NodeMarks with_neighbours(const NodeNodes& neighbours, const NodeMarks& set) {
    NodeMarks out(set);
    parallel_for(set.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (const NodeId w : neighbours[NodeId(i)]) {
                out[NodeId(i)] |= set[w];
            }
        }
    });
    return out;
}

} // namespace

std::size_t part_count(std::size_t nodes, std::size_t nodes_per_part) {
    constexpr std::size_t most = 64;
    std::size_t parts = 1;
    while (parts < most && nodes >= 2 * parts * nodes_per_part) {
        parts *= 2;
    }
    return parts;
}

template <int D>
Partition cut_in_parts(const IdVector<NodeId, Vec<D>>& points, const NodeNodes& neighbours,
                       const Lines& lines, std::size_t parts, const NodeMarks& counts) {
    Partition partition{IdVector<NodeId, std::uint16_t>(points.size(), 0), 1};
    Bisection<D> bisection{neighbours, lines, counts, partition.part};
    bisection.upper.fill(NodeMarks(points.size(), 0));
    std::vector<std::vector<Column<D>>> pieces{columns_of<D>(points, lines, counts)};
    while (pieces.size() < parts) {
        std::vector<std::array<Cut<D>, D>> cuts(pieces.size());
        parallel_for(pieces.size() * D, 1, [&](std::size_t i, std::size_t) {
            cuts[i / D][i % D] = bisection.across(static_cast<int>(i % D), pieces[i / D]);
        });
        std::vector<std::vector<Column<D>>> halves(2 * pieces.size());
        parallel_for(pieces.size(), 1, [&](std::size_t i, std::size_t) {
            const Cut<D>& best = *std::min_element(
                cuts[i].begin(), cuts[i].end(),
                [](const Cut<D>& a, const Cut<D>& b) { return a.edges < b.edges; });
            const auto middle = best.columns.begin() + static_cast<std::ptrdiff_t>(best.at);
            halves[2 * i].assign(best.columns.begin(), middle);
            halves[2 * i + 1].assign(middle, best.columns.end());
            for (const std::size_t half : {2 * i, 2 * i + 1}) {
                bisection.visit_nodes(halves[half], [&](NodeId v) {
                    partition.part[v] = static_cast<std::uint16_t>(half);
                });
            }
        });
        pieces = std::move(halves);
    }
    partition.parts = pieces.size();
    return partition;
}

NodeMarks border_nodes(const NodeNodes& neighbours, const Partition& partition) {
    NodeMarks border(partition.part.size(), 0);
    parallel_for(border.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const NodeId v(i);
            const auto around = neighbours[v];
            border[v] = std::any_of(around.begin(), around.end(), [&](NodeId w) {
                return partition.part[w] != partition.part[v];
            });
        }
    });
    return with_neighbours(neighbours, border);
}

template Partition cut_in_parts<2>(const IdVector<NodeId, Vec<2>>&, const NodeNodes&, const Lines&,
                                   std::size_t, const NodeMarks&);
template Partition cut_in_parts<3>(const IdVector<NodeId, Vec<3>>&, const NodeNodes&, const Lines&,
                                   std::size_t, const NodeMarks&);

} // namespace ameco
