// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The space around a sphere or an ellipsoid, with layers on it.
#pragma once

#include "core/cases/extrusion.h"

namespace ameco {

/// A displaced icosphere, stretched to the half axes a, b, c, whose columns follow the confocal
/// coordinate lines (for a sphere: the radii) out to the confocal ellipsoid of half axis
/// `far_field` along x: smooth curves that meet all of these ellipsoids at right angles.
///
/// Heights grow by `growth` from `first_height` until they reach the size of the mesh within the
/// layer, which itself grows with the distance.
/// Patches: 1 wall, 2 farfield.
struct ShellOptions {
    double a = 1, b = 1, c = 1; ///< half axes along x, y, z [L], > 0, a >= b >= c
    int frequency = 16;         ///< of the icosphere: 10 frequency^2 + 2 wall nodes, >= 2
    double aspect_ratio = 1e4;  ///< mean edge of the wall over the first height [-], >= 1
    double growth = 1.2;        ///< of the heights [-], > 1
    double far_field = 10;      ///< half axis of the far field along x over a [-], > 1
    double cluster = 0.5;       ///< nodes drawn to the ends of the long axis, 0 ... 1
    double displace = 0.15;     ///< of wall nodes, over the mean edge [-], 0 ... 0.2
    double flips = 0.2;         ///< share of wall edges flipped at random, 0 ... 1
    Diagonals diagonals = Diagonals::columns;
    int seed = 1;    ///< of displacements, flips and diagonals
    int every = 1;   ///< keep every n-th layer, >= 1
    int shuffle = 0; ///< seed of a random numbering; 0 keeps layer by layer
};

/// \throws UsageError if the wall has too few nodes for its curvature
[[nodiscard]] Mesh<3> make_shell(const ShellOptions& options = {});

} // namespace ameco
