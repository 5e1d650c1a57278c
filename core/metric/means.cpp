// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/means.h"

#include "core/base/error.h"
#include "core/metric/geodesic_mean.h"
#include "core/metric/metric_sum.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace ameco {

std::string_view name(Mean mean) {
    switch (mean) {
    case Mean::corrected:
        return "corrected";
    case Mean::blended:
        return "blended";
    case Mean::interpolation:
        return "interpolation";
    case Mean::log_euclidean:
        return "log-euclidean";
    case Mean::geodesic:
        return "geodesic";
    case Mean::geodesic_fixed_step:
        return "geodesic-fixed-step";
    }
    return "unknown";
}

std::optional<Mean> mean_from_name(std::string_view text) {
    const auto* const found = std::find_if(all_means.begin(), all_means.end(),
                                           [&](Mean mean) { return name(mean) == text; });
    return found == all_means.end() ? std::nullopt : std::optional(*found);
}

template <int D>
Metric<D> mean_of(std::span<const Metric<D>> metrics, Mean mean) {
    if (comes_from_sums(mean)) {
        Metric<D> sum = zero_sum<D>();
        for (const Metric<D>& metric : metrics) {
            add<D>(sum, contribution_of<D>(metric, mean));
        }
        return finish<D>(sum, static_cast<int>(metrics.size()), mean);
    }
    GeodesicOptions options;
    if (mean == Mean::geodesic_fixed_step) {
        options.step = GeodesicStep::fixed;
    }
    const GeodesicMean<D> result = geodesic_mean(metrics, options);
    if (!result.converged) {
        char residual[32];
        std::snprintf(residual, sizeof residual, "%.2g", result.residual);
        throw NotConverged(std::string(name(mean)) + ": no mean of " +
                           std::to_string(metrics.size()) + " metrics after " +
                           std::to_string(result.iterations) + " iterations (residual " + residual +
                           "): take the mean geodesic or log-euclidean");
    }
    return result.mean;
}

template Metric<2> mean_of(std::span<const Metric<2>>, Mean);
template Metric<3> mean_of(std::span<const Metric<3>>, Mean);

} // namespace ameco
