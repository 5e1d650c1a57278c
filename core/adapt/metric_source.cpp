// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/metric_source.h"

#include "core/base/parallel.h"
#include "core/mesh/barycentric.h"
#include "core/mesh/boundary_projection.h"

#include <algorithm>
#include <cmath>

namespace ameco {

/// Finds what a walk does not: points behind a notch of the domain, and points outside.
template <int D>
struct BackgroundMetric<D>::Search {
    explicit Search(const Mesh<D>& mesh) : elements(boxes(mesh)), boundary(mesh) {}

    static std::vector<Box<D>> boxes(const Mesh<D>& mesh) {
        std::vector<Box<D>> all(mesh.elements.size());
        for (const ElementId e : mesh.elements.ids()) {
            for (const NodeId v : mesh.elements[e]) {
                all[e.index()].extend(mesh.points[v]);
            }
        }
        return all;
    }

    BoxTree<D> elements;
    BoundaryProjection<D> boundary;
};

template <int D>
BackgroundMetric<D>::BackgroundMetric(const Mesh<D>& mesh, const MetricField<D>& field, Mean mean)
    : mesh_(mesh), locator_(mesh), mean_(mean), terms_(field.size(), {{}, Vec<D>::Zero()}) {
    parallel_for(field.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            terms_[NodeId(i)] = contribution_of<D>(field[NodeId(i)], mean);
        }
    });
}

template <int D>
BackgroundMetric<D>::~BackgroundMetric() = default;

template <int D>
const typename BackgroundMetric<D>::Search& BackgroundMetric<D>::search() const {
    std::call_once(search_made_, [&] { search_ = std::make_unique<Search>(mesh_); });
    return *search_;
}

template <int D>
Metric<D> BackgroundMetric<D>::interpolate(std::span<const NodeId> nodes,
                                           std::span<const double> weights) const {
    Metric<D> sum = zero_sum<D>();
    double* tensor = sum.directions.data();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Contribution<D>& term = terms_[nodes[i]];
        for (std::size_t k = 0; k < term.tensor.size(); ++k) {
            tensor[k] += weights[i] * term.tensor[k];
        }
        sum.sizes += weights[i] * term.sizes;
    }
    return finish<D>(sum, 1, mean_);
}

template <int D>
Metric<D> BackgroundMetric<D>::at(const Vec<D>& p, NodeId& near) const {
    std::optional<ElementId> element =
        locator_.walk(p, mesh_.points.contains(near) ? near : NodeId(0));
    if (!element) {
        const std::int32_t found = search().elements.find(
            p, [&](std::int32_t e) { return locator_.contains(ElementId(e), p); });
        if (found >= 0) {
            element = ElementId(found);
        }
    }
    const auto nearest = [&](const auto& nodes, const auto& weights) {
        return nodes[static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) -
                                              weights.begin())];
    };
    if (!element) {
        const BoundaryPoint<D> foot = search().boundary.project(p);
        near = nearest(foot.nodes, foot.weights);
        return interpolate(foot.nodes, foot.weights);
    }
    const Simplex<D>& nodes = mesh_.elements[*element];
    auto weights = barycentric<D>(corners_of(mesh_, nodes), p);
    double sum = 0;
    for (double& w : weights) { // negative by rounding only
        w = std::max(w, 0.0);
        sum += w;
    }
    for (double& w : weights) {
        w /= sum;
    }
    near = nearest(nodes, weights);
    return interpolate(nodes, weights);
}

template class BackgroundMetric<2>;
template class BackgroundMetric<3>;

} // namespace ameco
