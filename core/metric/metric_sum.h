// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Means of metrics that come from sums: what one metric adds, and what is made of the sums.
#pragma once

#include "core/base/smooth_fall.h"
#include "core/metric/means.h"
#include "core/metric/symmetric_eigen.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ameco {

/// What a metric adds to a sum.
template <int D>
struct Contribution {
    std::array<double, tensor_size<D>> tensor; ///< V f(h) V^T, upper triangle by rows
    Vec<D> sizes;                              ///< sorted
};

template <int D>
[[nodiscard]] inline Contribution<D> contribution_of(const Metric<D>& metric, Mean mean) {
    Vec<D> values = metric.sizes;
    if (mean == Mean::log_euclidean) {
        values = values.array().log();
    }
    const Mat<D>& V = metric.directions;
    const Mat<D> scaled = V * values.asDiagonal();
    Contribution<D> c;
    std::size_t n = 0;
    for (int i = 0; i < D; ++i) {
        for (int j = i; j < D; ++j) {
            c.tensor[n++] = scaled.row(i).dot(V.row(j));
        }
    }
    c.sizes = metric.sizes;
    return c;
}

/// Sums kept in the place of the resulting metric until `finish` makes it of them: the tensor in
/// the first entries of `directions`, so a field needs no further memory.
template <int D>
[[nodiscard]] inline Metric<D> zero_sum() {
    Metric<D> sum;
    sum.sizes.setZero();
    sum.directions.setZero();
    return sum;
}

template <int D>
inline void add(Metric<D>& sum, const Contribution<D>& c) {
    double* tensor = sum.directions.data();
    for (std::size_t n = 0; n < tensor_size<D>; ++n) {
        tensor[n] += c.tensor[n];
    }
    sum.sizes += c.sizes;
}

/// Sizes of the blended mean.
///
/// The sorted sizes of an element say nothing of their directions, and so their mean keeps sizes
/// apart that belong to no directions in particular: elements of an isotropic mesh have sizes like
/// 0.7, 1, 1.4, all ways round, and (9) makes of them a node of aspect ratio 2. The sizes of (8)
/// know better, but in a fan of directions the large ones spill into the small ones. So a size is
/// drawn towards its neighbour in the order, as far as (8) says and never beyond it, by a weight
/// that falls from 1 where both are equal to 0 where they differ three times and more; there
/// directions have a meaning and (9) is kept.
///
/// \param sorted  (9), ascending
/// \param own     (8), ascending
template <int D>
[[nodiscard]] inline Vec<D> blended_sizes(const Vec<D>& sorted, const Vec<D>& own) {
    constexpr double apart = 3;
    Vec<D> sizes = sorted;
    for (int k = 0; k < D; ++k) {
        const int other = own[k] > sorted[k] ? k + 1 : k - 1;
        if (other < 0 || other == D) {
            continue;
        }
        const double gap = std::abs(std::log(sorted[other] / sorted[k])) / std::log(apart);
        if (gap >= 1) {
            continue;
        }
        const double weight = smooth_fall(gap);
        const double drawn =
            other > k ? std::min(own[k], sorted[other]) : std::max(own[k], sorted[other]);
        sizes[k] *= std::pow(drawn / sorted[k], weight);
    }
    for (int k = 1; k < D; ++k) { // they may meet, and then rounding must not make them pass
        sizes[k] = std::max(sizes[k], sizes[k - 1]);
    }
    return sizes;
}

/// The mean of `count` metrics from their sum; one of the means that come from sums.
template <int D>
[[nodiscard]] inline Metric<D> finish(const Metric<D>& sum, int count, Mean mean) {
    Columns<D, double> S;
    std::size_t n = 0;
    for (std::size_t i = 0; i < D; ++i) {
        for (std::size_t j = i; j < D; ++j) {
            S[j][i] = sum.directions.data()[n++] / count;
        }
    }
    Columns<D, double> V = identity<D>();
    diagonalise(S, V);
    std::array<double, D> values;
    for (std::size_t k = 0; k < D; ++k) {
        values[k] = S[k][k];
    }
    Metric<D> metric = metric_from<D>(values, V);
    const Vec<D> mean_sizes = sum.sizes / count;
    switch (mean) {
    case Mean::corrected:
        metric.sizes = mean_sizes;
        break;
    case Mean::blended:
        metric.sizes = blended_sizes<D>(mean_sizes, metric.sizes);
        break;
    case Mean::interpolation:
        // The smallest eigenvalue is a concave function of the matrix, so that of the mean is at
        // least the mean of those of the elements: a floor that rounding must not break.
        metric.sizes = metric.sizes.cwiseMax(mean_sizes[0]);
        break;
    case Mean::log_euclidean:
        metric.sizes = metric.sizes.array().exp();
        break;
    case Mean::geodesic:
    case Mean::geodesic_fixed_step:
        assert(!"does not come from sums");
        break;
    }
    return metric;
}

} // namespace ameco
