// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/original_surface.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ameco {
namespace {

std::vector<FaceId> all_faces(std::size_t count) {
    std::vector<FaceId> faces(count);
    for (std::size_t i = 0; i < count; ++i) {
        faces[i] = FaceId(i);
    }
    return faces;
}

/// Calls `visit` for places on a face: the lattice that cuts each edge in four.
void visit_samples(const std::array<Vec<2>, 2>& x, const auto& visit) {
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        visit(Vec<2>((1 - t) * x[0] + t * x[1]));
    }
}

void visit_samples(const std::array<Vec<3>, 3>& x, const auto& visit) {
    constexpr int n = 4;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; i + j <= n; ++j) {
            const double a = static_cast<double>(i) / n, b = static_cast<double>(j) / n;
            visit(Vec<3>(a * x[0] + b * x[1] + (1 - a - b) * x[2]));
        }
    }
}

} // namespace

template <int D>
auto OriginalSurface<D>::boundary_of(const Mesh<D>& mesh, const std::vector<FaceId>& faces,
                                     const std::vector<RidgeEdge>& ridges) -> RidgedBoundary {
    RidgedBoundary made;
    auto& [boundary, edges] = made;
    IdVector<NodeId, NodeId> number(mesh.points.size());
    for (const FaceId f : faces) {
        Facet<D> face = mesh.faces[f];
        for (NodeId& v : face) {
            if (!number[v].valid()) {
                number[v] = boundary.points.next_id();
                boundary.points.push_back(mesh.points[v]);
            }
            v = number[v];
        }
        boundary.faces.push_back(face);
        boundary.patch.push_back(mesh.patch[f]);
    }
    for (const RidgeEdge& r : ridges) { // files may list some inside the domain
        const Edge edge{number[r.nodes[0]], number[r.nodes[1]]};
        if (edge[0].valid() && edge[1].valid()) {
            edges.push_back(sorted(edge));
        }
    }
    return made;
}

template <int D>
OriginalSurface<D>::OriginalSurface(const Mesh<D>& mesh, const std::vector<FaceId>& faces,
                                    const std::vector<RidgeEdge>& ridges)
    : OriginalSurface(boundary_of(mesh, faces, ridges)) {}

template <int D>
OriginalSurface<D>::OriginalSurface(RidgedBoundary boundary)
    : boundary_(std::move(boundary.first)),
      projection_(boundary_, all_faces(boundary_.faces.size()), boundary.second) {
    for (const FaceId f : boundary_.faces.ids()) {
        auto& nodes = nodes_of_[boundary_.patch[f]];
        nodes.insert(nodes.end(), boundary_.faces[f].begin(), boundary_.faces[f].end());
    }
    for (auto& [patch, nodes] : nodes_of_) {
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
}

template <int D>
const std::vector<NodeId>& OriginalSurface<D>::nodes_of(int patch) const {
    static const std::vector<NodeId> none;
    const auto at = nodes_of_.find(patch);
    return at == nodes_of_.end() ? none : at->second;
}

float bound_above(double distance) {
    return distance == 0 ? 0
                         : std::nextafter(static_cast<float>(distance),
                                          std::numeric_limits<float>::infinity());
}

template <int D>
double distance_to_original(const std::array<Vec<D>, D>& corners, int patch,
                            const OriginalSurface<D>& original) {
    double largest = 0;
    std::int32_t near = -1;
    visit_samples(corners, [&](const Vec<D>& p) {
        largest = std::max(largest, original.projection().distance(p, patch, near));
    });
    return largest;
}

template <int D>
auto BoundaryDistance<D>::moved_patches(const EditMesh<D>& mesh) -> Patches {
    Patches patches;
    const auto visit_ghosts = [&](const auto& visit) {
        for (std::size_t i = 0; i < mesh.slot_count(); ++i) {
            const ElementId e(i);
            if (!mesh.is_free(e) && mesh.is_ghost(e)) {
                visit(e, mesh.element(e));
            }
        }
    };
    visit_ghosts([&](ElementId, const EditElement<D>& ghost) {
        if (ghost.measure > 0) {
            patches[ghost.label];
        }
    });
    if (patches.empty()) {
        return patches;
    }
    visit_ghosts([&](ElementId e, const EditElement<D>& ghost) {
        const auto patch = patches.find(ghost.label);
        if (patch == patches.end()) {
            return;
        }
        Face face;
        face.ghost = e;
        const Facet<D> nodes = ghost_face<D>(ghost.nodes);
        for (std::size_t i = 0; i < D; ++i) {
            face.corners[i] = mesh.point(nodes[i]);
        }
        patch->second.faces.push_back(face);
    });
    return patches;
}

template <int D>
auto BoundaryDistance<D>::find(Patch& patch, ElementId ghost) -> Face* {
    const auto at = std::lower_bound(patch.faces.begin(), patch.faces.end(), ghost,
                                     [](const Face& f, ElementId e) { return f.ghost < e; });
    return at != patch.faces.end() && at->ghost == ghost ? &*at : nullptr;
}

template <int D>
void BoundaryDistance<D>::measure_faces(const EditMesh<D>& mesh, const OriginalSurface<D>& original,
                                        int number, Patch& before, Patch& patch) {
    parallel_for(patch.faces.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Face& face = patch.faces[i];
            const Face* same = find(before, face.ghost);
            if (same != nullptr && same->corners == face.corners) {
                face.changed = false;
                face.distance = same->distance;
            } else if (mesh.element(face.ghost).measure > 0) {
                face.distance = distance_to_original<D>(face.corners, number, original);
            }
        }
    });
}

template <int D>
void BoundaryDistance<D>::attach_nodes(const OriginalSurface<D>& original, int number,
                                       Patch& patch) {
    std::vector<Box<D>> boxes(patch.faces.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (const Vec<D>& x : patch.faces[i].corners) {
            boxes[i].extend(x);
        }
    }
    const BoxTree<D> tree(boxes);
    const auto face_at = [&](std::int32_t i) -> Face& {
        return patch.faces[static_cast<std::size_t>(i)];
    };
    const std::vector<NodeId>& nodes = original.nodes_of(number);
    patch.attachments.resize(nodes.size());
    parallel_for(nodes.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Attachment& a = patch.attachments[k];
            const Face* held = a.ghost.valid() ? find(patch, a.ghost) : nullptr;
            if (held != nullptr && !held->changed) {
                continue;
            }
            const Vec<D>& p = original.boundary().points[nodes[k]];
            const auto to_face = [&](std::int32_t i) {
                return nearest_on_face(face_at(i).corners, p).second;
            };
            const std::int32_t nearest = tree.nearest(p, to_face);
            a = {face_at(nearest).ghost, to_face(nearest)};
        }
    });
    for (const Attachment& a : patch.attachments) {
        Face& face = *find(patch, a.ghost);
        face.attached = std::max(face.attached, a.distance);
    }
}

template <int D>
void BoundaryDistance<D>::measure(EditMesh<D>& mesh) {
    const OriginalSurface<D>* original = mesh.original_surface();
    if (original == nullptr) {
        return;
    }
    Patches patches = moved_patches(mesh);
    for (auto& [number, patch] : patches) {
        Patch& before = patches_[number];
        measure_faces(mesh, *original, number, before, patch);
        patch.attachments = std::move(before.attachments);
        attach_nodes(*original, number, patch);
        for (const Face& face : patch.faces) {
            mesh.set_measure(face.ghost, bound_above(std::max(face.distance, face.attached)));
        }
    }
    patches_ = std::move(patches);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template class OriginalSurface<D>;                                                             \
    template double distance_to_original<D>(const std::array<Vec<D>, D>&, int,                     \
                                            const OriginalSurface<D>&);                            \
    template class BoundaryDistance<D>;

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
