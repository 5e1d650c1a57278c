// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Smoothers: a few steps of a simple iteration that damps the errors a coarse mesh cannot see.
#pragma once

#include "core/multigrid/sparse.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace ameco {

enum class SmootherKind : std::uint8_t {
    jacobi,       ///< damped
    gauss_seidel, ///< forward before, backward after the coarse correction
    chebyshev,    ///< polynomial in the diagonally scaled matrix, one degree per step
    line          ///< damped Jacobi with each line of nodes solved as a block
};

[[nodiscard]] std::string_view name(SmootherKind kind);

struct SmootherOptions {
    SmootherKind kind = SmootherKind::gauss_seidel;
    double damping = 2.0 / 3;           ///< of Jacobi and of lines
    double chebyshev_lower_share = 0.3; ///< of the spectrum's upper end: where damping begins [-]
};

/// Chains of unknowns, each in its order, in no unknown twice; unknowns on no line are lines of
/// one.
using UnknownLines = std::vector<std::vector<int>>;

/// A smoother for one matrix, which must outlive it.
class Smoother {
public:
    /// \param lines  for SmootherKind::line only
    Smoother(const SparseMatrix& A, const SmootherOptions& options, const UnknownLines& lines = {});

    /// `steps` steps before the coarse correction: improves x with A x = b.
    void before(const Vector& b, Vector& x, int steps) const;
    /// The adjoint of `before`, so that a cycle with both is symmetric.
    void after(const Vector& b, Vector& x, int steps) const;

private:
    void jacobi(const Vector& b, Vector& x, int steps) const;
    void sweep(const Vector& b, Vector& x, bool forward) const;
    void chebyshev(const Vector& b, Vector& x, int degree) const;
    void solve_lines(const Vector& b, Vector& x, int steps) const;
    void estimate_largest_eigenvalue();
    void factorise_lines(const UnknownLines& lines);

    const SparseMatrix& A_;
    SmootherOptions options_;
    Vector inverse_diagonal_;
    double largest_eigenvalue_ = 0; ///< of the diagonally scaled matrix
    UnknownLines lines_;
    std::vector<double> lower_, upper_, pivot_; ///< LU of the lines' tridiagonal blocks, by unknown
};

} // namespace ameco
