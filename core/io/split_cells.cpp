// SPDX-License-Identifier: AGPL-3.0-or-later
// The splitting of cells into simplices. For what is done and why, see mixed_mesh.h.
#include "core/io/mixed_mesh.h"

#include "core/mesh/references.h"

#include <algorithm>

namespace ameco {
namespace {

template <std::size_t N>
void add_part(const std::array<NodeId, N>& part, std::vector<std::array<NodeId, N>>& parts) {
    if (!has_repetition(part)) {
        parts.push_back(part);
    }
}

/// The place of the smallest of some nodes.
template <class Nodes>
std::size_t smallest(const Nodes& nodes) {
    return static_cast<std::size_t>(std::min_element(nodes.begin(), nodes.end()) - nodes.begin());
}

} // namespace

void split_quadrilateral(const std::array<NodeId, 4>& q, std::vector<Facet<3>>& parts) {
    const std::size_t i = smallest(q);
    const auto at = [&](std::size_t k) { return q[(i + k) % 4]; };
    add_part(Facet<3>{at(0), at(1), at(2)}, parts);
    add_part(Facet<3>{at(0), at(2), at(3)}, parts);
}

void split_cell(CellType type, std::span<const NodeId> nodes, std::vector<Simplex<3>>& parts) {
    const NodeId apex = nodes[smallest(nodes)];
    std::vector<Facet<3>> triangles;
    triangles.reserve(12); // two for each face of a hexahedron
    for (const CellFace& face : faces_of(type)) {
        std::array<NodeId, 4> q{};
        for (int k = 0; k < face.nodes; ++k) {
            q[static_cast<std::size_t>(k)] = nodes[static_cast<std::size_t>(face.node[k])];
        }
        if (face.nodes == 4) {
            split_quadrilateral(q, triangles);
        } else {
            add_part(Facet<3>{q[0], q[1], q[2]}, triangles);
        }
    }
    for (const Facet<3>& t : triangles) {
        add_part(Simplex<3>{apex, t[0], t[1], t[2]}, parts);
    }
}

} // namespace ameco
