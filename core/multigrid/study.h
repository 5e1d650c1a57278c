// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How well multigrid converges on a hierarchy, measured: level by level, and as a whole.
#pragma once

#include "core/multigrid/coarse_operator.h"
#include "core/multigrid/cycle.h"
#include "core/multigrid/error_mode.h"
#include "core/multigrid/model_problem.h"

#include <memory>
#include <vector>

namespace ameco {

/// The equations of a model problem on all levels, 0 is finest.
struct LevelEquations {
    std::vector<std::vector<NodeId>> unknowns; ///< nodes without Dirichlet condition
    MultigridMatrices matrices;                ///< of the unknowns
    /// (P^T A P)_ii / (A_c)_ii of all coarse nodes, A_c rediscretised; ratios[k] is of level k + 1.
    std::vector<IdVector<NodeId, double>> ratios;
    bool symmetric = true;
    double operator_complexity = 1; ///< entries of all matrices over those of the finest
    double grid_complexity = 1;     ///< unknowns of all levels over those of the finest
    double seconds = 0;             ///< spent on the matrices of all levels
};

/// Discretises a problem on every level.
///
/// \param meshes     level 0 first
/// \param transfers  transfers[k]: from level k + 1 to level k
template <int D>
[[nodiscard]] LevelEquations level_equations(const std::vector<Mesh<D>>& meshes,
                                             const std::vector<Transfer>& transfers,
                                             const ModelProblem<D>& problem, CoarseOperator kind);

/// The matrix of a coarse level, for all its nodes.
///
/// \param fine_A    of the fine level, for all its nodes
/// \param coarse_A  the rediscretised one
/// \param ratios    `galerkin_ratios` of these
template <int D>
[[nodiscard]] SparseMatrix coarse_matrix(CoarseOperator kind, const Mesh<D>& fine,
                                         const Mesh<D>& coarse, const SparseMatrix& P,
                                         const SparseMatrix& fine_A, const SparseMatrix& coarse_A,
                                         const Vector& ratios, const ModelProblem<D>& problem);

/// Lines of the unknowns, for the line smoother: without what goes on beyond their ends along
/// weaker couplings. With that, its blocks diverge by themselves where columns are oblique.
template <int D>
[[nodiscard]] UnknownLines smoother_lines(const Mesh<D>& mesh, const Couplings& couplings,
                                          const std::vector<NodeId>& unknowns);

/// Solves on one level to roundings: directly where that is cheap, else by conjugate gradients (or
/// GMRES) with V(2,2). Refers to `equations`.
[[nodiscard]] Solver exact_solver(const LevelEquations& equations, std::size_t level);

/// Two-grid convergence between the levels k and k + 1 with an exact coarse solve.
[[nodiscard]] ConvergenceFactor two_grid(const LevelEquations& equations, std::size_t k,
                                         const CycleOptions& options, const Solver& coarse_solver,
                                         StepLength step = StepLength::full);

/// The whole hierarchy with one kind of cycle.
struct CycleStudy {
    double factor = 0;         ///< stand-alone: ConvergenceFactor::value
    KrylovResult krylov;       ///< CG, or GMRES for unsymmetric problems, f = 1, to 1e-8
    int random_iterations = 0; ///< the same for a random right-hand side
    double setup_seconds = 0, solve_seconds = 0; ///< of the Krylov method with f = 1
    /// Work of one cycle in products with the finest matrix: smoothing and residuals.
    double work_per_cycle = 0;
};

/// \param load  right-hand side at the unknowns of level 0
[[nodiscard]] CycleStudy study_cycle(const LevelEquations& equations, const CycleOptions& options,
                                     const Vector& load);

} // namespace ameco
