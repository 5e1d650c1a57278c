// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The metric whose squared distances to some others have the smallest sum: their geodesic mean.
#pragma once

#include "core/metric/metric.h"

#include <span>

namespace ameco {

enum class GeodesicStep {
    newton, ///< converges from anywhere
    fixed   ///< Algorithm 3 as the paper has it; diverges where directions differ in thin layers
};

struct GeodesicOptions {
    GeodesicStep step = GeodesicStep::newton;
    double tolerance = 1e-12; ///< on the residual [-]; at least what rounding allows is granted
    int iterations = 200;     ///< at most, >= 1
};

template <int D>
struct GeodesicMean {
    Metric<D> mean; ///< where the iteration ended
    int iterations = 0;
    double residual = 0; ///< norm of the mean tangent vector at `mean` [-]
    bool converged = false;
};

/// Intrinsic (Frechet, Karcher) mean: the only R that minimises
///
///     j(R) = 1/(2n) sum over k of d(R, M_k)^2        (11)
///
/// with the invariant distance d (geodesic.h). Its gradient is minus the mean X of the tangent
/// vectors log_R(M_k), and j is convex along geodesics by at least that of a parabola, so the
/// residual |X|_R bounds the distance to the mean: a residual of 1e-8 leaves 5e-9 of a size open.
///
/// `fixed` is Algorithm 3: from M_1, R := exp_R(X). Where directions differ by an angle a at aspect
/// ratio r the second derivative of j is about log(a r), and from 2 on a step of 1 goes too far.
/// `newton` starts from the log-Euclidean mean and takes R := exp_R(t H^-1 X). The Hessian H of j
/// is known in closed form, since the space is symmetric: in the eigenvectors of log_R(M_k), whose
/// eigenvalues are l, that of d^2/2 is diagonal with entries x coth x, x = (l_i - l_j)/2. The step
/// t = 1 is halved until j falls by 1e-4 of what the slope promises, so it converges from anywhere;
/// 4 to 8 iterations are usual.
///
/// \param metrics  at least one, valid
/// \see docs/theory/geodesic.md, "The mean"; paper, section 2.3.3
template <int D>
[[nodiscard]] GeodesicMean<D> geodesic_mean(std::span<const Metric<D>> metrics,
                                            const GeodesicOptions& options = {});

} // namespace ameco
