// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/region_aspect.h"

#include "core/base/parallel.h"
#include "core/metric/metric_sum.h"

#include <utility>

namespace ameco {
namespace {

constexpr int rounds = 2;

template <int D>
using Roots = IdVector<NodeId, Tensor<D>>; ///< M^-1/2

template <int D>
void add(Tensor<D>& sum, const Tensor<D>& t, double weight) {
    for (std::size_t i = 0; i < tensor_size<D>; ++i) {
        sum[i] += weight * t[i];
    }
}

/// Nodes take the mean of their elements, which take that of their nodes.
template <int D>
Roots<D> averaged(const Mesh<D>& mesh, const Roots<D>& roots) {
    Roots<D> out(roots.size(), Tensor<D>{});
    IdVector<NodeId, int> count(roots.size(), 0);
    for (const Simplex<D>& element : mesh.elements) {
        Tensor<D> mean{};
        for (const NodeId v : element) {
            add<D>(mean, roots[v], 1.0 / (D + 1));
        }
        for (const NodeId v : element) {
            add<D>(out[v], mean, 1);
            ++count[v];
        }
    }
    for (const NodeId v : out.ids()) {
        for (double& x : out[v]) {
            x /= std::max(count[v], 1);
        }
    }
    return out;
}

} // namespace

template <int D>
IdVector<NodeId, float> region_aspect_ratios(const Mesh<D>& mesh, const MetricField<D>& field) {
    Roots<D> roots(field.size());
    parallel_for(field.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            roots[NodeId(i)] = contribution_of(field[NodeId(i)], Mean::interpolation).tensor;
        }
    });
    for (int k = 0; k < rounds; ++k) {
        roots = averaged(mesh, roots);
    }
    IdVector<NodeId, float> ratios(field.size());
    parallel_for(field.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Metric<D> sum = zero_sum<D>();
            ameco::add(sum, Contribution<D>{roots[NodeId(i)], Vec<D>::Zero()});
            ratios[NodeId(i)] =
                static_cast<float>(aspect_ratio(finish<D>(sum, 1, Mean::interpolation)));
        }
    });
    return ratios;
}

template IdVector<NodeId, float> region_aspect_ratios(const Mesh<2>&, const MetricField<2>&);
template IdVector<NodeId, float> region_aspect_ratios(const Mesh<3>&, const MetricField<3>&);

} // namespace ameco
