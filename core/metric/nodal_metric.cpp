// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/nodal_metric.h"

#include "core/base/parallel.h"
#include "core/base/stop_check.h"
#include "core/mesh/adjacency.h"
#include "core/metric/element_metric.h"
#include "core/metric/geodesic_mean.h"
#include "core/metric/metric_sum.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace ameco {
namespace {

/// Elements whose metrics are held at a time: 9 MB in 3-D.
constexpr std::size_t block_size = 1 << 17;

/// Elements whose metrics are made in one go: they stay in the innermost cache.
constexpr std::size_t elements_at_once = 64;

/// Runs of consecutive nodes that belong to one adder.
constexpr int run_shift = 8;

template <int D>
class Averaging {
public:
    Averaging(const Mesh<D>& mesh, Mean mean)
        : mesh_(mesh), mean_(mean), field_(mesh.points.size(), zero_sum<D>()),
          counts_(field_.size(), 0), block_(std::min(block_size, mesh.elements.size())) {}

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
    const Mesh<D>& mesh_;
    Mean mean_;
    MetricField<D> field_;
    IdVector<NodeId, int> counts_;
    std::vector<Contribution<D>> block_;
};

/// A mean that needs all metrics of a node at once.
template <int D>
MetricField<D> node_by_node(const Mesh<D>& mesh, Mean mean, Monitor& monitor) {
    constexpr std::size_t nodes_at_once = 1 << 14;
    constexpr std::size_t piece = 64;
    const NodeElements balls = node_elements(mesh);
    const std::size_t n = mesh.points.size();
    MetricField<D> field(n);
    // The first failure in the order of the nodes, whichever thread meets one first.
    std::vector<std::optional<std::string>> failures((nodes_at_once + piece - 1) / piece);
    for (std::size_t first = 0; first < n; first += nodes_at_once) {
        stop_if_asked(monitor);
        monitor.progress(static_cast<double>(first) / static_cast<double>(n), "natural metric");
        const std::size_t size = std::min(nodes_at_once, n - first);
        parallel_for(size, piece, [&](std::size_t begin, std::size_t end) {
            std::vector<Metric<D>> metrics;
            for (std::size_t k = begin; k < end; ++k) {
                const NodeId i(first + k);
                const std::span<const ElementId> ball = balls[i];
                metrics.resize(ball.size());
                element_metrics<D>(mesh, ball, metrics);
                try {
                    field[i] = mean_of<D>(metrics, mean);
                } catch (const NotConverged& e) {
                    failures[begin / piece] = "node " + std::to_string(i.index()) + ": " + e.what();
                    return;
                }
            }
        });
        for (const auto& failure : failures) {
            if (failure) {
                throw NotConverged(*failure);
            }
        }
    }
    monitor.progress(1, "natural metric");
    return field;
}

} // namespace

template <int D>
MetricField<D> nodal_metric(const Mesh<D>& mesh, Mean mean, Monitor& monitor) {
    if (!comes_from_sums(mean)) {
        return node_by_node(mesh, mean, monitor);
    }
    Averaging<D> averaging(mesh, mean);
    const std::size_t m = mesh.elements.size();
    for (std::size_t first = 0; first < m; first += block_size) {
        stop_if_asked(monitor);
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
