// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A triangulated unit sphere.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ameco {

struct SphereSurface {
    std::vector<Vec<3>> points;                ///< on the unit sphere
    std::vector<std::array<int, 3>> triangles; ///< counter-clockwise seen from outside
};

/// The icosahedron with every edge cut into `frequency` pieces, put on the unit sphere:
/// 10 frequency^2 + 2 nodes.
///
/// \param displace  largest displacement of a node along the sphere, over the mean edge [-], <= 0.2
/// \param flips     share of edges that are then flipped at random where the two triangles stay
///                  well shaped, in [0, 1]: the number of neighbours of a node varies
[[nodiscard]] SphereSurface icosphere(int frequency, double displace, double flips,
                                      std::uint64_t seed);

} // namespace ameco
