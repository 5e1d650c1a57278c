// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Every invariant of a valid mesh; used by tests, after every level, and by `ameco check`.
#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ameco {

/// The ways a mesh can be broken. In this order, since the later tests need the earlier ones: a
/// mesh with ids out of range, coordinates that are no numbers or repeated nodes is not tested
/// further.
///
/// Boundary faces are the faces with an element on one side only. All counts of faces at an edge or
/// node are of boundary faces: interior faces may meet there in any number.
enum class Defect {
    no_elements,            ///< nothing to work on
    node_out_of_range,      ///< an element, face or feature refers to something that is not there
    not_finite,             ///< a coordinate is NaN or infinite
    repeated_node,          ///< a node twice in one element or face
    duplicate_element,      ///< two elements on the same nodes
    inverted_element,       ///< negative orientation (exact)
    flat_element,           ///< zero volume (exact)
    orphan_node,            ///< no element uses the node
    facet_shared_too_often, ///< more than two elements on one facet, or two on the same side of it
    boundary_without_face,  ///< a facet of one element only is missing from `faces`
    face_without_element,   ///< a face that is no element's facet
    duplicate_face,         ///< two faces on the same nodes
    face_turned_inward,     ///< a boundary face whose normal points into the domain
    boundary_not_closed,    ///< a ridge (3-D) or node (2-D) of the boundary with an odd number of
                            ///< faces
    boundary_not_manifold,  ///< more than two boundary faces at an edge (3-D) or a node (2-D)
    node_not_manifold,      ///< the boundary faces at a node fall into several fans (3-D)
    volumes_do_not_add_up   ///< sum of volumes differs from the flux through the boundary by more
                            ///< than rounding explains; tested when nothing else is wrong
};

[[nodiscard]] std::string_view name(Defect defect);

/// One kind of defect that was found.
struct Finding {
    Defect defect;
    std::int64_t count;  ///< how often
    std::string example; ///< the first one: which entity, which nodes, 0-based
};

struct CheckReport {
    std::vector<Finding> errors;     ///< empty for a valid mesh
    std::vector<Finding> warnings;   ///< unusual, but workable: nodes that no element uses
    std::int64_t interior_faces = 0; ///< faces with an element on both sides
    double volume = 0;               ///< sum of element volumes (areas in 2-D) [L^D]
    double boundary_flux = 0; ///< the same from the divergence theorem over the boundary [L^D]

    [[nodiscard]] bool valid() const { return errors.empty(); }
    /// All errors in one line, for a message.
    [[nodiscard]] std::string summary() const;
};

/// Tests every invariant of `mesh` with exact orientations. Linear in its size; changes nothing.
template <int D>
[[nodiscard]] CheckReport check(const Mesh<D>& mesh);

} // namespace ameco
