// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The boundary of a mesh: find it, turn it outwards, give it patches.
#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ameco {

/// What `complete_boundary` had to mend.
struct BoundaryRepair {
    std::int64_t faces_added = 0;     ///< boundary facets that the file did not list
    std::int64_t faces_turned = 0;    ///< faces listed with an inward normal
    bool elements_turned = false;     ///< all elements were listed with negative orientation
    std::int64_t orphans_removed = 0; ///< nodes no element uses
    int first_new_patch = 0;          ///< patch id given to the added faces, one above the file's
};

/// Makes `mesh` keep the conventions of mesh.h where that loses nothing: turns boundary faces
/// outwards, adds boundary facets that are missing (each run of them bounded by sharp edges gets a
/// new patch, with the dihedral angle `ridge_angle_deg`), turns *all* elements if all are
/// negative, and drops nodes that no element uses. Leaves genuine defects alone for `check` to
/// name.
template <int D>
BoundaryRepair complete_boundary(Mesh<D>& mesh, double ridge_angle_deg = 40.0);

/// What was mended, one line each.
[[nodiscard]] std::vector<std::string> repair_remarks(const BoundaryRepair& repair);

} // namespace ameco
