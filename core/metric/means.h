// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How several metrics become one.
#pragma once

#include "core/metric/metric.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace ameco {

/// How the metrics of the elements around a node become one.
enum class Mean {
    corrected,          ///< (9)-(10): directions of (8), sizes the mean of the sorted sizes
    blended,            ///< (10), but sizes near each other are drawn together as (8) has them
    interpolation,      ///< (8): mean of M^-1/2
    log_euclidean,      ///< proposition 4: exponential of the mean of the logarithms
    geodesic,           ///< (11): smallest sum of squared invariant distances
    geodesic_fixed_step ///< the same by Algorithm 3 as printed, which may not converge
};

inline constexpr std::array all_means{Mean::corrected,     Mean::blended,
                                      Mean::interpolation, Mean::log_euclidean,
                                      Mean::geodesic,      Mean::geodesic_fixed_step};

[[nodiscard]] std::string_view name(Mean mean);
[[nodiscard]] std::optional<Mean> mean_from_name(std::string_view name);

/// Whether the mean is made from sums, so that one pass over the elements gives all nodes theirs.
[[nodiscard]] constexpr bool comes_from_sums(Mean mean) {
    return mean != Mean::geodesic && mean != Mean::geodesic_fixed_step;
}

/// The mean of some metrics.
///
/// \param metrics  at least one, valid
/// \throws NotConverged  geodesic_fixed_step only
/// \see docs/theory/means.md; paper, section 2.3
template <int D>
[[nodiscard]] Metric<D> mean_of(std::span<const Metric<D>> metrics, Mean mean);

} // namespace ameco
