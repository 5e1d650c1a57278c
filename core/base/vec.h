// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Small fixed-size vectors and matrices.
#pragma once

#include <Eigen/Core>

namespace ameco {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>; ///< point or vector in D dimensions [L]

template <int D>
using Mat = Eigen::Matrix<double, D, D>;

} // namespace ameco
