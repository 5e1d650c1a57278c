// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A boundary layer over a plate, flat or bent.
#pragma once

#include "core/cases/extrusion.h"

namespace ameco {

/// nx x ny x nz cells over a plate of length 1 and width ny / nx (2-D: nx x nz over a line of
/// length 1). The first layer has height dx / aspect_ratio with dx = 1 / nx; heights then grow
/// until they are dx and stay so.
///
/// Wall nodes are displaced at random, and their columns with them, as in real viscous meshes,
/// where the thin layers follow the surface mesh; `jitter` moves single nodes along their columns.
/// Nodes on the sides stay on them, those at the edges of the plate on the edges. With a curvature
/// radius the plate is bent about the y axis (in 2-D about a point): the columns are the
/// cylinder's radii.
struct LayerOptions {
    int nx = 24, ny = 24, nz = 32; ///< cells, >= 1; ny is for 3-D only
    double aspect_ratio = 1e4;     ///< dx over the first height [-], >= 1
    double growth = 1.2;           ///< of the heights from layer to layer [-], >= 1
    double displace = 0.2;         ///< largest displacement of a column in dx, 0 ... 0.24
    double jitter = 0;    ///< largest movement along the column over local height, 0 ... 0.3
    double curvature = 0; ///< radius [L]: > 0 convex, < 0 concave, 0 flat
    Diagonals diagonals = Diagonals::columns;
    int seed = 1;    ///< of displacements and diagonals
    int every = 1;   ///< keep every n-th layer, >= 1
    int shuffle = 0; ///< seed of a random numbering; 0 keeps layer by layer
};

/// \throws UsageError if a concave plate's layers would reach the axis of the cylinder, or a plate
///         would bend over more than half of it
template <int D>
[[nodiscard]] Mesh<D> make_layer(const LayerOptions& options = {});

} // namespace ameco
