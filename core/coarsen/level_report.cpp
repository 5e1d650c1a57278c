// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/level_report.h"

#include "core/metric/expected_nodes.h"

#include <algorithm>

namespace ameco {

template <int D>
double predicted_nodes(const Level<D>& fine, const MetricField<D>& target) {
    return static_cast<double>(fine.mesh.points.size()) * expected_nodes(fine.mesh, target) /
           expected_nodes(fine.mesh, fine.natural);
}

template <int D>
MetricField<D> at_parents(const MetricField<D>& field, const IdVector<NodeId, NodeId>& parent) {
    MetricField<D> out(parent.size());
    for (const NodeId v : parent.ids()) {
        out[v] = field[parent[v]];
    }
    return out;
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
    template MetricField<D> at_parents(const MetricField<D>&, const IdVector<NodeId, NodeId>&);    \
    template void measure_deviation(const Mesh<D>&, const GeometryClasses<D>&, CoarsenReport&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
