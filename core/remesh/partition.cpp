// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/partition.h"

#include "core/base/parallel.h"

#include <array>

namespace ameco {
namespace {

/// A line, or a node off the lines.
template <int D>
struct Column {
    Vec<D> place;
    NodeId first;
    std::int32_t nodes = 1;
};

template <int D>
using Columns = std::span<Column<D>>;

template <int D>
std::vector<Column<D>> columns_of(const IdVector<NodeId, Vec<D>>& points, const Lines& lines) {
    std::vector<Column<D>> columns;
    for (const NodeId v : points.ids()) {
        if (lines.on_line(v) && lines.previous[v].valid()) {
            continue;
        }
        Column<D> column{points[v], v};
        for (NodeId w = lines.next[v]; w.valid(); w = lines.next[w]) {
            ++column.nodes;
        }
        columns.push_back(column);
    }
    return columns;
}

/// The axis with the largest distance between the tenth and the ninth tenth of the columns: a few
/// far nodes, as around a wing, say nothing about the rest.
template <int D>
int widest_axis(Columns<D> columns) {
    std::vector<double> x(columns.size());
    std::array<double, D> spread{};
    for (int axis = 0; axis < D; ++axis) {
        std::transform(columns.begin(), columns.end(), x.begin(),
                       [&](const Column<D>& c) { return c.place[axis]; });
        const auto low = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 10);
        const auto high = x.end() - 1 - static_cast<std::ptrdiff_t>(x.size() / 10);
        std::nth_element(x.begin(), low, x.end());
        std::nth_element(low, high, x.end());
        spread[static_cast<std::size_t>(axis)] = *high - *low;
    }
    return static_cast<int>(std::max_element(spread.begin(), spread.end()) - spread.begin());
}

/// Sorts along the widest axis; returns where the given share of the nodes ends.
template <int D>
std::size_t cut(Columns<D> columns, double share) {
    if (columns.empty()) {
        return 0;
    }
    const int axis = widest_axis<D>(columns);
    std::sort(columns.begin(), columns.end(), [&](const Column<D>& a, const Column<D>& b) {
        return std::pair(a.place[axis], a.first) < std::pair(b.place[axis], b.first);
    });
    std::int64_t total = 0;
    for (const Column<D>& c : columns) {
        total += c.nodes;
    }
    std::int64_t below = 0;
    std::size_t at = 0;
    while (at < columns.size() && static_cast<double>(below) < share * static_cast<double>(total)) {
        below += columns[at++].nodes;
    }
    return at;
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
Partition cut_in_parts(const IdVector<NodeId, Vec<D>>& points, const Lines& lines,
                       std::size_t parts, double share) {
    std::vector<Column<D>> columns = columns_of<D>(points, lines);
    std::vector<Columns<D>> pieces{columns};
    while (pieces.size() < parts) {
        std::vector<Columns<D>> halves(2 * pieces.size());
        parallel_for(pieces.size(), 1, [&](std::size_t i, std::size_t) {
            const std::size_t at = cut<D>(pieces[i], share);
            halves[2 * i] = pieces[i].first(at);
            halves[2 * i + 1] = pieces[i].subspan(at);
        });
        pieces = std::move(halves);
    }
    Partition partition{IdVector<NodeId, std::uint16_t>(points.size()), pieces.size()};
    parallel_for(pieces.size(), 1, [&](std::size_t i, std::size_t) {
        for (const Column<D>& column : pieces[i]) {
            for (NodeId v = column.first; v.valid(); v = lines.next[v]) {
                partition.part[v] = static_cast<std::uint16_t>(i);
            }
        }
    });
    return partition;
}

template Partition cut_in_parts<2>(const IdVector<NodeId, Vec<2>>&, const Lines&, std::size_t,
                                   double);
template Partition cut_in_parts<3>(const IdVector<NodeId, Vec<3>>&, const Lines&, std::size_t,
                                   double);

} // namespace ameco
