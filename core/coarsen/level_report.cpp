// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/level_report.h"

#include "core/adapt/metric_source.h"
#include "core/metric/expected_nodes.h"

#include <algorithm>
#include <optional>

namespace ameco {

template <int D>
double predicted_nodes(const Level<D>& fine, const MetricField<D>& target) {
    return static_cast<double>(fine.mesh.points.size()) * expected_nodes(fine.mesh, target) /
           expected_nodes(fine.mesh, fine.natural);
}

template <int D>
MetricField<D> wanted_metric(const Mesh<D>& fine, const MetricField<D>& target,
                             const Level<D>& coarse) {
    std::optional<BackgroundMetric<D>> source; // costs more than all else: only if it is needed
    MetricField<D> wanted(coarse.parent.size());
    for (const NodeId v : coarse.parent.ids()) {
        NodeId parent = coarse.parent[v];
        const Vec<D>& p = coarse.mesh.points[v];
        if (p == fine.points[parent]) {
            wanted[v] = target[parent];
        } else {
            if (!source) {
                source.emplace(fine, target);
            }
            wanted[v] = source->at(p, parent);
        }
    }
    return wanted;
}

template <int D>
void measure_deviation(const Mesh<D>& mesh, const GeometryClasses<D>& geometry,
                       CoarsenReport& report) {
    for (const FaceId f : mesh.faces.ids()) {
        double edges = 0;
        int count = 0;
        for (std::size_t i = 0; i + 1 < D; ++i) {
            for (std::size_t j = i + 1; j < D; ++j) {
                edges += (mesh.points[mesh.faces[f][i]] - mesh.points[mesh.faces[f][j]]).norm();
                ++count;
            }
        }
        report.deviation = std::max(report.deviation, geometry.deviation[f]);
        report.deviation_relative =
            std::max(report.deviation_relative, geometry.deviation[f] * count / edges);
    }
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template double predicted_nodes(const Level<D>&, const MetricField<D>&);                       \
    template MetricField<D> wanted_metric(const Mesh<D>&, const MetricField<D>&, const Level<D>&); \
    template void measure_deviation(const Mesh<D>&, const GeometryClasses<D>&, CoarsenReport&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
