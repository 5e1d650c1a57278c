// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/cycle.h"

#include "core/multigrid/random_vector.h"

#include <cmath>
#include <stdexcept>

#include <Eigen/Jacobi>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

namespace ameco {

Solver direct_solver(const SparseMatrix& A, bool symmetric) {
    using ColumnMatrix = Eigen::SparseMatrix<double>;
    if (A.rows() == 0) {
        return [](const Vector& b) { return b; };
    }
    const auto wrap = [&](auto factors) -> Solver {
        factors->compute(ColumnMatrix(A));
        if (factors->info() != Eigen::Success) {
            throw std::runtime_error("the coarsest matrix is singular");
        }
        return [factors](const Vector& b) { return Vector(factors->solve(b)); };
    };
    if (symmetric) {
        return wrap(std::make_shared<Eigen::SimplicialLDLT<ColumnMatrix>>());
    }
    return wrap(std::make_shared<Eigen::SparseLU<ColumnMatrix>>());
}

Multigrid::Multigrid(const MultigridMatrices& matrices, std::size_t first, std::size_t last,
                     const CycleOptions& options, Solver coarse_solver)
    : matrices_(matrices), first_(first), last_(last), options_(options),
      coarse_solver_(std::move(coarse_solver)) {
    static const UnknownLines no_lines;
    for (std::size_t k = first; k < last; ++k) {
        smoothers_.emplace_back(matrices.A[k], options.smoother,
                                k < matrices.lines.size() ? matrices.lines[k] : no_lines);
    }
}

void Multigrid::cycle(std::size_t level, const Vector& b, Vector& x) const {
    if (level == last_) {
        x = coarse_solver_(b);
        return;
    }
    const Smoother& smoother = smoothers_[level - first_];
    const SparseMatrix& P = matrices_.P[level];
    smoother.before(b, x, options_.before);
    const Vector residual = b - matrices_.A[level] * x;
    const Vector coarse_b = P.transpose() * residual;
    Vector correction = Vector::Zero(P.cols());
    const int visits = level + 1 == last_ ? 1 : options_.gamma;
    for (int i = 0; i < visits; ++i) {
        cycle(level + 1, coarse_b, correction);
    }
    x += P * correction;
    smoother.after(b, x, options_.after);
}

ConvergenceFactor convergence_factor(const SparseMatrix& A, const Multigrid& solver,
                                     StepLength step) {
    constexpr int first = 10, last = 20;
    const Vector zero = Vector::Zero(A.rows());
    const auto energy_norm = [&](const Vector& e) { return std::sqrt(e.dot(A * e)); };
    ConvergenceFactor result;
    Vector e = random_vector(A.rows());
    e /= energy_norm(e);
    double log_sum = 0;
    for (int k = 1; k <= last; ++k) {
        Vector next = e;
        solver.cycle(zero, next);
        if (step == StepLength::least_energy) {
            const Vector d = next - e;
            const Vector Ad = A * d;
            next = e - (e.dot(Ad) / d.dot(Ad)) * d;
        }
        e = std::move(next);
        const double norm = energy_norm(e);
        if (!(norm > 0) || !std::isfinite(norm)) {
            result.value = norm > 0 ? norm : 0;
            return result;
        }
        log_sum += k > first ? std::log(norm) : 0;
        e /= norm;
    }
    result.value = std::exp(log_sum / (last - first));
    result.slowest = std::move(e);
    return result;
}

KrylovResult conjugate_gradients(const SparseMatrix& A, const Vector& b,
                                 const Solver& preconditioner, double tolerance,
                                 int most_iterations) {
    KrylovResult result;
    result.x = Vector::Zero(b.size());
    Vector r = b;
    Vector z = preconditioner(r);
    Vector p = z;
    double rz = r.dot(z);
    const double b_norm = b.norm();
    result.residuals.push_back(1);
    while (result.iterations < most_iterations && result.residuals.back() > tolerance) {
        const Vector q = A * p;
        const double alpha = rz / p.dot(q);
        result.x += alpha * p;
        r -= alpha * q;
        ++result.iterations;
        result.residuals.push_back(r.norm() / b_norm);
        z = preconditioner(r);
        const double next = r.dot(z);
        p = z + (next / rz) * p;
        rz = next;
    }
    result.converged = result.residuals.back() <= tolerance;
    return result;
}

KrylovResult gmres(const SparseMatrix& A, const Vector& b, const Solver& preconditioner,
                   double tolerance, int most_iterations) {
    KrylovResult result;
    const double b_norm = b.norm();
    std::vector<Vector> basis{b / b_norm}, directions;
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(most_iterations + 1, most_iterations);
    Vector g = Vector::Zero(most_iterations + 1);
    g[0] = b_norm;
    std::vector<Eigen::JacobiRotation<double>> rotations;
    result.residuals.push_back(1);
    int k = 0;
    while (k < most_iterations && result.residuals.back() > tolerance) {
        directions.push_back(preconditioner(basis.back()));
        Vector w = A * directions.back();
        for (int i = 0; i <= k; ++i) {
            H(i, k) = w.dot(basis[static_cast<std::size_t>(i)]);
            w -= H(i, k) * basis[static_cast<std::size_t>(i)];
        }
        H(k + 1, k) = w.norm();
        const double length = H(k + 1, k);
        for (int i = 0; i < k; ++i) {
            H.col(k).applyOnTheLeft(i, i + 1, rotations[static_cast<std::size_t>(i)].adjoint());
        }
        Eigen::JacobiRotation<double> rotation;
        rotation.makeGivens(H(k, k), H(k + 1, k));
        rotations.push_back(rotation);
        H.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
        g.applyOnTheLeft(k, k + 1, rotation.adjoint());
        ++k;
        result.residuals.push_back(std::abs(g[k]) / b_norm);
        if (length == 0) {
            break;
        }
        basis.push_back(w / length);
    }
    result.x = Vector::Zero(b.size());
    const Vector y = H.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(g.head(k));
    for (int i = 0; i < k; ++i) {
        result.x += y[i] * directions[static_cast<std::size_t>(i)];
    }
    result.iterations = k;
    result.converged = result.residuals.back() <= tolerance;
    return result;
}

Solver as_preconditioner(const Multigrid& solver) {
    return [&solver](const Vector& r) {
        Vector z = Vector::Zero(r.size());
        solver.cycle(r, z);
        return z;
    };
}

} // namespace ameco
