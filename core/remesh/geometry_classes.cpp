// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/geometry_classes.h"

#include "core/mesh/adjacency.h"
#include "core/mesh/simplex.h"
#include "core/remesh/original_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace ameco {

std::string_view name(BoundaryChoice choice) {
    return choice == BoundaryChoice::keep ? "keep" : "coarsen";
}

std::optional<BoundaryChoice> boundary_choice_from_name(std::string_view text) {
    for (const BoundaryChoice choice : all_boundary_choices) {
        if (name(choice) == text) {
            return choice;
        }
    }
    return std::nullopt;
}

namespace {

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

/// Unit normal of a face, outwards.
Vec<3> unit_normal(const Mesh<3>& mesh, const Facet<3>& f) {
    return (mesh.points[f[1]] - mesh.points[f[0]])
        .cross(mesh.points[f[2]] - mesh.points[f[0]])
        .normalized();
}

template <int D>
bool contains(const Simplex<D>& s, NodeId v) {
    return std::find(s.begin(), s.end(), v) != s.end();
}

/// Number of elements behind a face: 1 on the boundary, 2 inside the domain.
template <int D>
int elements_at(const Mesh<D>& mesh, const NodeElements& ball, const Facet<D>& f) {
    int count = 0;
    for (const ElementId e : ball[f[0]]) {
        count += std::all_of(f.begin() + 1, f.end(),
                             [&](NodeId v) { return contains<D>(mesh.elements[e], v); });
    }
    return count;
}

/// Freezes the nodes of faces and region borders inside the domain; returns which faces are on the
/// boundary.
template <int D>
std::vector<bool> freeze_interfaces(const Mesh<D>& mesh, GeometryClasses<D>& classes) {
    const NodeElements ball = node_elements(mesh);
    std::vector<bool> on_boundary(mesh.faces.size());
    for (const FaceId f : mesh.faces.ids()) {
        on_boundary[f.index()] = elements_at<D>(mesh, ball, mesh.faces[f]) == 1;
        if (!on_boundary[f.index()]) {
            for (const NodeId v : mesh.faces[f]) {
                classes.node[v] = NodeClass::frozen;
            }
        }
    }
    for (const NodeId v : mesh.points.ids()) {
        const auto elements = ball[v];
        if (std::any_of(elements.begin(), elements.end(), [&](ElementId e) {
                return mesh.region[e] != mesh.region[elements.front()];
            })) {
            classes.node[v] = NodeClass::frozen;
        }
    }
    return on_boundary;
}

template <int D>
void freeze_required(const Mesh<D>& mesh, GeometryClasses<D>& classes) {
    const auto freeze = [&](const auto& nodes) {
        for (const NodeId v : nodes) {
            classes.node[v] = NodeClass::frozen;
        }
    };
    const Features& features = mesh.features;
    freeze(features.corners);
    freeze(features.required_nodes);
    for (const int e : features.required_edges) {
        if constexpr (D == 3) {
            freeze(features.edges[static_cast<std::size_t>(e)]);
        } else {
            freeze(mesh.faces[FaceId(e)]);
        }
    }
    for (const int f : features.required_faces) {
        freeze(mesh.faces[FaceId(f)]);
    }
    for (const int e : features.required_elements) {
        freeze(mesh.elements[ElementId(e)]);
    }
    for (const FaceId f : mesh.faces.ids()) {
        const auto& frozen = classes.frozen_patches;
        if (std::find(frozen.begin(), frozen.end(), mesh.patch[f]) != frozen.end()) {
            freeze(mesh.faces[f]);
        }
    }
}

/// An edge of the boundary with one of the faces at it.
struct EdgeUse {
    Edge edge;
    FaceId face;
    friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

std::vector<EdgeUse> boundary_edge_uses(const Mesh<3>& mesh, const std::vector<bool>& on_boundary) {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * mesh.faces.size());
    for (const FaceId f : mesh.faces.ids()) {
        if (!on_boundary[f.index()]) {
            continue;
        }
        const Facet<3>& n = mesh.faces[f];
        for (int i = 0; i < 3; ++i) {
            uses.push_back({sorted(Edge{n[i], n[(i + 1) % 3]}), f});
        }
    }
    std::sort(uses.begin(), uses.end());
    return uses;
}

/// Edges the file lists, with what it says of them, sorted by nodes.
std::vector<RidgeEdge> listed_edges(const Mesh<3>& mesh) {
    std::vector<RidgeEdge> listed;
    const Features& features = mesh.features;
    for (std::size_t i = 0; i < features.edges.size(); ++i) {
        listed.push_back({sorted(features.edges[i]), features.edge_labels[i], true, false});
    }
    for (const int r : features.ridges) {
        listed[static_cast<std::size_t>(r)].declared = true;
    }
    std::sort(listed.begin(), listed.end(),
              [](const RidgeEdge& a, const RidgeEdge& b) { return a.nodes < b.nodes; });
    return listed;
}

/// All ridges: listed ones, changes of patch, sharp angles. Listed edges inside the domain come
/// too.
std::vector<RidgeEdge> find_ridges(const Mesh<3>& mesh, const std::vector<bool>& on_boundary,
                                   double ridge_angle_deg) {
    const std::vector<EdgeUse> uses = boundary_edge_uses(mesh, on_boundary);
    const std::vector<RidgeEdge> listed = listed_edges(mesh);
    const double least_cosine = std::cos(radians(ridge_angle_deg));
    std::vector<RidgeEdge> ridges;
    auto next_listed = listed.begin();
    for (std::size_t i = 0; i < uses.size();) {
        std::size_t end = i + 1;
        while (end < uses.size() && uses[end].edge == uses[i].edge) {
            ++end;
        }
        const FaceId f = uses[i].face, g = uses[end - 1].face;
        while (next_listed != listed.end() && next_listed->nodes < uses[i].edge) {
            ridges.push_back(*next_listed++);
        }
        const bool in_list = next_listed != listed.end() && next_listed->nodes == uses[i].edge;
        const bool sharp =
            end - i != 2 || mesh.patch[f] != mesh.patch[g] ||
            unit_normal(mesh, mesh.faces[f]).dot(unit_normal(mesh, mesh.faces[g])) < least_cosine;
        if (in_list) {
            ridges.push_back(*next_listed++);
        } else if (sharp) {
            ridges.push_back({uses[i].edge, 0, false, false});
        }
        i = end;
    }
    ridges.insert(ridges.end(), next_listed, listed.end());
    return ridges;
}

/// Nodes of ridges: corners where the line ends, branches, turns or changes its label.
void classify_ridge_nodes(const Mesh<3>& mesh, double corner_angle_deg,
                          GeometryClasses<3>& classes) {
    struct Use {
        NodeId node, other;
        std::size_t ridge;
    };
    std::vector<Use> uses;
    for (std::size_t r = 0; r < classes.ridges.size(); ++r) {
        const Edge& e = classes.ridges[r].nodes;
        uses.push_back({e[0], e[1], r});
        uses.push_back({e[1], e[0], r});
    }
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
        return std::pair(a.node, a.other) < std::pair(b.node, b.other);
    });
    const double straight = std::cos(radians(corner_angle_deg));
    for (std::size_t i = 0; i < uses.size();) {
        std::size_t end = i + 1;
        while (end < uses.size() && uses[end].node == uses[i].node) {
            ++end;
        }
        const NodeId v = uses[i].node;
        // A line inside the domain: its nodes stay.
        bool corner = end - i != 2 || classes.node[v] == NodeClass::interior;
        if (!corner) {
            const RidgeEdge& r = classes.ridges[uses[i].ridge];
            const RidgeEdge& s = classes.ridges[uses[i + 1].ridge];
            const Vec<3> before = mesh.points[v] - mesh.points[uses[i].other];
            const Vec<3> after = mesh.points[uses[i + 1].other] - mesh.points[v];
            corner = r.label != s.label || r.listed != s.listed ||
                     before.normalized().dot(after.normalized()) < straight;
        }
        classes.node[v] =
            corner || classes.node[v] == NodeClass::frozen ? NodeClass::frozen : NodeClass::ridge;
        i = end;
    }
}

/// Boundary nodes in two dimensions: corners where patches meet or the boundary turns.
void classify_boundary_nodes(const Mesh<2>& mesh, const std::vector<bool>& on_boundary,
                             double corner_angle_deg, GeometryClasses<2>& classes) {
    IdVector<NodeId, FaceId> arriving(mesh.points.size()), leaving(mesh.points.size());
    IdVector<NodeId, int> uses(mesh.points.size(), 0);
    for (const FaceId f : mesh.faces.ids()) {
        if (on_boundary[f.index()]) {
            leaving[mesh.faces[f][0]] = f;
            arriving[mesh.faces[f][1]] = f;
            ++uses[mesh.faces[f][0]];
            ++uses[mesh.faces[f][1]];
        }
    }
    const double straight = std::cos(radians(corner_angle_deg));
    for (const NodeId v : mesh.points.ids()) {
        if (uses[v] == 0 || classes.node[v] == NodeClass::frozen) {
            continue;
        }
        bool corner = uses[v] != 2 || !arriving[v].valid() || !leaving[v].valid() ||
                      mesh.patch[arriving[v]] != mesh.patch[leaving[v]];
        if (!corner) {
            const Vec<2> before = mesh.points[v] - mesh.points[mesh.faces[arriving[v]][0]];
            const Vec<2> after = mesh.points[mesh.faces[leaving[v]][1]] - mesh.points[v];
            corner = before.normalized().dot(after.normalized()) < straight;
        }
        classes.node[v] = corner ? NodeClass::frozen : NodeClass::patch;
    }
    for (const int f : mesh.features.ridges) {
        for (const NodeId v : mesh.faces[FaceId(f)]) {
            classes.node[v] = NodeClass::frozen;
        }
    }
}

} // namespace

template <int D>
std::vector<int> frozen_patches(const Mesh<D>& mesh, const FeatureOptions& options) {
    std::vector<int> patches =
        options.boundary == BoundaryChoice::keep ? mesh.patch.raw() : options.frozen_patches;
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    return patches;
}

template <int D>
GeometryClasses<D> classify_geometry(const Mesh<D>& mesh, const FeatureOptions& options) {
    GeometryClasses<D> classes;
    classes.frozen_patches = frozen_patches(mesh, options);
    classes.node.assign(mesh.points.size(), NodeClass::interior);
    classes.deviation.assign(mesh.faces.size(), 0.0);
    const std::vector<bool> on_boundary = freeze_interfaces(mesh, classes);
    if constexpr (D == 3) {
        for (const FaceId f : mesh.faces.ids()) {
            for (const NodeId v : mesh.faces[f]) {
                if (classes.node[v] == NodeClass::interior) {
                    classes.node[v] = NodeClass::patch;
                }
            }
        }
        classes.ridges = find_ridges(mesh, on_boundary, options.ridge_angle_deg);
        classify_ridge_nodes(mesh, options.corner_angle_deg, classes);
    } else {
        classify_boundary_nodes(mesh, on_boundary, options.corner_angle_deg, classes);
    }
    freeze_required(mesh, classes);
    std::vector<FaceId> outer;
    for (const FaceId f : mesh.faces.ids()) {
        if (on_boundary[f.index()]) {
            outer.push_back(f);
        }
    }
    classes.original = std::make_shared<const OriginalSurface<D>>(mesh, outer, classes.ridges);
    return classes;
}

template std::vector<int> frozen_patches(const Mesh<2>&, const FeatureOptions&);
template std::vector<int> frozen_patches(const Mesh<3>&, const FeatureOptions&);
template GeometryClasses<2> classify_geometry(const Mesh<2>&, const FeatureOptions&);
template GeometryClasses<3> classify_geometry(const Mesh<3>&, const FeatureOptions&);

} // namespace ameco
