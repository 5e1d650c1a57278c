// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/boundary_surface.h"

#include "core/mesh/facets.h"

namespace ameco {
namespace {

/// Whether each face has one element.
std::vector<bool> on_boundary(const Mesh<3>& mesh) {
    std::vector<bool> outer(mesh.faces.size(), mesh.elements.empty());
    if (!mesh.elements.empty()) {
        FacetTable<3>(mesh).visit(0, mesh.points.size(), [&](const FacetUses<3>& uses) {
            for (const FaceId f : uses.faces) {
                outer[f.index()] = uses.sides.size() == 1;
            }
        });
    }
    return outer;
}

/// Features whose nodes all are on the surface.
Features kept_features(const Features& features, const IdVector<NodeId, NodeId>& new_id) {
    Features kept;
    for (std::size_t i = 0; i < features.edges.size(); ++i) {
        const Edge edge{new_id[features.edges[i][0]], new_id[features.edges[i][1]]};
        if (edge[0].valid() && edge[1].valid()) {
            kept.edges.push_back(edge);
            kept.edge_labels.push_back(features.edge_labels[i]);
        }
    }
    for (const NodeId v : features.corners) {
        if (new_id[v].valid()) {
            kept.corners.push_back(new_id[v]);
        }
    }
    return kept;
}

} // namespace

Mesh<3> boundary_surface(const Mesh<3>& mesh, IdVector<NodeId, NodeId>* new_id) {
    const std::vector<bool> outer = on_boundary(mesh);
    IdVector<NodeId, NodeId> numbers(mesh.points.size());
    for (const FaceId f : mesh.faces.ids()) {
        for (const NodeId v : mesh.faces[f]) {
            numbers[v] = outer[f.index()] ? v : numbers[v];
        }
    }
    Mesh<3> surface;
    surface.patch_names = mesh.patch_names;
    for (const NodeId v : mesh.points.ids()) {
        if (numbers[v].valid()) {
            numbers[v] = surface.points.next_id();
            surface.points.push_back(mesh.points[v]);
        }
    }
    for (const FaceId f : mesh.faces.ids()) {
        if (outer[f.index()]) {
            const auto& [a, b, c] = mesh.faces[f];
            surface.faces.push_back({numbers[a], numbers[b], numbers[c]});
            surface.patch.push_back(mesh.patch[f]);
        }
    }
    surface.features = kept_features(mesh.features, numbers);
    if (new_id != nullptr) {
        *new_id = std::move(numbers);
    }
    return surface;
}

} // namespace ameco
