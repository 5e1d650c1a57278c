// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Barycentric coordinates in a triangle or tetrahedron, and their gradients.
#pragma once

#include "core/base/vec.h"

#include <array>

namespace ameco {

/// Barycentric coordinates of `p`, sum 1: all are >= 0 inside, some negative outside. From the
/// volumes of the simplices that `p` makes with the facets; their error is about eps x aspect
/// ratio. \param corners  of a simplex whose volume is not zero
template <int D>
[[nodiscard]] std::array<double, D + 1> barycentric(const std::array<Vec<D>, D + 1>& corners,
                                                    const Vec<D>& p);

/// Gradients of the barycentric coordinates, which are the linear basis functions, times D! times
/// the volume [L^(D-1)]: normals of the facets opposite each corner, pointing inwards.
[[nodiscard]] std::array<Vec<2>, 3> scaled_gradients(const std::array<Vec<2>, 3>& corners);
[[nodiscard]] std::array<Vec<3>, 4> scaled_gradients(const std::array<Vec<3>, 4>& corners);

} // namespace ameco
