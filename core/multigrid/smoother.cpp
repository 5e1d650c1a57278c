// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/smoother.h"

#include "core/multigrid/random_vector.h"

namespace ameco {

std::string_view name(SmootherKind kind) {
    switch (kind) {
    case SmootherKind::jacobi:
        return "jacobi";
    case SmootherKind::gauss_seidel:
        return "gauss-seidel";
    case SmootherKind::chebyshev:
        return "chebyshev";
    case SmootherKind::line:
        return "line";
    }
    return "";
}

Smoother::Smoother(const SparseMatrix& A, const SmootherOptions& options, const UnknownLines& lines)
    : A_(A), options_(options), inverse_diagonal_(A.diagonal().cwiseInverse()) {
    if (options_.kind == SmootherKind::chebyshev) {
        estimate_largest_eigenvalue();
    }
    if (options_.kind == SmootherKind::line) {
        factorise_lines(lines);
    }
}

void Smoother::before(const Vector& b, Vector& x, int steps) const {
    switch (options_.kind) {
    case SmootherKind::jacobi:
        return jacobi(b, x, steps);
    case SmootherKind::gauss_seidel:
        for (int i = 0; i < steps; ++i) {
            sweep(b, x, true);
        }
        return;
    case SmootherKind::chebyshev:
        return chebyshev(b, x, steps);
    case SmootherKind::line:
        return solve_lines(b, x, steps);
    }
}

void Smoother::after(const Vector& b, Vector& x, int steps) const {
    if (options_.kind != SmootherKind::gauss_seidel) {
        return before(b, x, steps); // all others are their own adjoints
    }
    for (int i = 0; i < steps; ++i) {
        sweep(b, x, false);
    }
}

void Smoother::jacobi(const Vector& b, Vector& x, int steps) const {
    for (int i = 0; i < steps; ++i) {
        const Vector r = b - A_ * x;
        x += options_.damping * inverse_diagonal_.cwiseProduct(r);
    }
}

void Smoother::sweep(const Vector& b, Vector& x, bool forward) const {
    const int n = static_cast<int>(A_.rows());
    const int* const start = A_.outerIndexPtr();
    const int* const column = A_.innerIndexPtr();
    const double* const value = A_.valuePtr();
    for (int k = 0; k < n; ++k) {
        const int i = forward ? k : n - 1 - k;
        double r = b[i];
        for (int j = start[i]; j < start[i + 1]; ++j) {
            r -= value[j] * x[column[j]];
        }
        x[i] += inverse_diagonal_[i] * r;
    }
}

/// Chebyshev iteration on [share x l, l], l the largest eigenvalue of D^-1 A (Adams et al. 2003).
void Smoother::chebyshev(const Vector& b, Vector& x, int degree) const {
    const double top = largest_eigenvalue_;
    const double bottom = options_.chebyshev_lower_share * top;
    const double theta = (top + bottom) / 2;
    const double delta = (top - bottom) / 2;
    const double sigma = theta / delta;
    double rho = 1 / sigma;
    Vector d = inverse_diagonal_.cwiseProduct(b - A_ * x) / theta;
    x += d;
    for (int k = 1; k < degree; ++k) {
        const double next = 1 / (2 * sigma - rho);
        d = next * rho * d +
            (2 * next / delta) * inverse_diagonal_.cwiseProduct(Vector(b - A_ * x));
        x += d;
        rho = next;
    }
}

void Smoother::estimate_largest_eigenvalue() {
    Vector v = random_vector(A_.rows());
    constexpr int iterations = 15;
    for (int i = 0; i < iterations; ++i) {
        v.normalize();
        v = inverse_diagonal_.cwiseProduct(A_ * v);
        largest_eigenvalue_ = v.norm();
    }
    // The power method approaches from below; above the interval Chebyshev polynomials explode.
    largest_eigenvalue_ *= 1.1;
}

void Smoother::factorise_lines(const UnknownLines& lines) {
    const auto n = static_cast<std::size_t>(A_.rows());
    lower_.assign(n, 0);
    upper_.assign(n, 0);
    pivot_.assign(n, 0);
    std::vector<std::uint8_t> on_line(n, 0);
    lines_ = lines;
    for (const auto& line : lines_) {
        for (const int i : line) {
            on_line[static_cast<std::size_t>(i)] = 1;
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (on_line[i] == 0) {
            lines_.push_back({static_cast<int>(i)});
        }
    }
    for (const auto& line : lines_) {
        for (std::size_t k = 0; k < line.size(); ++k) {
            const auto i = static_cast<std::size_t>(line[k]);
            pivot_[i] = A_.coeff(line[k], line[k]);
            if (k > 0) {
                const auto before = static_cast<std::size_t>(line[k - 1]);
                upper_[before] = A_.coeff(line[k - 1], line[k]);
                lower_[i] = A_.coeff(line[k], line[k - 1]) / pivot_[before];
                pivot_[i] -= lower_[i] * upper_[before];
            }
        }
    }
}

void Smoother::solve_lines(const Vector& b, Vector& x, int steps) const {
    for (int step = 0; step < steps; ++step) {
        Vector r = b - A_ * x;
        for (const auto& line : lines_) {
            for (std::size_t k = 1; k < line.size(); ++k) {
                r[line[k]] -= lower_[static_cast<std::size_t>(line[k])] * r[line[k - 1]];
            }
            for (std::size_t k = line.size(); k-- > 0;) {
                const auto i = static_cast<std::size_t>(line[k]);
                if (k + 1 < line.size()) {
                    r[line[k]] -= upper_[i] * r[line[k + 1]];
                }
                r[line[k]] /= pivot_[i];
            }
        }
        x += options_.damping * r;
    }
}

} // namespace ameco
