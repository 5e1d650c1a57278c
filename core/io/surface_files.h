// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Surfaces in STL, OBJ, PLY and OFF, through OpenMesh's own readers and writers.
///
/// Read are points and faces, whether they fit together or not; quadrilaterals are split, other
/// polygons refused. Of a mesh with volume, the boundary is written. OpenMesh 9 writes surfaces
/// that are manifold only, with 32-bit coordinates.
#pragma once

#include "core/io/format.h"

namespace ameco::surface_files {

/// \param suffix  without the dot, in lower case: stl, obj, ply or off
[[nodiscard]] MeshFile read(const Source& source, const std::string& suffix);
/// \param suffix  as above, or "stla" for STL as text
/// \throws UsageError  the surface is not manifold
std::vector<std::string> write(const std::filesystem::path& path, const std::string& suffix,
                               const Mesh<3>& mesh);

} // namespace ameco::surface_files
