// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Who touches whom: elements at a node, nodes at a node, elements behind a facet.
#pragma once

#include "core/base/parallel.h"
#include "core/mesh/mesh.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ameco {

/// Lists of varying length in two flat arrays: the list of row r is values[start[r] ...
/// start[r+1]).
template <class Row, class Value>
struct Lists {
    std::vector<std::int64_t> start; ///< [rows + 1]
    std::vector<Value> values;

    [[nodiscard]] std::size_t rows() const { return start.empty() ? 0 : start.size() - 1; }
    [[nodiscard]] std::span<const Value> operator[](Row r) const {
        const auto b = static_cast<std::size_t>(start[r.index()]);
        const auto e = static_cast<std::size_t>(start[r.index() + 1]);
        return {values.data() + b, e - b};
    }
    [[nodiscard]] std::span<Value> operator[](Row r) {
        const auto b = static_cast<std::size_t>(start[r.index()]);
        const auto e = static_cast<std::size_t>(start[r.index() + 1]);
        return {values.data() + b, e - b};
    }
};

/// Files `items` values (0 ... items-1) under rows: item i goes into every row of `rows_of(i)`, a
/// range of `Row`. Within a row the values ascend. A counting sort: two passes, no comparisons,
/// many items in blocks side by side.
/// \param rows_of  called by several threads at a time, twice for each item
template <class Row, class Value, class RowsOf>
[[nodiscard]] Lists<Row, Value> file_under(std::size_t rows, std::size_t items, RowsOf rows_of) {
    // Each block has a cursor for every row: few blocks.
    constexpr std::size_t least_in_block = 65536, most_blocks = 8;
    const std::size_t blocks = std::clamp<std::size_t>(
        items / least_in_block, 1, std::min(most_blocks, static_cast<std::size_t>(thread_count())));
    const std::size_t grain = std::max<std::size_t>((items + blocks - 1) / blocks, 1);
    std::vector<std::vector<std::int64_t>> cursors(blocks);
    parallel_for(items, grain, [&](std::size_t begin, std::size_t end) {
        std::vector<std::int64_t>& count = cursors[begin / grain];
        count.assign(rows, 0);
        for (std::size_t i = begin; i < end; ++i) {
            for (const Row r : rows_of(Value(i))) {
                ++count[r.index()];
            }
        }
    });
    if (items == 0) {
        cursors.clear();
    }
    Lists<Row, Value> lists;
    lists.start.resize(rows + 1);
    std::int64_t total = 0;
    for (std::size_t r = 0; r < rows; ++r) {
        lists.start[r] = total;
        for (std::vector<std::int64_t>& cursor : cursors) {
            total += std::exchange(cursor[r], total);
        }
    }
    lists.start[rows] = total;
    lists.values.resize(static_cast<std::size_t>(total));
    parallel_for(items, grain, [&](std::size_t begin, std::size_t end) {
        std::vector<std::int64_t>& cursor = cursors[begin / grain];
        for (std::size_t i = begin; i < end; ++i) {
            for (const Row r : rows_of(Value(i))) {
                lists.values[static_cast<std::size_t>(cursor[r.index()]++)] = Value(i);
            }
        }
    });
    return lists;
}

using NodeElements = Lists<NodeId, ElementId>;
using NodeNodes = Lists<NodeId, NodeId>;

/// The ball of each node: its elements, in ascending order.
template <int D>
[[nodiscard]] NodeElements node_elements(const Mesh<D>& mesh);

/// The nodes that share an edge with each node, in ascending order.
template <int D>
[[nodiscard]] NodeNodes node_neighbours(const Mesh<D>& mesh, const NodeElements& ball);
template <int D>
[[nodiscard]] NodeNodes node_neighbours(const Mesh<D>& mesh);

/// Each edge once, as (smaller node, larger node), sorted.
[[nodiscard]] std::vector<Edge> edges_of(const NodeNodes& neighbours);

} // namespace ameco
