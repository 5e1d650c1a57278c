// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The unit cube or square with an isotropic mesh.
#pragma once

#include "core/cases/extrusion.h"

namespace ameco {

/// The unit cube of n^3 cells, each cut into the six tets of Kuhn's subdivision (2-D: n^2 squares
/// cut into two triangles), with its nodes displaced at random: those inside in any direction,
/// those on sides and edges within them. Random diagonals make an irregular mesh.
struct CubeOptions {
    int n = 10;            ///< cells per side, >= 1
    double displace = 0.2; ///< largest displacement in cell sizes, 0 ... 0.2
    Diagonals diagonals = Diagonals::uniform;
    int seed = 1;    ///< of displacements and diagonals
    int shuffle = 0; ///< seed of a random numbering; 0 keeps layer by layer
};

template <int D>
[[nodiscard]] Mesh<D> make_cube(const CubeOptions& options = {});

} // namespace ameco
