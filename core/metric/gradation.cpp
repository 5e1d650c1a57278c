// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/gradation.h"

#include "core/metric/edge_length.h"
#include "core/metric/symmetric_eigen.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

/// A change by less is none: the front must come to rest.
constexpr double negligible = 1e-6;

/// Extent of the unit ball along the unit vector v.
template <int D>
double extent(const Metric<D>& metric, const Vec<D>& v) {
    return (metric.directions.transpose() * v).cwiseProduct(metric.sizes).norm();
}

/// Holds the sizes of q to what p allows; whether any changed. The directions of q are those of its
/// natural metric, size by size, until all is done.
template <int D>
bool limit(const Metric<D>& natural_p, const Metric<D>& target_p, const Metric<D>& natural_q,
           Metric<D>& target_q, double growth) {
    bool changed = false;
    for (int k = 0; k < D; ++k) {
        const Vec<D> v = natural_q.directions.col(k);
        const double bound =
            extent<D>(target_p, v) * std::max(growth, natural_q.sizes[k] / extent<D>(natural_p, v));
        if (target_q.sizes[k] > bound * (1 + negligible)) {
            target_q.sizes[k] = std::max(bound, natural_q.sizes[k]);
            changed = true;
        }
    }
    return changed;
}

/// Brings sizes that were held back differently into order, with their directions.
template <int D>
void sort_sizes(Metric<D>& metric) {
    if (std::is_sorted(metric.sizes.begin(), metric.sizes.end())) {
        return;
    }
    std::array<double, D> sizes;
    Columns<D, double> V;
    for (int k = 0; k < D; ++k) {
        sizes[k] = metric.sizes[k];
        Eigen::Map<Vec<D>>(V[k].data()) = metric.directions.col(k);
    }
    metric = metric_from<D>(sizes, V);
}

} // namespace

template <int D>
std::int64_t limit_gradation(const Mesh<D>& mesh, const NodeNodes& neighbours,
                             const MetricField<D>& natural, MetricField<D>& target, double beta) {
    std::vector<NodeId> front;
    for (const NodeId p : mesh.points.ids()) {
        front.push_back(p);
    }
    std::vector<NodeId> next;
    IdVector<NodeId, std::uint8_t> waiting(mesh.points.size(), 0);
    IdVector<NodeId, std::uint8_t> touched(mesh.points.size(), 0);
    const double log_beta = std::log(beta);
    while (!front.empty()) {
        next.clear();
        for (const NodeId p : front) {
            waiting[p] = 0;
            for (const NodeId q : neighbours[p]) {
                const Vec<D> e = mesh.points[q] - mesh.points[p];
                const double l = edge_length(length<D>(natural[p], e), length<D>(natural[q], e));
                const double growth = std::exp(log_beta * l);
                if (limit<D>(natural[p], target[p], natural[q], target[q], growth)) {
                    touched[q] = 1;
                    if (waiting[q] == 0) {
                        waiting[q] = 1;
                        next.push_back(q);
                    }
                }
            }
        }
        std::swap(front, next);
    }
    std::int64_t changed = 0;
    for (const NodeId q : mesh.points.ids()) {
        if (touched[q] != 0) {
            sort_sizes(target[q]);
            ++changed;
        }
    }
    return changed;
}

template std::int64_t limit_gradation(const Mesh<2>&, const NodeNodes&, const MetricField<2>&,
                                      MetricField<2>&, double);
template std::int64_t limit_gradation(const Mesh<3>&, const NodeNodes&, const MetricField<3>&,
                                      MetricField<3>&, double);

} // namespace ameco
