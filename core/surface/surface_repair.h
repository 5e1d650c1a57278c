// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Mends what can be mended in a surface without moving a point of it.
#pragma once

#include "core/surface/surface_report.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ameco {

/// What `repair_surface` did.
struct SurfaceRepair {
    std::int64_t nodes_merged = 0;  ///< at the same point as another, to the bit
    std::int64_t faces_dropped = 0; ///< on the same nodes as another, or with a node twice
    std::int64_t edges_flipped = 0; ///< longest edges of faces without area
    std::int64_t faces_turned = 0;  ///< against their neighbours, or inwards
    std::int64_t nodes_dropped = 0; ///< that no face uses

    [[nodiscard]] bool nothing() const {
        return nodes_merged + faces_dropped + edges_flipped + faces_turned + nodes_dropped == 0;
    }
};

/// Merges nodes at the same point, drops faces that are there twice or have a node twice, flips the
/// longest edge of faces without area (so that the face beside it takes the point in), turns faces
/// until neighbours agree and closed parts have normals that point out of the volume: the outermost
/// parts outwards, parts directly inside them inwards, as the walls of cavities, and so on. The set
/// of points that the surface covers stays the same. Elements of the mesh are dropped.
///
/// Holes, edges of more than two faces and intersections stay: `inspect_surface` names them.
/// \throws InputError  references or coordinates that make no sense
SurfaceRepair repair_surface(Mesh<3>& mesh);

/// Whether `repair_surface` would make a sound surface of one that is not.
/// \param report  of the surface, with intersections looked for
[[nodiscard]] bool repair_helps(const Mesh<3>& surface, const SurfaceReport& report);

/// What was done, one line each.
[[nodiscard]] std::vector<std::string> repair_remarks(const SurfaceRepair& repair);

} // namespace ameco
