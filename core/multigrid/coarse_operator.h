// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Matrices for the coarse levels.
#pragma once

#include "core/multigrid/sparse.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ameco {

enum class CoarseOperator : std::uint8_t {
    rediscretised, ///< finite elements on the coarse mesh: sparse, but may be too soft
    galerkin,      ///< P^T A P: never too soft, but denser from level to level
    stiffened,     ///< rediscretised, made stiffer where P^T A P says it is too soft
    local_galerkin ///< rediscretised, but P^T A P where that is too soft (local_galerkin.h)
};

inline constexpr std::array all_coarse_operators{
    CoarseOperator::rediscretised, CoarseOperator::stiffened, CoarseOperator::local_galerkin,
    CoarseOperator::galerkin};

[[nodiscard]] std::string_view name(CoarseOperator kind);

/// P^T A P.
[[nodiscard]] SparseMatrix galerkin_product(const SparseMatrix& A, const SparseMatrix& P);

/// Adds stiffness to a coarse matrix where its basis functions have less energy than on the fine
/// mesh:
///
///     s_i = max(1, (P^T A P)_ii / (A_c)_ii)
///     A_c + sum over a_ij < 0 of (sqrt(s_i s_j) - 1) |a_ij| (e_i - e_j)(e_i - e_j)^T
///
/// Same sparsity; stays symmetric positive definite, as positive semi-definite matrices are added;
/// constants stay in the kernel of what is added; nothing ever becomes softer. Where the coarse
/// matrix is softer than the Galerkin product, coarse corrections overshoot by s: above 2 they
/// enlarge the error.
/// \param ratios  (P^T A P)_ii / (A_c)_ii, see `galerkin_ratios`
[[nodiscard]] SparseMatrix stiffened(const SparseMatrix& coarse_A, const Vector& ratios);

} // namespace ameco
