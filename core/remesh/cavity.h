// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The one operator: form a cavity, star it from a node, judge it, replace it.
///
/// A collapse stars the ball of a node from a neighbour, an edge swap the shell of an edge from a
/// node of its ring, a face swap the two elements at a face from one of the two nodes opposite it.
/// \see docs/theory/remeshing.md; paper, section 4.1
#pragma once

#include "core/remesh/edit_mesh.h"
#include "core/remesh/size_quality.h"
#include "core/remesh/verdict.h"

namespace ameco {

/// A set of elements and the facets around it.
template <int D>
struct Cavity {
    std::vector<ElementId> elements; ///< real and ghost elements
    std::vector<Facet<D>> facets;    ///< around the cavity, normals outwards
    std::vector<ElementId> inside;   ///< the element of the cavity behind each facet
};

/// What would fill a cavity.
template <int D>
struct Star {
    std::vector<EditElement<D>> elements;
    std::vector<ElementId> sources; ///< see EditMesh::replace
    double worst_quality = 0;       ///< size quality of the worst new element [-]
};

/// The ball of `v`.
template <int D>
void gather_ball(const EditMesh<D>& mesh, NodeId v, Cavity<D>& cavity);

/// All elements at the edge a, b.
template <int D>
void gather_shell(const EditMesh<D>& mesh, NodeId a, NodeId b, Cavity<D>& cavity);

/// The same where the elements at the edge are known.
template <int D>
void gather_shell(const EditMesh<D>& mesh, NodeId a, NodeId b, std::span<const ElementId> elements,
                  Cavity<D>& cavity);

/// Two elements with a common facet.
template <int D>
void gather_pair(const EditMesh<D>& mesh, ElementId e, ElementId f, Cavity<D>& cavity);

/// Whether the nodes of a real element stand in positive orientation; exact.
template <int D>
[[nodiscard]] bool is_positive(const EditMesh<D>& mesh, const Simplex<D>& element);

/// The element on a facet of a cavity (normal outwards) and a node that is not on it; the ghost, if
/// any, in the last place.
template <int D>
[[nodiscard]] Simplex<D> join_facet(const Facet<D>& facet, NodeId node, NodeId ghost) {
    if constexpr (D == 2) {
        const NodeId a = facet[0], b = facet[1];
        if (a == ghost) {
            return {b, node, a};
        }
        if (b == ghost) {
            return {node, a, b};
        }
        return {a, b, node};
    } else {
        const NodeId a = facet[0], b = facet[2], c = facet[1];
        // Even permutations of (a, b, c, node).
        if (a == ghost) {
            return {b, node, c, a};
        }
        if (b == ghost) {
            return {a, c, node, b};
        }
        if (c == ghost) {
            return {a, node, b, c};
        }
        return {a, b, c, node};
    }
}

/// Joins `node` to all facets of the cavity that do not contain it, without a look at orientations.
template <int D>
void join_star(const EditMesh<D>& mesh, const Cavity<D>& cavity, NodeId node, Star<D>& star);

/// Whether a star that was joined may fill the cavity: every new element has strictly positive
/// orientation (exact), and there is one.
/// \return  accepted or inverts_element
template <int D>
[[nodiscard]] Verdict test_star(const EditMesh<D>& mesh, const Star<D>& star);

/// Joins `node` to all facets of the cavity that do not contain it. Every new element must have
/// strictly positive orientation (exact): with the ghost elements counted, the star then covers the
/// cavity, which is the paper's principle of minimal volume (15).
/// \return  accepted, or inverts_element; `star.worst_quality` is set by `judge`
template <int D>
[[nodiscard]] Verdict make_star(const EditMesh<D>& mesh, const Cavity<D>& cavity, NodeId node,
                                Star<D>& star);

/// Computes the size quality of the new elements; stops early once one is below `floor`.
/// \return  accepted or low_quality
template <int D>
[[nodiscard]] Verdict judge(const EditMesh<D>& mesh, const SizeField<D>& sizes, double floor,
                            Star<D>& star);

/// Computes the size quality of all elements, as their measure: what `worst_quality` compares.
template <int D>
void measure_size_quality(EditMesh<D>& mesh, const SizeField<D>& sizes);

/// Smallest size quality of the cavity's elements as they stand; 1 if there are none.
template <int D>
[[nodiscard]] double worst_quality(const EditMesh<D>& mesh, const Cavity<D>& cavity);

} // namespace ameco
