// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Who touches whom: elements at a node, nodes at a node, elements behind a facet.
#pragma once

#include "core/mesh/mesh.h"

#include <span>

namespace ameco {

/// Lists of varying length in two flat arrays: the list of row r is values[start[r] ... start[r+1]).
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
