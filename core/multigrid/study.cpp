// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/study.h"

#include "core/base/stopwatch.h"
#include "core/multigrid/local_galerkin.h"
#include "core/multigrid/random_vector.h"

#include <cmath>

namespace ameco {
namespace {

/// Above this many unknowns a direct solver fills memory in 3-D.
constexpr Eigen::Index direct_limit = 15000;

IdVector<NodeId, double> as_nodal(const Vector& values) {
    return IdVector<NodeId, double>(std::vector<double>(values.begin(), values.end()));
}

double work_of(const LevelEquations& equations, const CycleOptions& options) {
    double entries = 0, visits = 1;
    for (std::size_t k = 0; k + 1 < equations.matrices.A.size(); ++k) {
        // Each smoothing step and the residual cost one product with the matrix.
        entries += visits * (options.before + options.after + 1) *
                   static_cast<double>(equations.matrices.A[k].nonZeros());
        visits *= k + 2 == equations.matrices.A.size() ? 1 : options.gamma;
    }
    return entries / static_cast<double>(equations.matrices.A[0].nonZeros());
}

} // namespace

template <int D>
SparseMatrix coarse_matrix(CoarseOperator kind, const Mesh<D>& fine, const Mesh<D>& coarse,
                           const SparseMatrix& P, const SparseMatrix& fine_A,
                           const SparseMatrix& coarse_A, const Vector& ratios,
                           const ModelProblem<D>& problem) {
    switch (kind) {
    case CoarseOperator::rediscretised:
        break;
    case CoarseOperator::galerkin:
        return galerkin_product(fine_A, P);
    case CoarseOperator::stiffened:
        return stiffened(coarse_A, ratios);
    case CoarseOperator::local_galerkin:
        return local_galerkin(fine, coarse, P, ratios, problem);
    }
    return coarse_A;
}

template <int D>
LevelEquations level_equations(const std::vector<Mesh<D>>& meshes,
                               const std::vector<Transfer>& transfers,
                               const ModelProblem<D>& problem, CoarseOperator kind) {
    const Stopwatch watch;
    LevelEquations out;
    out.symmetric = problem.velocity.isZero();
    double entries = 0, nodes = 0;
    // Of all nodes, boundary included: what the next coarser level is compared with. What was
    // stiffened is not: stiffness would pile up from level to level.
    SparseMatrix finer;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        SparseMatrix A = assemble(meshes[k], problem);
        SparseMatrix next = kind == CoarseOperator::galerkin ? SparseMatrix() : A;
        if (k > 0) {
            const Vector ratios = galerkin_ratios(finer, transfers[k - 1].P, A);
            out.ratios.push_back(as_nodal(ratios));
            A = coarse_matrix(kind, meshes[k - 1], meshes[k], transfers[k - 1].P, finer, A, ratios,
                              problem);
        }
        if (kind == CoarseOperator::galerkin) {
            next = A;
        }
        out.unknowns.push_back(free_nodes(meshes[k], problem));
        out.matrices.A.push_back(restricted(A, out.unknowns[k], out.unknowns[k]));
        if (k > 0) {
            out.matrices.P.push_back(
                restricted(transfers[k - 1].P, out.unknowns[k - 1], out.unknowns[k]));
        }
        entries += static_cast<double>(out.matrices.A[k].nonZeros());
        nodes += static_cast<double>(out.unknowns[k].size());
        finer = std::move(next);
    }
    out.operator_complexity = entries / static_cast<double>(out.matrices.A[0].nonZeros());
    out.grid_complexity = nodes / static_cast<double>(out.unknowns[0].size());
    out.seconds = watch.seconds();
    return out;
}

template <int D>
UnknownLines smoother_lines(const Mesh<D>& mesh, const Couplings& couplings,
                            const std::vector<NodeId>& unknowns) {
    LineOptions options;
    options.continuation = options.dominance;
    // Which end a line is numbered from does not matter here.
    const IdVector<NodeId, double> key(mesh.points.size(), 0.0);
    const Lines lines = find_lines(mesh, couplings, key, options);
    std::vector<int> unknown_of(lines.position.size(), -1);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        unknown_of[unknowns[i].index()] = static_cast<int>(i);
    }
    UnknownLines result;
    for (const NodeId start : lines.position.ids()) {
        if (lines.position[start] != 0) {
            continue;
        }
        std::vector<int> line;
        for (NodeId v = start; v.valid(); v = lines.next[v]) {
            if (unknown_of[v.index()] >= 0) {
                line.push_back(unknown_of[v.index()]);
            }
        }
        if (line.size() > 1) {
            result.push_back(std::move(line));
        }
    }
    return result;
}

Solver exact_solver(const LevelEquations& equations, std::size_t level) {
    const MultigridMatrices& m = equations.matrices;
    if (m.A[level].rows() <= direct_limit || level + 1 == m.A.size()) {
        return direct_solver(m.A[level], equations.symmetric);
    }
    CycleOptions options;
    options.before = options.after = 2;
    const auto inner = std::make_shared<Multigrid>(m, level, m.A.size() - 1, options,
                                                   direct_solver(m.A.back(), equations.symmetric));
    return [&m, level, inner, symmetric = equations.symmetric](const Vector& b) {
        constexpr double roundings = 1e-11;
        const Solver preconditioner = as_preconditioner(*inner);
        return symmetric ? conjugate_gradients(m.A[level], b, preconditioner, roundings).x
                         : gmres(m.A[level], b, preconditioner, roundings).x;
    };
}

ConvergenceFactor two_grid(const LevelEquations& equations, std::size_t k,
                           const CycleOptions& options, const Solver& coarse_solver,
                           StepLength step) {
    const MultigridMatrices& m = equations.matrices;
    return convergence_factor(m.A[k], Multigrid(m, k, k + 1, options, coarse_solver), step);
}

CycleStudy study_cycle(const LevelEquations& equations, const CycleOptions& options,
                       const Vector& load) {
    const MultigridMatrices& m = equations.matrices;
    CycleStudy study;
    Stopwatch watch;
    const Multigrid solver(m, 0, m.A.size() - 1, options,
                           direct_solver(m.A.back(), equations.symmetric));
    study.setup_seconds = watch.lap();
    const auto solve = [&](const Vector& b) {
        return equations.symmetric ? conjugate_gradients(m.A[0], b, as_preconditioner(solver))
                                   : gmres(m.A[0], b, as_preconditioner(solver));
    };
    watch.lap();
    study.krylov = solve(load);
    study.solve_seconds = watch.lap();
    study.random_iterations = solve(random_vector(load.size(), 7)).iterations;
    study.factor = convergence_factor(m.A[0], solver).value;
    study.work_per_cycle = work_of(equations, options);
    return study;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template SparseMatrix coarse_matrix(                                                           \
        CoarseOperator, const Mesh<D>&, const Mesh<D>&, const SparseMatrix&, const SparseMatrix&,  \
        const SparseMatrix&, const Vector&, const ModelProblem<D>&);                               \
    template LevelEquations level_equations(const std::vector<Mesh<D>>&,                           \
                                            const std::vector<Transfer>&, const ModelProblem<D>&,  \
                                            CoarseOperator);                                       \
    template UnknownLines smoother_lines(const Mesh<D>&, const Couplings&,                         \
                                         const std::vector<NodeId>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
