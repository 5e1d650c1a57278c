// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The paper's synthetic box.
#pragma once

#include "core/cases/extrusion.h"

namespace ameco {

/// A box of nx x ny x nz bricks of dx x dx x dz, each cut into two prisms and each of these into
/// three tets; in 2-D nx x nz rectangles of dx x dz, each cut into two triangles. The defaults are
/// the mesh of the paper's section 5.1: 27 nodes in three layers, of which one coarsening should
/// leave 18.
struct BoxOptions {
    int nx = 2, ny = 2, nz = 2; ///< cells, >= 1; ny is for 3-D only
    double dx = 1;              ///< length of a cell along x and y [L], > 0
    double ratio = 1e-3;        ///< dz / dx [-], > 0
    Diagonals diagonals = Diagonals::uniform;
    int seed = 1;    ///< of random diagonals
    int every = 1;   ///< keep every n-th layer, >= 1
    int shuffle = 0; ///< seed of a random numbering; 0 keeps layer by layer
};

template <int D>
[[nodiscard]] Mesh<D> make_box(const BoxOptions& options = {});

} // namespace ameco
