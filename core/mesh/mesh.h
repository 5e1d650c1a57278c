// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Nodes, simplices, boundary faces, patches: plain arrays.
#pragma once

#include "core/base/id.h"
#include "core/base/vec.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace ameco {

template <int D>
using Simplex = std::array<NodeId, D + 1>; ///< triangle (D = 2) or tetrahedron (D = 3)

template <int D>
using Facet = std::array<NodeId, D>; ///< edge (D = 2) or triangle (D = 3)

using Edge = std::array<NodeId, 2>;

/// Points and lines of the geometry that a file declares and that coarsening must keep.
struct Features {
    std::vector<Edge> edges;      ///< curves on the boundary; D = 3 only (in 2-D faces are edges)
    std::vector<int> edge_labels; ///< [edges.size()] label of each curve

    std::vector<NodeId> corners; ///< nodes that must stay
    std::vector<int> ridges;     ///< sharp edges: indices into `edges` (D = 3) or `faces` (D = 2)
    std::vector<NodeId> required_nodes; ///< nodes that must stay, to the bit
    std::vector<int> required_edges;    ///< indices into `edges` (D = 3) or `faces` (D = 2)
    std::vector<int> required_faces;    ///< indices into `faces`; D = 3 only
    std::vector<int> required_elements; ///< indices into `elements`

    friend bool operator==(const Features&, const Features&) = default;
};

/// A simplicial mesh of a domain in D dimensions.
///
/// Elements are positively oriented; a face's normal points out of the domain. `faces` holds the
/// boundary, and may hold faces inside the domain (interfaces between regions, two-sided walls).
/// What must hold of a valid mesh is written down, and tested, in mesh/check.h.
template <int D>
struct Mesh {
    static constexpr int dimension = D;

    IdVector<NodeId, Vec<D>> points;          ///< [n] positions [L]
    IdVector<NodeId, int> labels;             ///< [n] or empty: a number a file gave to the node
    IdVector<ElementId, Simplex<D>> elements; ///< [m]
    IdVector<ElementId, int> region;          ///< [m]
    IdVector<FaceId, Facet<D>> faces;         ///< [k]
    IdVector<FaceId, int> patch;              ///< [k]

    std::map<int, std::string> patch_names;
    Features features;

    [[nodiscard]] Simplex<D>& operator[](ElementId e) { return elements[e]; }
    [[nodiscard]] const Simplex<D>& operator[](ElementId e) const { return elements[e]; }

    friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// The points of an element, in its node order.
template <int D>
[[nodiscard]] std::array<Vec<D>, D + 1> corners_of(const Mesh<D>& mesh, const Simplex<D>& s) {
    std::array<Vec<D>, D + 1> x;
    for (int i = 0; i <= D; ++i) {
        x[i] = mesh.points[s[i]];
    }
    return x;
}

} // namespace ameco
