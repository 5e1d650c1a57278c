// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/grown_metric.h"

#include "core/mesh/boundary_projection.h"

namespace ameco {
namespace {

std::vector<Box<3>> boxes_of_faces(const Mesh<3>& surface) {
    std::vector<Box<3>> boxes(surface.faces.size());
    for (const FaceId f : surface.faces.ids()) {
        for (const NodeId v : surface.faces[f]) {
            boxes[f.index()].extend(surface.points[v]);
        }
    }
    return boxes;
}

} // namespace

GrownMetric::GrownMetric(const Mesh<3>& surface, const MetricField<3>& field, double growth)
    : surface_(surface), growth_(growth), faces_(boxes_of_faces(surface)) {
    for (const Metric<3>& metric : field) {
        terms_.push_back(contribution_of<3>(metric, Mean::corrected));
    }
}

Metric<3> GrownMetric::at(const Vec<3>& p, NodeId& /*near*/) const {
    const auto foot = [&](std::int32_t item) {
        const Facet<3>& f = surface_.faces[FaceId(item)];
        return nearest_on_face(
            {surface_.points[f[0]], surface_.points[f[1]], surface_.points[f[2]]}, p);
    };
    const std::int32_t face =
        faces_.nearest(p, [&](std::int32_t item) { return foot(item).second; });
    const auto [weights, distance] = foot(face);
    Metric<3> sum = zero_sum<3>();
    double* tensor = sum.directions.data();
    for (std::size_t i = 0; i < 3; ++i) {
        const Contribution<3>& term = terms_[surface_.faces[FaceId(face)][i]];
        for (std::size_t k = 0; k < term.tensor.size(); ++k) {
            tensor[k] += weights[i] * term.tensor[k];
        }
        sum.sizes += weights[i] * term.sizes;
    }
    Metric<3> metric = finish<3>(sum, 1, Mean::corrected);
    metric.sizes.array() += growth_ * distance;
    return metric;
}

} // namespace ameco
