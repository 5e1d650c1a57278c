// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_features.h"

#include "core/mesh/adjacency.h"
#include "core/mesh/simplex.h"
#include "core/mesh/surface_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace ameco {
namespace {

double cosine(double degrees) {
    return std::cos(degrees * std::numbers::pi / 180);
}

Vec<3> unit_normal(const Mesh<3>& mesh, FaceId id) {
    const Facet<3>& f = mesh.faces[id];
    return (mesh.points[f[1]] - mesh.points[f[0]])
        .cross(mesh.points[f[2]] - mesh.points[f[0]])
        .stableNormalized();
}

/// Whether the two faces of an edge turn by no more than an angle with this cosine. Faces that run
/// through the edge in the same direction have normals to opposite sides.
bool is_smooth(const Mesh<3>& mesh, std::span<const EdgeUse> at, double least_cosine) {
    if (at.size() != 2) {
        return false;
    }
    const double agree = at[0].ascending != at[1].ascending ? 1 : -1;
    return agree * unit_normal(mesh, at[0].face).dot(unit_normal(mesh, at[1].face)) >= least_cosine;
}

struct Ridge {
    Edge nodes;
    std::pair<int, int> patches; ///< the same twice at an open edge
};

std::vector<Ridge> find_ridges(const Mesh<3>& mesh, double least_cosine) {
    std::set<Edge> listed;
    for (const Edge& e : mesh.features.edges) {
        listed.insert(sorted(e));
    }
    std::vector<Ridge> ridges;
    for_each_edge(edge_uses(mesh.faces), [&](std::span<const EdgeUse> at) {
        const int p = mesh.patch[at.front().face], q = mesh.patch[at.back().face];
        if (p != q || !is_smooth(mesh, at, least_cosine) || listed.count(at[0].edge) > 0) {
            ridges.push_back({at[0].edge, std::minmax(p, q)});
        }
    });
    return ridges;
}

using RidgesAt = Lists<NodeId, FaceId>; // numbers of ridges, in the clothes of face numbers

NodeId other_end(const Ridge& ridge, NodeId v) {
    return ridge.nodes[0] == v ? ridge.nodes[1] : ridge.nodes[0];
}

/// Follows ridges from corner to corner.
class CurveWalk {
public:
    CurveWalk(const Mesh<3>& mesh, const std::vector<Ridge>& ridges, double corner_angle_deg)
        : mesh_(mesh), ridges_(ridges), walked_(ridges.size()),
          at_(file_under<NodeId, FaceId>(mesh.points.size(), ridges.size(),
                                         [&](FaceId r) { return ridges[r.index()].nodes; })) {
        find_corners(cosine(corner_angle_deg));
    }

    [[nodiscard]] std::vector<NodeId> corners() const { return {corners_.begin(), corners_.end()}; }

    [[nodiscard]] std::vector<SurfaceCurve> curves() {
        std::vector<SurfaceCurve> curves;
        for (const NodeId v : corners_) {
            for (const FaceId r : at_[v]) {
                if (!walked_[r.index()]) {
                    curves.push_back(walk(v, r.index()));
                }
            }
        }
        for (std::size_t r = 0; r < ridges_.size(); ++r) { // loops without a corner
            if (!walked_[r]) {
                curves.push_back(walk(ridges_[r].nodes[0], r));
            }
        }
        return curves;
    }

private:
    void find_corners(double straight) {
        corners_.insert(mesh_.features.corners.begin(), mesh_.features.corners.end());
        for (const NodeId v : mesh_.points.ids()) {
            const auto here = at_[v];
            if (here.empty()) {
                continue;
            }
            if (here.size() != 2) {
                corners_.insert(v);
                continue;
            }
            const Ridge& r = ridges_[here[0].index()];
            const Ridge& s = ridges_[here[1].index()];
            const Vec<3> before = mesh_.points[v] - mesh_.points[other_end(r, v)];
            const Vec<3> after = mesh_.points[other_end(s, v)] - mesh_.points[v];
            if (r.patches != s.patches ||
                before.stableNormalized().dot(after.stableNormalized()) < straight) {
                corners_.insert(v);
            }
        }
    }

    SurfaceCurve walk(NodeId v, std::size_t r) {
        SurfaceCurve curve;
        curve.nodes = {v};
        curve.patches = ridges_[r].patches;
        for (;;) {
            walked_[r] = true;
            const NodeId next = other_end(ridges_[r], v);
            curve.length += (mesh_.points[next] - mesh_.points[v]).norm();
            curve.nodes.push_back(next);
            v = next;
            const auto here = at_[v];
            const auto onward = std::find_if(here.begin(), here.end(),
                                             [&](FaceId s) { return !walked_[s.index()]; });
            if (corners_.count(v) > 0 || onward == here.end()) {
                return curve;
            }
            r = onward->index();
        }
    }

    const Mesh<3>& mesh_;
    const std::vector<Ridge>& ridges_;
    std::vector<bool> walked_;
    RidgesAt at_;
    std::set<NodeId> corners_;
};

} // namespace

SurfaceFeatures find_surface_features(const Mesh<3>& mesh, const SurfaceFeatureOptions& options) {
    const std::vector<Ridge> ridges = find_ridges(mesh, cosine(options.ridge_angle_deg));
    SurfaceFeatures features;
    for (const Ridge& r : ridges) {
        features.ridges.push_back(r.nodes);
    }
    CurveWalk walk(mesh, ridges, options.corner_angle_deg);
    features.corners = walk.corners();
    features.curves = walk.curves();
    return features;
}

int segment_by_angle(Mesh<3>& mesh, double ridge_angle_deg) {
    const double least_cosine = cosine(ridge_angle_deg);
    std::vector<std::vector<FaceId>> beside(mesh.faces.size());
    for_each_edge(edge_uses(mesh.faces), [&](std::span<const EdgeUse> at) {
        if (is_smooth(mesh, at, least_cosine)) {
            beside[at[0].face.index()].push_back(at[1].face);
            beside[at[1].face.index()].push_back(at[0].face);
        }
    });
    mesh.patch.assign(mesh.faces.size(), 0);
    mesh.patch_names.clear();
    int patches = 0;
    for (const FaceId start : mesh.faces.ids()) {
        if (mesh.patch[start] != 0) {
            continue;
        }
        mesh.patch[start] = ++patches;
        std::vector<FaceId> front{start};
        while (!front.empty()) {
            const FaceId f = front.back();
            front.pop_back();
            for (const FaceId g : beside[f.index()]) {
                if (mesh.patch[g] == 0) {
                    mesh.patch[g] = patches;
                    front.push_back(g);
                }
            }
        }
    }
    return patches;
}

} // namespace ameco
