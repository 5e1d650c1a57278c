// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/half_edges.h"

#include "core/base/error.h"
#include "core/surface/surface_report.h"

#include <algorithm>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

namespace ameco {

namespace om = OpenMesh;

struct HalfEdges::Connectivity {
    om::TriConnectivity mesh;

    [[nodiscard]] om::VertexHandle handle(NodeId v) const { return om::VertexHandle(v.value()); }
};

namespace {

/// Begins with the smallest entry, unless there is an open border, where the beginning means
/// something.
template <class IdType>
void begin_with_smallest(std::vector<IdType>& ring) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
}

} // namespace

HalfEdges::HalfEdges(const Mesh<3>& mesh)
    : connectivity_(std::make_unique<Connectivity>()), mesh_(&mesh) {
    // OpenMesh prints what it does not like, and we print nothing.
    const SurfaceDefects defects = inspect_surface(mesh, false).defects;
    if (!defects.crowded_edges.empty() || !defects.pinched_nodes.empty() ||
        !defects.disagreeing_edges.empty()) {
        throw InputError("the surface is no manifold: " + defect_remarks(defects).front());
    }
    om::TriConnectivity& c = connectivity_->mesh;
    c.reserve(mesh.points.size(), mesh.faces.size() * 3 / 2, mesh.faces.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        static_cast<void>(c.new_vertex());
    }
    for (const FaceId f : mesh.faces.ids()) {
        std::array<om::VertexHandle, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = connectivity_->handle(mesh.faces[f][k]);
        }
        if (!c.om::PolyConnectivity::add_face(corners.data(), corners.size()).is_valid()) {
            throw InputError("face " + std::to_string(f.value()) +
                             " of the surface meets others in a way that is no surface (ameco "
                             "surface lists everything)");
        }
    }
}

HalfEdges::~HalfEdges() = default;
HalfEdges::HalfEdges(HalfEdges&&) noexcept = default;
HalfEdges& HalfEdges::operator=(HalfEdges&&) noexcept = default;

std::vector<FaceId> HalfEdges::faces_around(NodeId v) const {
    const auto handle = connectivity_->handle(v);
    std::vector<FaceId> faces;
    for (auto f = connectivity_->mesh.cvf_ccwbegin(handle); f.is_valid(); ++f) {
        faces.push_back(FaceId((*f).idx()));
    }
    if (!connectivity_->mesh.is_boundary(handle)) {
        begin_with_smallest(faces);
    }
    return faces;
}

std::vector<NodeId> HalfEdges::nodes_around(NodeId v) const {
    const auto handle = connectivity_->handle(v);
    std::vector<NodeId> nodes;
    for (auto w = connectivity_->mesh.cvv_ccwbegin(handle); w.is_valid(); ++w) {
        nodes.push_back(NodeId((*w).idx()));
    }
    if (!connectivity_->mesh.is_boundary(handle)) {
        begin_with_smallest(nodes);
    }
    return nodes;
}

FaceId HalfEdges::face_beyond(FaceId f, int k) const {
    const auto from = static_cast<std::size_t>((k + 1) % 3),
               to = static_cast<std::size_t>((k + 2) % 3);
    const auto& nodes = mesh_->faces[f];
    const auto halfedge = connectivity_->mesh.find_halfedge(connectivity_->handle(nodes[to]),
                                                            connectivity_->handle(nodes[from]));
    if (!halfedge.is_valid() || connectivity_->mesh.is_boundary(halfedge)) {
        return {};
    }
    return FaceId(connectivity_->mesh.face_handle(halfedge).idx());
}

} // namespace ameco
