// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/aspect_ratio.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

template <int D>
std::vector<double> aspect_ratios(const MetricField<D>& field) {
    std::vector<double> ratios(field.size());
    parallel_for(field.size(), 16384, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            ratios[i] = aspect_ratio<D>(field[NodeId(i)]);
        }
    });
    return ratios;
}

/// The smallest of the values that at most a share 1 - p of them is above. Changes their order.
double quantile(std::vector<double>& values, double p) {
    const double rank = std::ceil(p * static_cast<double>(values.size()));
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(1.0, rank)) - 1;
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

} // namespace

double AspectRatioClasses::upper(std::size_t k) const {
    return std::ldexp(max, -static_cast<int>(k));
}

std::size_t AspectRatioClasses::class_of(double aspect_ratio) const {
    if (!(aspect_ratio < max)) {
        return 0;
    }
    const std::size_t last = counts.size() - 1;
    const int guess = std::ilogb(max / aspect_ratio);
    std::size_t k = std::min(last, static_cast<std::size_t>(std::max(0, guess)));
    // The edges are powers of two times max, so exact: the guess is corrected by them.
    while (k < last && aspect_ratio <= lower(k)) {
        ++k;
    }
    while (k > 0 && aspect_ratio > upper(k)) {
        --k;
    }
    return k;
}

AspectRatioClasses empty_classes(double max) {
    AspectRatioClasses classes;
    classes.max = std::max(1.0, max);
    // Class ilogb(max) is the one with lower < 1 <= upper.
    classes.counts.assign(static_cast<std::size_t>(std::ilogb(classes.max)) + 1, 0);
    return classes;
}

template <int D>
AspectRatioClasses classify_aspect_ratios(const MetricField<D>& field, double max) {
    const std::vector<double> ratios = aspect_ratios(field);
    if (max == 0) {
        for (const double ratio : ratios) {
            max = std::isfinite(ratio) ? std::max(max, ratio) : max;
        }
    }
    AspectRatioClasses classes = empty_classes(max);
    for (const double ratio : ratios) {
        ++classes.counts[classes.class_of(ratio)];
    }
    return classes;
}

template <int D>
AspectRatioSummary summarise_aspect_ratios(const MetricField<D>& field) {
    AspectRatioSummary summary;
    if (field.empty()) {
        return summary;
    }
    std::vector<double> ratios = aspect_ratios(field);
    const auto share = [&](const auto& is_in) {
        return static_cast<double>(std::count_if(ratios.begin(), ratios.end(), is_in)) /
               static_cast<double>(ratios.size());
    };
    summary.max = *std::max_element(ratios.begin(), ratios.end());
    summary.top_5_percent = quantile(ratios, 0.95);
    summary.median = quantile(ratios, 0.5);
    summary.share_isotropic = share([](double ratio) { return ratio < 5; });
    summary.share_above_150 = share([](double ratio) { return ratio > 150; });
    return summary;
}

template AspectRatioClasses classify_aspect_ratios<2>(const MetricField<2>&, double);
template AspectRatioClasses classify_aspect_ratios<3>(const MetricField<3>&, double);
template AspectRatioSummary summarise_aspect_ratios<2>(const MetricField<2>&);
template AspectRatioSummary summarise_aspect_ratios<3>(const MetricField<3>&);

} // namespace ameco
