// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/geodesic_mean.h"

#include "core/metric/geodesic.h"
#include "core/metric/means.h"
#include "core/metric/symmetric_eigen.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Cholesky>

namespace ameco {
namespace {

template <int D>
using SymmetricVec = Eigen::Matrix<double, tensor_size<D>, 1>;
template <int D>
using SymmetricMat = Eigen::Matrix<double, tensor_size<D>, tensor_size<D>>;

/// Entries of a symmetric matrix, those beside the diagonal times sqrt(2): the scalar product of
/// vectors is then that of matrices.
template <int D>
SymmetricVec<D> to_vector(const Mat<D>& X) {
    SymmetricVec<D> v;
    int n = 0;
    for (int i = 0; i < D; ++i) {
        for (int j = i; j < D; ++j) {
            v[n++] = i == j ? X(i, j) : std::numbers::sqrt2 * X(i, j);
        }
    }
    return v;
}

template <int D>
Mat<D> from_vector(const SymmetricVec<D>& v) {
    Mat<D> X;
    int n = 0;
    for (int i = 0; i < D; ++i) {
        for (int j = i; j < D; ++j) {
            X(i, j) = X(j, i) = i == j ? v[n] : v[n] / std::numbers::sqrt2;
            ++n;
        }
    }
    return X;
}

/// x coth x.
double curvature(double x) {
    x = std::abs(x);
    return x < 1e-3 ? 1 + x * x / 3 : x / std::tanh(x);
}

/// Hessian of d(., M)^2 / 2 where the logarithm of M is `L`.
template <int D>
SymmetricMat<D> hessian_of_one(const Mat<D>& L) {
    Columns<D, double> A{};
    for (int j = 0; j < D; ++j) {
        for (int i = 0; i <= j; ++i) {
            A[j][i] = L(i, j);
        }
    }
    Columns<D, double> V = identity<D>();
    diagonalise(A, V);
    SymmetricMat<D> H = SymmetricMat<D>::Zero();
    for (int i = 0; i < D; ++i) {
        for (int j = i; j < D; ++j) {
            const Eigen::Map<const Vec<D>> v(V[i].data());
            const Eigen::Map<const Vec<D>> w(V[j].data());
            const Mat<D> both = v * w.transpose();
            const SymmetricVec<D> e =
                to_vector<D>(i == j ? both : (both + both.transpose()) / std::numbers::sqrt2);
            H += curvature((A[i][i] - A[j][j]) / 2) * e * e.transpose();
        }
    }
    return H;
}

/// The tangent vectors from one place to all metrics, and what follows from them.
template <int D>
struct Surroundings {
    std::vector<Mat<D>> logs;
    Mat<D> mean = Mat<D>::Zero();
    double objective = 0; ///< j

    [[nodiscard]] double residual() const { return mean.norm(); }
};

template <int D>
void look_around(const Metric<D>& R, std::span<const Metric<D>> metrics, Surroundings<D>& s) {
    const double n = static_cast<double>(metrics.size());
    s.logs.clear();
    s.mean.setZero();
    s.objective = 0;
    for (const Metric<D>& M : metrics) {
        s.logs.push_back(log_map(R, M).X);
        s.mean += s.logs.back() / n;
        s.objective += s.logs.back().squaredNorm() / (2 * n);
    }
}

template <int D>
Mat<D> newton_step(const Surroundings<D>& s) {
    SymmetricMat<D> H = SymmetricMat<D>::Zero();
    for (const Mat<D>& L : s.logs) {
        H += hessian_of_one<D>(L) / static_cast<double>(s.logs.size());
    }
    return from_vector<D>(H.llt().solve(to_vector<D>(s.mean)));
}

/// What rounding leaves open: directions are known to a few units in their last place, which at
/// the smallest size counts by the aspect ratio.
template <int D>
double rounding(std::span<const Metric<D>> metrics) {
    double largest = 1;
    for (const Metric<D>& M : metrics) {
        largest = std::max(largest, aspect_ratio(M));
    }
    return 8 * std::numeric_limits<double>::epsilon() * largest;
}

template <int D>
GeodesicMean<D> descend(Metric<D> R, std::span<const Metric<D>> metrics,
                        const GeodesicOptions& options) {
    constexpr double enough = 1e-4;
    constexpr double shortest = 1e-10;
    const double tolerance = std::max(options.tolerance, rounding(metrics));
    Surroundings<D> here;
    Surroundings<D> there;
    look_around(R, metrics, here);
    GeodesicMean<D> result{R, 0, here.residual(), here.residual() <= tolerance};
    while (!result.converged && result.iterations < options.iterations) {
        const Mat<D> step = newton_step(here);
        const double slope = step.cwiseProduct(here.mean).sum();
        const double noise = tolerance * std::sqrt(2 * here.objective);
        double t = 1;
        for (; t > shortest; t /= 2) {
            R = exp_map(result.mean, Tangent<D>{t * step});
            if (is_valid(R)) {
                look_around(R, metrics, there);
                if (there.objective <= here.objective - enough * t * slope + noise) {
                    break;
                }
            }
        }
        if (t <= shortest) {
            break;
        }
        std::swap(here, there);
        ++result.iterations;
        result.mean = R;
        result.residual = here.residual();
        result.converged = result.residual <= tolerance;
    }
    return result;
}

template <int D>
GeodesicMean<D> follow_algorithm_3(std::span<const Metric<D>> metrics,
                                   const GeodesicOptions& options) {
    const double tolerance = std::max(options.tolerance, rounding(metrics));
    Surroundings<D> here;
    look_around(metrics[0], metrics, here);
    GeodesicMean<D> result{metrics[0], 0, here.residual(), here.residual() <= tolerance};
    while (!result.converged && result.iterations < options.iterations) {
        const Metric<D> next = exp_map(result.mean, Tangent<D>{here.mean});
        if (!is_valid(next)) {
            break; // it has left the range of the numbers
        }
        look_around(next, metrics, here);
        if (!std::isfinite(here.residual())) {
            break;
        }
        ++result.iterations;
        result.mean = next;
        result.residual = here.residual();
        result.converged = result.residual <= tolerance;
    }
    return result;
}

} // namespace

template <int D>
GeodesicMean<D> geodesic_mean(std::span<const Metric<D>> metrics, const GeodesicOptions& options) {
    if (options.step == GeodesicStep::fixed) {
        return follow_algorithm_3(metrics, options);
    }
    return descend(mean_of(metrics, Mean::log_euclidean), metrics, options);
}

template GeodesicMean<2> geodesic_mean(std::span<const Metric<2>>, const GeodesicOptions&);
template GeodesicMean<3> geodesic_mean(std::span<const Metric<3>>, const GeodesicOptions&);

} // namespace ameco
