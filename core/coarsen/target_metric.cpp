// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/target_metric.h"

#include "core/base/parallel.h"

#include <algorithm>

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

template <int D>
MetricField<D> target_metric(const MetricField<D>& natural, const TargetOptions& options) {
    MetricField<D> target = natural;
    parallel_for(target.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec<D>& sizes = target[NodeId(i)].sizes;
            sizes = coarsened_sizes<D>(sizes, options);
        }
    });
    return target;
}

template Vec<2> coarsened_sizes<2>(const Vec<2>&, const TargetOptions&);
template Vec<3> coarsened_sizes<3>(const Vec<3>&, const TargetOptions&);
template MetricField<2> target_metric<2>(const MetricField<2>&, const TargetOptions&);
template MetricField<3> target_metric<3>(const MetricField<3>&, const TargetOptions&);

} // namespace ameco
