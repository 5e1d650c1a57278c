// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/prediction.h"

#include "core/coarsen/target_ratio.h"
#include "core/metric/expected_nodes.h"

#include <cmath>
#include <numeric>

namespace ameco {

template <int D>
Prediction predict(const Mesh<D>& fine, const MetricField<D>& natural, TargetOptions options,
                   double target_ratio, double max_aspect_ratio) {
    if (target_ratio > 0) {
        options.factor = factor_for_ratio(fine, natural, options, target_ratio);
    }
    const MetricField<D> target = target_metric(fine, natural, options);
    Prediction prediction;
    prediction.factor = options.factor;
    prediction.nodes = static_cast<double>(fine.points.size()) * expected_nodes(fine, target) /
                       expected_nodes(fine, natural);
    prediction.classes = empty_classes(max_aspect_ratio);
    std::vector<double> shares(prediction.classes.counts.size(), 0.0);
    for (const NodeId v : fine.points.ids()) {
        shares[prediction.classes.class_of(aspect_ratio<D>(target[v]))] +=
            (natural[v].sizes.cwiseQuotient(target[v].sizes)).prod();
    }
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        prediction.classes.counts[k] = std::llround(prediction.nodes * shares[k] / sum);
    }
    return prediction;
}

template Prediction predict(const Mesh<2>&, const MetricField<2>&, TargetOptions, double, double);
template Prediction predict(const Mesh<3>&, const MetricField<3>&, TargetOptions, double, double);

} // namespace ameco
