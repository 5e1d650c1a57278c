// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// From a surface to a mesh: which side is inside, what surrounds it, what stays empty.
#pragma once

#include "core/recovery/boundary_recovery.h"
#include "core/recovery/farfield.h"

#include <optional>

namespace ameco {

struct FillOptions {
    RecoveryOptions recovery; ///< its `holes` are joined by those that follow from the surface
    std::optional<Farfield> farfield; ///< fill the space around the surface up to here
};

struct Fill {
    Mesh<3> mesh; ///< valid; the surface's nodes first, then the farfield's, then new ones
    std::int64_t surface_nodes = 0; ///< of the surface and the farfield together
    std::vector<Vec<3>> empty;      ///< a point in each part of space that was left empty
    Recovery recovery;              ///< without its mesh
};

/// Fills the volume that a surface bounds: the outermost parts hold it, parts directly inside them
/// are walls of cavities, parts in those hold volume again, and so on. With a farfield that is one
/// more part around all others, so that the space around the surface is filled. A part with a
/// region seed in it is filled, too, and its faces become a border between regions.
///
/// The surface must be sound: intersections, holes and the like are refused, with the faces named.
/// \throws as `recover_boundary` and `make_farfield` do
[[nodiscard]] Fill fill_surface(const Mesh<3>& surface, const FillOptions& options,
                                const std::string& name, Monitor& monitor = Monitor::silent());

/// A point inside a closed part of a surface, well away from its faces: half way through it from
/// the middle of the face where that way is longest.
/// \param part  index of the part in `part_of`
/// \throws InputError  no such point is found: the part is too thin for the numbers
[[nodiscard]] Vec<3> point_inside(const Mesh<3>& surface, const IdVector<FaceId, int>& part_of,
                                  int part);

/// A point in each part of space inside a sound surface that its volume leaves out: cavities whose
/// walls are directly inside an outer part, and so on.
/// \throws InputError  as `point_inside`
[[nodiscard]] std::vector<Vec<3>> points_in_cavities(const Mesh<3>& surface);

} // namespace ameco
