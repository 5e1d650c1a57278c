// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The multigrid cycle, stand-alone and as preconditioner.
#pragma once

#include "core/multigrid/smoother.h"
#include "core/multigrid/sparse.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace ameco {

struct CycleOptions {
    SmootherOptions smoother;
    int before = 1, after = 1; ///< smoothing steps, >= 0
    int gamma = 1;             ///< coarse corrections per level: 1 a V-cycle, 2 a W-cycle
};

/// Matrices and prolongations of the unknowns of all levels, 0 is finest.
struct MultigridMatrices {
    std::vector<SparseMatrix> A;     ///< one per level
    std::vector<SparseMatrix> P;     ///< P[k]: from level k + 1 to level k
    std::vector<UnknownLines> lines; ///< of each level, for the line smoother; may be empty
};

/// Solves A x = b approximately or exactly.
using Solver = std::function<Vector(const Vector& b)>;

/// A direct solver: LDL^T for symmetric matrices, LU for others.
/// \throws std::runtime_error for a singular matrix
[[nodiscard]] Solver direct_solver(const SparseMatrix& A, bool symmetric = true);

/// Multigrid over the levels first ... last of `matrices`, which must outlive it.
class Multigrid {
public:
    /// \param coarse_solver  for level `last`
    Multigrid(const MultigridMatrices& matrices, std::size_t first, std::size_t last,
              const CycleOptions& options, Solver coarse_solver);

    /// One cycle: improves x with A x = b on level `first`.
    void cycle(const Vector& b, Vector& x) const { cycle(first_, b, x); }

private:
    void cycle(std::size_t level, const Vector& b, Vector& x) const;

    const MultigridMatrices& matrices_;
    std::size_t first_, last_;
    CycleOptions options_;
    Solver coarse_solver_;
    std::vector<Smoother> smoothers_;
};

/// How far a stand-alone cycle goes along its correction d.
enum class StepLength : std::uint8_t {
    full,        ///< x + d
    least_energy ///< x + a d, a = d.r / d.Ad with r = b - A x: the error's energy norm is least,
                 ///< and never grows; for symmetric matrices. Costs one product with A
};

/// How fast an iteration of cycles converges.
struct ConvergenceFactor {
    double value = 0; ///< geometric mean over cycles 10 ... 20 of |e_new| / |e_old|, energy norm
    Vector slowest;   ///< the error after the last cycle: what converges slowest, energy norm 1
};

/// Runs 20 cycles on A e = 0 from a random start; the error is brought back to norm 1 after each.
[[nodiscard]] ConvergenceFactor convergence_factor(const SparseMatrix& A, const Multigrid& solver,
                                                   StepLength step = StepLength::full);

struct KrylovResult {
    int iterations = 0;
    bool converged = false;
    std::vector<double> residuals; ///< |b - A x| / |b| before the first and after each iteration
    Vector x;
};

/// Conjugate gradients with one cycle as preconditioner, until |b - A x| <= tolerance |b|. The
/// preconditioner must be symmetric: as many steps after as before.
[[nodiscard]] KrylovResult conjugate_gradients(const SparseMatrix& A, const Vector& b,
                                               const Solver& preconditioner,
                                               double tolerance = 1e-8, int most_iterations = 200);

/// GMRES without restart, preconditioned from the right.
[[nodiscard]] KrylovResult gmres(const SparseMatrix& A, const Vector& b,
                                 const Solver& preconditioner, double tolerance = 1e-8,
                                 int most_iterations = 200);

/// One cycle from zero.
[[nodiscard]] Solver as_preconditioner(const Multigrid& solver);

} // namespace ameco
