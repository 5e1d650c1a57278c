// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The sparse matrix and vector types of multigrid.
#pragma once

#include <Eigen/SparseCore>

namespace ameco {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>; ///< compressed rows
using Vector = Eigen::VectorXd;

} // namespace ameco
