// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/metric_fill.h"

#include "core/adapt/adapt.h"
#include "core/adapt/grown_metric.h"

#include <cmath>
#include <utility>

namespace ameco::cli {

MetricFill fill_to_metric(const Mesh<3>& surface, const MetricField<3>& field, double growth,
                          FillOptions options, const std::string& name, Monitor& monitor) {
    for (const Metric<3>& metric : field) { // of a tet of the same volume
        options.recovery.sizes.push_back(std::cbrt(metric.sizes.prod()));
    }
    MetricFill result{fill_surface(surface, options, name, monitor), {}};
    for (const std::string& remark : result.fill.recovery.remarks) {
        monitor.message(Severity::warning, remark);
    }
    if (field.empty()) {
        return result;
    }
    // Our remesher does what TetGen cannot: sizes that depend on the direction.
    AdaptOptions adaptation;
    if (options.recovery.faces == GivenFaces::keep) {
        adaptation.features.boundary = BoundaryChoice::keep;
    }
    AdaptReport report;
    result.fill.mesh =
        adapt(result.fill.mesh, GrownMetric(surface, field, growth), adaptation, report, monitor)
            .mesh;
    result.conformity = report.conformity;
    return result;
}

Json fill_json(const MetricFill& made) {
    const Fill& fill = made.fill;
    // Where the mesh was adapted, what TetGen added says nothing any more.
    Json conformity, added;
    if (made.conformity) {
        conformity = to_json(*made.conformity);
    } else {
        added = fill.recovery.added_nodes;
    }
    Json empty = Json::array();
    for (const Vec<3>& x : fill.empty) {
        empty.push_back({x[0], x[1], x[2]});
    }
    return {{"nodes", fill.mesh.points.size()},
            {"elements", fill.mesh.elements.size()},
            {"boundary_faces", fill.mesh.faces.size()},
            {"surface_nodes", fill.surface_nodes},
            {"added_nodes", added},
            {"empty", empty},
            {"conformity", conformity},
            {"seconds", fill.recovery.seconds}};
}

} // namespace ameco::cli
