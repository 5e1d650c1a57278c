// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The equations on which a hierarchy is judged, discretised with linear finite elements.
#pragma once

#include "core/base/vec.h"
#include "core/mesh/mesh.h"
#include "core/multigrid/sparse.h"

#include <vector>

namespace ameco {

/// - div(K grad u) + b . grad u = f
template <int D>
struct ModelProblem {
    Mat<D> diffusion = Mat<D>::Identity(); ///< K, symmetric positive definite
    Vec<D> velocity = Vec<D>::Zero();      ///< b
    /// Patches with Dirichlet conditions, where they are not empty; the others then have Neumann
    /// conditions. Empty: Dirichlet conditions on the whole boundary.
    std::vector<int> dirichlet_patches;
};

/// Matrix of the problem for all n nodes of the mesh, without boundary conditions: the stiffness
/// matrix, and for the convection its Galerkin matrix with just as much discrete diffusion as makes
/// it monotone (algebraic upwinding, Kuzmin 2001): first order on every mesh, and the same rule on
/// every level. Each row sums to zero.
template <int D>
[[nodiscard]] SparseMatrix assemble(const Mesh<D>& mesh, const ModelProblem<D>& problem);

/// Right-hand side for f = 1: the volume of each node.
template <int D>
[[nodiscard]] Vector unit_load(const Mesh<D>& mesh);

/// The nodes without Dirichlet condition, ascending: the unknowns.
/// \throws UsageError when there is no Dirichlet node, or a patch of the problem is not in the mesh
template <int D>
[[nodiscard]] std::vector<NodeId> free_nodes(const Mesh<D>& mesh, const ModelProblem<D>& problem);

/// The rows and columns of `matrix` that belong to unknowns.
[[nodiscard]] SparseMatrix restricted(const SparseMatrix& matrix, const std::vector<NodeId>& rows,
                                      const std::vector<NodeId>& columns);
[[nodiscard]] Vector restricted(const Vector& vector, const std::vector<NodeId>& rows);

} // namespace ameco
