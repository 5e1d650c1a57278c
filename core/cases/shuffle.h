// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The same mesh with its nodes, elements and faces in random order.
#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>

namespace ameco {

/// Renumbers nodes, elements and faces, and turns the numbering inside each of them, by a fixed
/// seed, so that nothing that works on the mesh can lean on the order it was made in. Orientations
/// and the mesh as a set stay the same. For meshes made by formula: labels and features must be
/// empty.
template <int D>
void shuffle(Mesh<D>& mesh, std::uint64_t seed);

} // namespace ameco
