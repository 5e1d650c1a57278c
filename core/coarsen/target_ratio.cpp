// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/target_ratio.h"

#include "core/metric/expected_nodes.h"
#include "core/metric/region_aspect.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

namespace ameco {
namespace {

double ratio_of(const CoarsenReport& report) {
    return static_cast<double>(report.nodes_before) / static_cast<double>(report.nodes_after);
}

} // namespace

template <int D>
double factor_for_ratio(const Mesh<D>& mesh, const MetricField<D>& natural, TargetOptions options,
                        double ratio) {
    const double nodes = expected_nodes(mesh, natural);
    const IdVector<NodeId, float> regions = region_aspect_ratios(mesh, natural);
    const auto asks_for_more = [&](double factor) {
        options.factor = factor;
        return expected_nodes(mesh, target_metric(mesh, natural, regions, options)) > nodes / ratio;
    };
    double low = 1;
    double high = largest_factor;
    if (asks_for_more(high)) {
        return high;
    }
    while (high - low > 1e-4 * low) {
        const double middle = std::sqrt(low * high);
        (asks_for_more(middle) ? low : high) = middle;
    }
    return high;
}

template <int D>
Level<D> coarsen_by_ratio(const Level<D>& fine, CoarsenOptions options, double ratio,
                          CoarsenReport& report, Monitor& monitor) {
    constexpr int tries = 5;
    constexpr double close_enough = 0.02;
    constexpr double worth_a_word = 0.05;
    std::optional<Level<D>> best;
    double best_error = HUGE_VAL;
    double asked = ratio;
    double too_little = 0, too_much = 0; // asked for, and reached less or more; 0: not yet
    for (int n = 0; n < tries && best_error > close_enough; ++n) {
        MonitorPart part(monitor, static_cast<double>(n) / tries, (n + 1.0) / tries);
        options.target.factor =
            factor_for_ratio(fine.mesh, fine.natural, options.target, std::max(asked, 1.0001));
        CoarsenReport made;
        Level<D> level = coarsen(fine, options, made, part);
        const double reached = ratio_of(made);
        const double error = std::abs(reached / ratio - 1);
        if (error < best_error) {
            best_error = error;
            best = std::move(level);
            report = std::move(made);
        }
        (reached < ratio ? too_little : too_much) = asked;
        if (reached < ratio ? options.target.factor >= largest_factor : asked <= 1) {
            break;
        }
        // What is reached may jump: between two sides halving is safe.
        asked = too_little > 0 && too_much > 0 ? std::sqrt(too_little * too_much)
                                               : asked * std::pow(ratio / reached, 1.5);
    }
    if (best_error > worth_a_word) {
        char text[128];
        std::snprintf(text, sizeof text,
                      "the rules of the removal allow a ratio of %.2f, not the %.2f asked for",
                      ratio_of(report), ratio);
        monitor.message(Severity::warning, text);
    }
    return std::move(*best);
}

template double factor_for_ratio(const Mesh<2>&, const MetricField<2>&, TargetOptions, double);
template double factor_for_ratio(const Mesh<3>&, const MetricField<3>&, TargetOptions, double);
template Level<2> coarsen_by_ratio(const Level<2>&, CoarsenOptions, double, CoarsenReport&,
                                   Monitor&);
template Level<3> coarsen_by_ratio(const Level<3>&, CoarsenOptions, double, CoarsenReport&,
                                   Monitor&);

} // namespace ameco
