// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/nodal_metric.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/metric/element_metric.h"
#include "core/metric/symmetric_eigen.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ameco {
namespace {

/// Elements whose metrics are held at a time: 9 MB in 3-D.
constexpr std::size_t block_size = 1 << 17;

/// Elements whose metrics are made in one go: they stay in the innermost cache.
constexpr std::size_t elements_at_once = 64;

/// Runs of consecutive nodes that belong to one adder.
constexpr int run_shift = 8;

/// What an element adds to its nodes, and what a node sums up.
template <int D>
struct Contribution {
    std::array<double, tensor_size<D>> tensor; ///< V f(h) V^T, upper triangle by rows
    Vec<D> sizes;                              ///< sorted
};

template <int D>
Contribution<D> contribution_of(const Metric<D>& metric, Mean mean) {
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

/// The sums of a node live in its place in the resulting field until `finish` makes a metric of
/// them: the tensor in the first entries of `directions`, so no further memory is needed.
template <int D>
void add(Metric<D>& sum, const Contribution<D>& c) {
    double* tensor = sum.directions.data();
    for (std::size_t n = 0; n < tensor_size<D>; ++n) {
        tensor[n] += c.tensor[n];
    }
    sum.sizes += c.sizes;
}

template <int D>
Metric<D> finish(const Metric<D>& sum, int count, Mean mean) {
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
    case Mean::interpolation:
        // The smallest eigenvalue is a concave function of the matrix, so that of the mean is at
        // least the mean of those of the elements: a floor that rounding must not break.
        metric.sizes = metric.sizes.cwiseMax(mean_sizes[0]);
        break;
    case Mean::log_euclidean:
        metric.sizes = metric.sizes.array().exp();
        break;
    }
    return metric;
}

template <int D>
class Averaging {
public:
    Averaging(const Mesh<D>& mesh, Mean mean)
        : mesh_(mesh), mean_(mean), field_(mesh.points.size(), zero()), counts_(field_.size(), 0),
          block_(std::min(block_size, mesh.elements.size())) {}

    void add_block(std::size_t first) {
        const std::size_t size = std::min(block_size, mesh_.elements.size() - first);
        parallel_for(size, 1024, [&](std::size_t begin, std::size_t end) {
            std::array<Metric<D>, elements_at_once> metrics;
            for (std::size_t k = begin; k < end; k += metrics.size()) {
                const std::span<Metric<D>> some(metrics.data(), std::min(metrics.size(), end - k));
                element_metrics<D>(mesh_, ElementId(first + k), some);
                for (std::size_t i = 0; i < some.size(); ++i) {
                    block_[k + i] = contribution_of<D>(some[i], mean_);
                }
            }
        });
        // Each adder goes through the whole block and keeps to its own nodes, so every node gets
        // its elements in ascending order whatever the number of adders.
        const auto adders = static_cast<std::size_t>(thread_count());
        parallel_for(adders, 1, [&](std::size_t adder, std::size_t) {
            for (std::size_t k = 0; k < size; ++k) {
                for (const NodeId i : mesh_[ElementId(first + k)]) {
                    if ((i.index() >> run_shift) % adders == adder) {
                        add<D>(field_[i], block_[k]);
                        ++counts_[i];
                    }
                }
            }
        });
    }

    [[nodiscard]] MetricField<D> result() && {
        parallel_for(field_.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const NodeId i(k);
                field_[i] = finish<D>(field_[i], counts_[i], mean_);
            }
        });
        return std::move(field_);
    }

private:
    static Metric<D> zero() {
        Metric<D> sum;
        sum.sizes.setZero();
        sum.directions.setZero();
        return sum;
    }

    const Mesh<D>& mesh_;
    Mean mean_;
    MetricField<D> field_;
    IdVector<NodeId, int> counts_;
    std::vector<Contribution<D>> block_;
};

} // namespace

std::string_view name(Mean mean) {
    switch (mean) {
    case Mean::corrected:
        return "corrected";
    case Mean::interpolation:
        return "interpolation";
    case Mean::log_euclidean:
        return "log-euclidean";
    }
    return "unknown";
}

template <int D>
MetricField<D> nodal_metric(const Mesh<D>& mesh, Mean mean, Monitor& monitor) {
    Averaging<D> averaging(mesh, mean);
    const std::size_t m = mesh.elements.size();
    for (std::size_t first = 0; first < m; first += block_size) {
        if (monitor.stop_requested()) {
            throw Cancelled();
        }
        monitor.progress(static_cast<double>(first) / static_cast<double>(m), "natural metric");
        averaging.add_block(first);
    }
    MetricField<D> field = std::move(averaging).result();
    monitor.progress(1, "natural metric");
    return field;
}

template MetricField<2> nodal_metric<2>(const Mesh<2>&, Mean, Monitor&);
template MetricField<3> nodal_metric<3>(const Mesh<3>&, Mean, Monitor&);

} // namespace ameco
