// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/boundary_projection.h"

#include "core/mesh/facets.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace ameco {
namespace {

/// Share of `b` at the point of the segment a, b nearest to `p`.
template <int D>
double nearest_on_segment(const Vec<D>& a, const Vec<D>& b, const Vec<D>& p) {
    const Vec<D> t = b - a;
    const double length2 = t.squaredNorm();
    return length2 > 0 ? std::clamp(t.dot(p - a) / length2, 0.0, 1.0) : 0.0;
}

template <int D>
std::array<Vec<D>, D> face_corners(const Mesh<D>& mesh, FaceId f) {
    std::array<Vec<D>, D> x;
    for (std::size_t i = 0; i < D; ++i) {
        x[i] = mesh.points[mesh.faces[f][i]];
    }
    return x;
}

/// \param nodes  those of each item
template <int D>
std::unique_ptr<BoxTree<D>> tree_over(const Mesh<D>& mesh, const auto& items, const auto& nodes) {
    std::vector<Box<D>> boxes(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (const NodeId v : nodes(items[i])) {
            boxes[i].extend(mesh.points[v]);
        }
    }
    return std::make_unique<BoxTree<D>>(boxes);
}

/// An edge of a boundary face and the face's patch.
struct PatchEdge {
    Edge nodes;
    int patch;
    friend auto operator<=>(const PatchEdge&, const PatchEdge&) = default;
};

template <int D>
std::vector<PatchEdge> patch_edges(const Mesh<D>& mesh, const std::vector<FaceId>& faces) {
    std::vector<PatchEdge> edges;
    for (const FaceId f : faces) {
        for (std::size_t i = 0; i < D; ++i) {
            // The border of a face: its end nodes (D = 2) or its edges (D = 3).
            const NodeId a = mesh.faces[f][i];
            const NodeId b = D == 2 ? a : mesh.faces[f][(i + 1) % D];
            edges.push_back({{std::min(a, b), std::max(a, b)}, mesh.patch[f]});
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

} // namespace

std::pair<std::array<double, 2>, double> nearest_on_face(const std::array<Vec<2>, 2>& corners,
                                                         const Vec<2>& p) {
    const double t = nearest_on_segment(corners[0], corners[1], p);
    const Vec<2> q = corners[0] + t * (corners[1] - corners[0]);
    return {{1 - t, t}, (p - q).norm()};
}

std::pair<std::array<double, 3>, double> nearest_on_face(const std::array<Vec<3>, 3>& corners,
                                                         const Vec<3>& p) {
    const auto& [a, b, c] = corners;
    const Vec<3> n = (b - a).cross(c - a);
    const double n2 = n.squaredNorm();
    const std::array<double, 3> part{n.dot((b - p).cross(c - p)), n.dot((c - p).cross(a - p)),
                                     n.dot((a - p).cross(b - p))};
    if (n2 > 0 && part[0] >= 0 && part[1] >= 0 && part[2] >= 0) {
        const double sum = part[0] + part[1] + part[2];
        return {{part[0] / sum, part[1] / sum, part[2] / sum},
                std::abs(n.dot(p - a)) / std::sqrt(n2)};
    }
    std::pair<std::array<double, 3>, double> best{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double t = nearest_on_segment(corners[i], corners[j], p);
        const double d = (p - corners[i] - t * (corners[j] - corners[i])).norm();
        if (d < best.second) {
            best = {{}, d};
            best.first[i] = 1 - t;
            best.first[j] = t;
        }
    }
    return best;
}

template <int D>
std::vector<FaceId> outer_faces(const Mesh<D>& mesh) {
    std::vector<FaceId> faces;
    const FacetTable<D> table(mesh);
    table.visit(0, mesh.points.size(), [&](const FacetUses<D>& f) {
        if (f.sides.size() == 1) {
            faces.insert(faces.end(), f.faces.begin(), f.faces.end());
        }
    });
    std::sort(faces.begin(), faces.end());
    return faces;
}

template <int D>
IdVector<NodeId, std::vector<int>> node_patches(const Mesh<D>& mesh) {
    IdVector<NodeId, std::vector<int>> patches(mesh.points.size());
    for (const FaceId f : outer_faces(mesh)) {
        for (const NodeId v : mesh.faces[f]) {
            auto& list = patches[v];
            const auto at = std::lower_bound(list.begin(), list.end(), mesh.patch[f]);
            if (at == list.end() || *at != mesh.patch[f]) {
                list.insert(at, mesh.patch[f]);
            }
        }
    }
    return patches;
}

template <int D>
BoundaryProjection<D>::BoundaryProjection(const Mesh<D>& mesh)
    : BoundaryProjection(mesh, outer_faces(mesh)) {}

template <int D>
BoundaryProjection<D>::BoundaryProjection(const Mesh<D>& mesh, std::vector<FaceId> faces,
                                          const std::vector<Edge>& ridges)
    : mesh_(mesh) {
    all_.faces = std::move(faces);
    for (const FaceId f : all_.faces) {
        patches_[mesh.patch[f]].faces.push_back(f);
    }
    const auto face_nodes = [&](FaceId f) -> const Facet<D>& { return mesh.faces[f]; };
    all_.tree = tree_over(mesh, all_.faces, face_nodes);
    for (auto& [patch, part] : patches_) {
        part.tree = tree_over(mesh, part.faces, face_nodes);
    }
    const std::vector<PatchEdge> edges = patch_edges(mesh, all_.faces);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size() && edges[j].nodes == edges[i].nodes; ++j) {
            lines_[{edges[i].patch, edges[j].patch}].edges.push_back(edges[i].nodes);
        }
    }
    for (const Edge& ridge : ridges) {
        const auto has_ridge = [&](const PatchEdge& e) { return e.nodes == ridge; };
        const auto use =
            std::lower_bound(edges.begin(), edges.end(), ridge,
                             [](const PatchEdge& e, const Edge& nodes) { return e.nodes < nodes; });
        if (use != edges.end() && has_ridge(*use) &&
            (use + 1 == edges.end() || !has_ridge(*(use + 1)))) {
            lines_[{use->patch, use->patch}].edges.push_back(ridge);
        }
    }
    for (auto& [patches, line] : lines_) {
        line.tree = tree_over(mesh, line.edges, [](const Edge& e) -> const Edge& { return e; });
    }
}

template <int D>
BoundaryPoint<D> BoundaryProjection<D>::project(const Vec<D>& p, const Part& part) const {
    const std::int32_t item = nearest_face(p, part, -1);
    if (item < 0) {
        return {};
    }
    const FaceId face = part.faces[static_cast<std::size_t>(item)];
    const auto [weights, distance] = nearest_on_face(face_corners(mesh_, face), p);
    return {mesh_.faces[face], weights, distance};
}

template <int D>
std::int32_t BoundaryProjection<D>::nearest_face(const Vec<D>& p, const Part& part,
                                                 std::int32_t guess) const {
    return part.tree->nearest(
        p,
        [&](std::int32_t i) {
            const FaceId face = part.faces[static_cast<std::size_t>(i)];
            return nearest_on_face(face_corners(mesh_, face), p).second;
        },
        guess);
}

template <int D>
auto BoundaryProjection<D>::faces_of(int patch) const -> const Part& {
    const auto part = patches_.find(patch);
    return part == patches_.end() ? all_ : part->second;
}

template <int D>
double BoundaryProjection<D>::distance(const Vec<D>& p, int patch, std::int32_t& near) const {
    const Part& part = faces_of(patch);
    near = nearest_face(p, part, near);
    if (near < 0) {
        return 0;
    }
    const FaceId face = part.faces[static_cast<std::size_t>(near)];
    return nearest_on_face(face_corners(mesh_, face), p).second;
}

template <int D>
BoundaryPoint<D> BoundaryProjection<D>::project_on_line(const Vec<D>& p,
                                                        const std::vector<int>& patches) const {
    const auto found = lines_.find({patches[0], patches[patches.size() > 1 ? 1 : 0]});
    if (found == lines_.end()) {
        return {};
    }
    const auto& [edges, tree] = found->second;
    const auto point_on = [&](const Edge& e) {
        const Vec<D>& a = mesh_.points[e[0]];
        const Vec<D> along = mesh_.points[e[1]] - a;
        const double t = nearest_on_segment<D>(a, mesh_.points[e[1]], p);
        BoundaryPoint<D> point;
        point.nodes.fill(e[1]);
        point.nodes[0] = e[0];
        point.weights[0] = 1 - t;
        point.weights[1] = t;
        point.distance = (p - a - t * along).norm();
        return point;
    };
    const auto edge = [&edges = edges](std::int32_t i) -> const Edge& {
        return edges[static_cast<std::size_t>(i)];
    };
    return point_on(
        edge(tree->nearest(p, [&](std::int32_t i) { return point_on(edge(i)).distance; })));
}

template <int D>
BoundaryPoint<D> BoundaryProjection<D>::project(const Vec<D>& p) const {
    return project(p, all_);
}

template <int D>
BoundaryPoint<D> BoundaryProjection<D>::project(const Vec<D>& p,
                                                const std::vector<int>& patches) const {
    if (patches.size() > 1) {
        const BoundaryPoint<D> point = project_on_line(p, patches);
        if (point.nodes[0].valid()) {
            return point;
        }
    }
    return project(p, patches.empty() ? all_ : faces_of(patches[0]));
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template class BoundaryProjection<D>;                                                          \
    template std::vector<FaceId> outer_faces(const Mesh<D>&);                                      \
    template IdVector<NodeId, std::vector<int>> node_patches(const Mesh<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
