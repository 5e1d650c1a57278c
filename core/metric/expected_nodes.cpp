// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/expected_nodes.h"

#include "core/mesh/simplex.h"
#include "core/metric/complexity.h"
#include "core/metric/edge_length.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace ameco {
namespace {

/// Sum over the boundary edges of half their length in the metric.
double boundary_share(const Mesh<2>& mesh, const MetricField<2>& field) {
    double sum = 0;
    for (const Facet<2>& f : mesh.faces) {
        const Vec<2> e = mesh.points[f[1]] - mesh.points[f[0]];
        sum += edge_length(length(field[f[0]], e), length(field[f[1]], e)) / 2;
    }
    return sum;
}

/// Area of a face in the metric of one of its nodes: sqrt(det M n^T M^-1 n) times its area.
double metric_area(const Metric<3>& m, const Vec<3>& area_vector) {
    return (m.directions.transpose() * area_vector).cwiseProduct(m.sizes).norm() * density(m);
}

/// An edge of a boundary face, and the face's unit normal.
struct EdgeOfFace {
    Edge nodes;
    FaceId face;
};

double boundary_share(const Mesh<3>& mesh, const MetricField<3>& field) {
    double faces = 0;
    IdVector<FaceId, Vec<3>> normals(mesh.faces.size(), Vec<3>::Zero());
    std::vector<EdgeOfFace> edges;
    edges.reserve(3 * mesh.faces.size());
    for (const FaceId id : mesh.faces.ids()) {
        const Facet<3>& f = mesh.faces[id];
        const Vec<3> area =
            (mesh.points[f[1]] - mesh.points[f[0]]).cross(mesh.points[f[2]] - mesh.points[f[0]]) /
            2;
        normals[id] = area.normalized();
        for (std::size_t i = 0; i < 3; ++i) {
            faces += metric_area(field[f[i]], area) / 3;
            edges.push_back({sorted(Edge{f[i], f[(i + 1) % 3]}), id});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const EdgeOfFace& a, const EdgeOfFace& b) {
        return std::pair(a.nodes, a.face) < std::pair(b.nodes, b.face);
    });
    double ridges = 0;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const Edge& e = edges[i].nodes;
        if (e != edges[i + 1].nodes) {
            continue;
        }
        // The turn of the normal is pi minus the dihedral angle, negative in a concave edge.
        const Vec<3>& a = normals[edges[i].face];
        const Vec<3>& b = normals[edges[i + 1].face];
        Vec<3> along = mesh.points[e[1]] - mesh.points[e[0]];
        const Facet<3>& f = mesh.faces[edges[i].face];
        const auto at = std::find(f.begin(), f.end(), e[0]) - f.begin();
        const bool forward = f[static_cast<std::size_t>((at + 1) % 3)] == e[1];
        const double sine = a.cross(b).dot(along.normalized()) * (forward ? 1 : -1);
        const double turn = std::atan2(sine, a.dot(b));
        ridges += turn / (2 * std::numbers::pi) *
                  edge_length(length(field[e[0]], along), length(field[e[1]], along));
        ++i;
    }
    return faces / std::sqrt(3.0) + ridges;
}

} // namespace

template <int D>
double expected_nodes(const Mesh<D>& mesh, const MetricField<D>& field) {
    const double per_cell = D == 2 ? 2 / std::sqrt(3.0) : std::sqrt(2.0);
    return per_cell * complexity(mesh, field) + boundary_share(mesh, field);
}

template double expected_nodes(const Mesh<2>&, const MetricField<2>&);
template double expected_nodes(const Mesh<3>&, const MetricField<3>&);

} // namespace ameco
