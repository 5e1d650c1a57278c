// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Which elements and faces lie on each facet.
#pragma once

#include "core/mesh/adjacency.h"

#include <functional>
#include <span>

namespace ameco {

/// An element seen from one of its facets.
struct ElementSide {
    ElementId element;
    int opposite = 0; ///< which of the element's nodes is opposite the facet: facet_of(s, opposite)
};

/// Everything a mesh lists on one facet.
template <int D>
struct FacetUses {
    Facet<D> nodes;                     ///< in ascending order
    std::span<const ElementSide> sides; ///< elements with this facet, ascending
    std::span<const FaceId> faces;      ///< faces on these nodes, ascending
};

/// Whether `listed`, a face on the given side of an element, points into the element. Of an element
/// without positive volume nobody can say: false.
template <int D>
[[nodiscard]] bool points_inward(const Mesh<D>& mesh, const ElementSide& side,
                                 const Facet<D>& listed);

/// Matches facets by filing elements and faces under their smallest nodes: 8 bytes per element,
/// and only a few dozen facets to compare at a time.
///
/// Needs node ids in range and no node twice in an element or face. Refers to the mesh, which must
/// outlive it and stay as it is.
template <int D>
class FacetTable {
public:
    explicit FacetTable(const Mesh<D>& mesh);

    /// Calls `visit` once for each facet whose smallest node is in [begin, end), in ascending order
    /// of the facets' nodes. May be called from several threads at once. The spans are good during
    /// the call only.
    void visit(std::size_t begin, std::size_t end,
               const std::function<void(const FacetUses<D>&)>& visit) const;

private:
    const Mesh<D>& mesh_;
    Lists<NodeId, ElementId> elements_; ///< by their smallest and second smallest node
    Lists<NodeId, FaceId> faces_;       ///< by their smallest node
};

} // namespace ameco
