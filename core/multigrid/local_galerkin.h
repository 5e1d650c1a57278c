// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A coarse matrix that is Galerkin's where the rediscretised one is too soft, and sparse
/// elsewhere.
#pragma once

#include "core/mesh/mesh.h"
#include "core/multigrid/model_problem.h"
#include "core/multigrid/sparse.h"

namespace ameco {

/// Both matrices are sums over elements: A_c = sum of A_E over coarse ones, P^T A P = sum of
/// P^T A_e P over fine ones. With S the coarse nodes where (P^T A P)_ii > limit (A_c)_ii,
///
///     sum of A_E, E without a node in S,
///     + sum of P^T A_e P, e with a node that is interpolated from a node in S.
///
/// Every term is positive semi-definite and has constants in its kernel, and together the elements
/// cover the domain: the matrix is symmetric positive definite with any Dirichlet node. Where the
/// two sets of elements overlap, about one fine element wide, it is stiffer than either.
///
/// \param fine, coarse  meshes of two levels
/// \param P             prolongation [n_f, n_c]
/// \param ratios        (P^T A P)_ii / (A_c)_ii, one per coarse node
/// \param limit         > 1 [-]
/// \return              for all coarse nodes, without boundary conditions
/// \see docs/theory/multigrid.md
template <int D>
[[nodiscard]] SparseMatrix local_galerkin(const Mesh<D>& fine, const Mesh<D>& coarse,
                                          const SparseMatrix& P, const Vector& ratios,
                                          const ModelProblem<D>& problem, double limit = 1.25);

} // namespace ameco
