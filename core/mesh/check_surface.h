// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Whether a surface without elements bounds a volume.
#pragma once

#include "core/mesh/check.h"

namespace ameco {

/// Tests the faces of a mesh that has no elements: each edge is to belong to two faces that run
/// through it in opposite directions, and the normals are to point out of the volume. Findings are
/// those of `check`: `boundary_not_closed` for an edge of one face, `boundary_not_manifold` for one
/// of more than two, `face_turned_inward` for an edge whose two faces disagree, and for a surface
/// that as a whole encloses a negative volume. \return  `volume` and `boundary_flux` are the volume
/// enclosed [L^3]
[[nodiscard]] CheckReport check_surface(const Mesh<3>& mesh);

} // namespace ameco
