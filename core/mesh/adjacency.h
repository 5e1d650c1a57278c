// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Who touches whom: elements at a node, nodes at a node, elements behind a facet.
#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <span>
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
/// range of `Row`. Within a row the values ascend. A counting sort: two passes, no comparisons.
template <class Row, class Value, class RowsOf>
[[nodiscard]] Lists<Row, Value> file_under(std::size_t rows, std::size_t items, RowsOf rows_of) {
    Lists<Row, Value> lists;
    lists.start.assign(rows + 1, 0);
    for (std::size_t i = 0; i < items; ++i) {
        for (const Row r : rows_of(Value(i))) {
            ++lists.start[r.index() + 1];
        }
    }
    for (std::size_t r = 0; r < rows; ++r) {
        lists.start[r + 1] += lists.start[r];
    }
    lists.values.resize(static_cast<std::size_t>(lists.start[rows]));
    // Filled from the back, the end of each row, start[r + 1], can serve as its cursor: it moves
    // down to the row's begin, and no second array of cursors is needed.
    for (std::size_t i = items; i-- > 0;) {
        for (const Row r : rows_of(Value(i))) {
            lists.values[static_cast<std::size_t>(--lists.start[r.index() + 1])] = Value(i);
        }
    }
    const auto total = static_cast<std::int64_t>(lists.values.size());
    for (std::size_t r = 0; r < rows; ++r) {
        lists.start[r] = lists.start[r + 1];
    }
    lists.start[rows] = total;
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
