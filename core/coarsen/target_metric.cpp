// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/target_metric.h"

#include "core/base/parallel.h"
#include "core/base/smooth_fall.h"
#include "core/mesh/adjacency.h"
#include "core/metric/gradation.h"
#include "core/metric/region_aspect.h"

#include <algorithm>
#include <cmath>

namespace ameco {

template <int D>
Vec<D> coarsened_sizes(const Vec<D>& sizes, const TargetOptions& options) {
    Vec<D> h = sizes;
    double bound = options.factor * h[0];
    for (int k = 0; k < D; ++k) {
        h[k] = std::max(h[k], std::min(options.factor * h[k], bound));
        bound = h[k] * std::min(options.slack, h[k] / sizes[k]);
    }
    return h;
}

double slack_in_region(double aspect_ratio, const TargetOptions& options) {
    if (aspect_ratio >= options.isotropic_below) {
        return options.slack;
    }
    const double w = smooth_fall(std::log(aspect_ratio) / std::log(options.isotropic_below));
    return std::max(options.slack, std::pow(options.factor, w));
}

std::string_view name(TargetAlgorithm algorithm) {
    switch (algorithm) {
    case TargetAlgorithm::basic:
        return "basic";
    case TargetAlgorithm::maca:
        return "maca";
    case TargetAlgorithm::maca_literal:
        return "maca-literal";
    case TargetAlgorithm::graded:
        return "graded";
    }
    return "unknown";
}

std::optional<TargetAlgorithm> target_algorithm_from_name(std::string_view text) {
    for (const TargetAlgorithm algorithm : all_target_algorithms) {
        if (name(algorithm) == text) {
            return algorithm;
        }
    }
    return std::nullopt;
}

namespace {

template <int D>
MetricField<D> basic_target(const MetricField<D>& natural, const IdVector<NodeId, float>& regions,
                            const TargetOptions& options) {
    MetricField<D> target = natural;
    parallel_for(target.size(), 4096, [&](std::size_t begin, std::size_t end) {
        TargetOptions here = options;
        for (std::size_t i = begin; i < end; ++i) {
            here.slack = slack_in_region(static_cast<double>(regions[NodeId(i)]), options);
            Vec<D>& sizes = target[NodeId(i)].sizes;
            sizes = coarsened_sizes<D>(sizes, here);
        }
    });
    return target;
}

/// Whether all sizes have grown by the full factor.
template <int D>
bool fully_coarsened(const Metric<D>& natural, const Metric<D>& target, double factor) {
    constexpr double rounding = 1e-12;
    return (target.sizes.array() >= (1 - rounding) * factor * natural.sizes.array()).all();
}

/// Algorithm 2. `keeps(i, j)`: whether the neighbour j makes the node i keep its sizes; asked where
/// `may_keep(i)`.
template <int D, class MayKeep, class Keeps>
void keep_sizes(const NodeNodes& neighbours, const MetricField<D>& natural, MetricField<D>& target,
                const MayKeep& may_keep, const Keeps& keeps) {
    std::vector<std::uint8_t> kept(natural.size(), 0);
    parallel_for(natural.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const NodeId i(k);
            if (may_keep(i)) {
                const auto& around = neighbours[i];
                kept[k] = std::any_of(around.begin(), around.end(),
                                      [&](NodeId j) { return keeps(i, j); });
            }
        }
    });
    for (const NodeId i : natural.ids()) {
        if (kept[i.index()] != 0) {
            target[i] = natural[i];
        }
    }
}

template <int D>
void apply_maca(const NodeNodes& neighbours, const MetricField<D>& natural, MetricField<D>& target,
                const TargetOptions& options) {
    const auto full = [&](NodeId i) {
        return fully_coarsened<D>(natural[i], target[i], options.factor);
    };
    if (options.algorithm == TargetAlgorithm::maca) {
        keep_sizes<D>(neighbours, natural, target, full, [&](NodeId i, NodeId j) {
            return natural[j].sizes[0] < natural[i].sizes[0] && !full(j);
        });
        return;
    }
    const auto condition = [&](NodeId i) {
        const double coarse = options.factor * natural[i].sizes[D - 1];
        const double before = target[i].sizes[D - 2];
        return std::max(natural[i].sizes[D - 1], std::min(coarse, before)) == coarse;
    };
    keep_sizes<D>(neighbours, natural, target, condition, [&](NodeId i, NodeId j) {
        return j < i && natural[j].sizes[0] < natural[i].sizes[0];
    });
}

} // namespace

template <int D>
MetricField<D> target_metric(const Mesh<D>& mesh, const MetricField<D>& natural,
                             const TargetOptions& options) {
    return target_metric(mesh, natural, region_aspect_ratios(mesh, natural), options);
}

template <int D>
MetricField<D> target_metric(const Mesh<D>& mesh, const MetricField<D>& natural,
                             const IdVector<NodeId, float>& regions, const TargetOptions& options) {
    MetricField<D> target = basic_target<D>(natural, regions, options);
    if (options.algorithm == TargetAlgorithm::basic) {
        return target;
    }
    const NodeNodes neighbours = node_neighbours(mesh);
    if (options.algorithm == TargetAlgorithm::graded) {
        limit_gradation(mesh, neighbours, natural, target, options.gradation);
    } else {
        apply_maca<D>(neighbours, natural, target, options);
    }
    return target;
}

template Vec<2> coarsened_sizes<2>(const Vec<2>&, const TargetOptions&);
template Vec<3> coarsened_sizes<3>(const Vec<3>&, const TargetOptions&);
template MetricField<2> target_metric<2>(const Mesh<2>&, const MetricField<2>&,
                                         const TargetOptions&);
template MetricField<3> target_metric<3>(const Mesh<3>&, const MetricField<3>&,
                                         const TargetOptions&);
template MetricField<2> target_metric<2>(const Mesh<2>&, const MetricField<2>&,
                                         const IdVector<NodeId, float>&, const TargetOptions&);
template MetricField<3> target_metric<3>(const Mesh<3>&, const MetricField<3>&,
                                         const IdVector<NodeId, float>&, const TargetOptions&);

} // namespace ameco
