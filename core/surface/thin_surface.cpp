// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/thin_surface.h"

#include "core/geometry/distance.h"
#include "core/mesh/simplex.h"
#include "core/surface/half_edges.h"
#include "core/surface/surface_tree.h"

#include <Eigen/Geometry>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ameco {
namespace {

namespace om = OpenMesh;
using Connectivity = om::TriMesh_ArrayKernelT<>;

class Thinner {
public:
    Thinner(const Mesh<3>& surface, const ThinningInput& input)
        : given_(surface), in_(input), tree_(surface), kept_(surface.points.size()),
          removed_(surface.points.size()),
          least_cosine_(std::cos(input.largest_turn_deg * std::numbers::pi / 180)) {
        static_cast<void>(HalfEdges(surface)); // refuses what is no manifold, in words
        mesh_.request_vertex_status();
        mesh_.request_edge_status();
        mesh_.request_halfedge_status();
        mesh_.request_face_status();
        for (std::size_t i = 0; i < surface.points.size(); ++i) {
            static_cast<void>(mesh_.new_vertex());
        }
        for (const Facet<3>& f : surface.faces) {
            static_cast<void>(mesh_.add_face(handle(f[0]), handle(f[1]), handle(f[2])));
        }
        deviation_ = input.deviation;
        deviation_.resize(surface.faces.size(), 0.0);
        attached_.resize(surface.faces.size());
        node_deviation_.resize(surface.points.size(), 0);
        for (const FaceId f : surface.faces.ids()) {
            for (const NodeId v : surface.faces[f]) {
                node_deviation_[v.index()] =
                    std::max(node_deviation_[v.index()], given_deviation(f));
            }
        }
        for (const SurfaceRidge& r : input.ridges) {
            if (ridges_.try_emplace(sorted(r.nodes), r.number).second) {
                on_ridge_[r.nodes[0]].push_back(r.nodes[1]);
                on_ridge_[r.nodes[1]].push_back(r.nodes[0]);
            }
        }
    }

    Thinning run() {
        for (const NodeId v : in_.order) {
            if (!in_.frozen[v.index()] && try_to_leave(v)) {
                removed_[v.index()] = true;
                ++result_.collapses;
            } else {
                kept_[v.index()] = true;
            }
        }
        collect();
        return std::move(result_);
    }

private:
    /// A face as it would be after a collapse.
    struct FreshFace {
        FaceId id;
        std::array<Vec<3>, 3> corners;
        double bound = 0; ///< of its deviation [L]
        std::vector<NodeId> attached;
    };

    [[nodiscard]] static om::VertexHandle handle(NodeId v) { return om::VertexHandle(v.value()); }
    [[nodiscard]] static NodeId node(om::VertexHandle v) { return NodeId(v.idx()); }

    [[nodiscard]] Facet<3> nodes_of(om::FaceHandle f) const {
        Facet<3> nodes;
        std::size_t k = 0;
        for (auto v = mesh_.cfv_ccwbegin(f); v.is_valid() && k < 3; ++v) {
            nodes[k++] = node(*v);
        }
        return nodes;
    }
    [[nodiscard]] Vec<3> normal_of(const Facet<3>& f) const {
        const auto& x = given_.points;
        return (x[f[1]] - x[f[0]]).cross(x[f[2]] - x[f[0]]).stableNormalized();
    }
    [[nodiscard]] bool is_ridge(NodeId a, NodeId b) const {
        return ridges_.find(sorted(Edge{a, b})) != ridges_.end();
    }

    [[nodiscard]] double given_deviation(FaceId f) const {
        return in_.deviation.empty() ? 0 : in_.deviation[f];
    }

    bool try_to_leave(NodeId v) {
        std::vector<std::pair<double, NodeId>> candidates;
        for (auto w = mesh_.cvv_ccwbegin(handle(v)); w.is_valid(); ++w) {
            const NodeId n = node(*w);
            if (kept_[n.index()] && in_.too_close(v, n) &&
                (on_ridge_.count(v) == 0 || is_ridge(v, n))) {
                candidates.emplace_back((given_.points[n] - given_.points[v]).norm(), n);
            }
        }
        std::sort(candidates.begin(), candidates.end());
        for (const auto& [length, w] : candidates) {
            if (collapse(v, w)) {
                return true;
            }
        }
        result_.refused += candidates.empty() ? 0 : 1;
        return false;
    }

    bool collapse(NodeId v, NodeId w) {
        const auto along = mesh_.find_halfedge(handle(v), handle(w));
        if (!mesh_.is_collapse_ok(along) || !judge(v, w)) {
            return false;
        }
        mesh_.collapse(along);
        for (FreshFace& f : fresh_) {
            deviation_[f.id] = f.bound;
            attached_[f.id] = std::move(f.attached);
        }
        move_ridges(v, w);
        return true;
    }

    /// Whether the faces that are left around `v` may have `w` in its place. Nodes that left before
    /// stay attached to the face that was closest to them, and are looked at again.
    bool judge(NodeId v, NodeId w) {
        fresh_.clear();
        std::vector<NodeId> samples{v};
        for (auto f = mesh_.cvf_ccwbegin(handle(v)); f.is_valid(); ++f) {
            const FaceId id((*f).idx());
            const Facet<3> before = nodes_of(*f);
            samples.insert(samples.end(), attached_[id].begin(), attached_[id].end());
            if (std::find(before.begin(), before.end(), w) != before.end()) {
                continue;
            }
            Facet<3> after = before;
            std::replace(after.begin(), after.end(), v, w);
            if (!(normal_of(after).dot(normal_of(before)) >= least_cosine_)) {
                return false;
            }
            fresh_.push_back(
                {id,
                 {given_.points[after[0]], given_.points[after[1]], given_.points[after[2]]},
                 0,
                 {}});
        }
        return !fresh_.empty() && attach(samples) &&
               std::all_of(fresh_.begin(), fresh_.end(),
                           [&](FreshFace& f) { return is_near(f, v); });
    }

    /// Attaches removed nodes to the new faces closest to them.
    bool attach(const std::vector<NodeId>& samples) {
        for (const NodeId s : samples) {
            double least = std::numeric_limits<double>::infinity();
            FreshFace* closest = nullptr;
            for (FreshFace& f : fresh_) {
                const double d = distance(given_.points[s], f.corners);
                if (d < least) {
                    least = d;
                    closest = &f;
                }
            }
            if (least > in_.reach[s.index()]) {
                return false;
            }
            closest->attached.push_back(s);
            closest->bound = std::max(closest->bound, least + node_deviation_[s.index()]);
        }
        return true;
    }

    /// Whether a new face keeps its distance, sampled at the middles of the face and its edges,
    /// too.
    bool is_near(FreshFace& f, NodeId v) {
        const auto& [a, b, c] = f.corners;
        for (const Vec<3>& x : {Vec<3>((a + b) / 2), Vec<3>((b + c) / 2), Vec<3>((c + a) / 2),
                                Vec<3>((a + b + c) / 3)}) {
            const auto closest = tree_.closest(x);
            if (closest.distance > in_.reach[v.index()]) {
                return false;
            }
            f.bound = std::max(f.bound, closest.distance + given_deviation(closest.face));
        }
        const double edge = ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3;
        return f.bound <= in_.relative_distance * edge;
    }

    void move_ridges(NodeId v, NodeId w) {
        if (on_ridge_.count(v) == 0) {
            return;
        }
        std::vector<std::pair<Edge, int>> moved;
        for (const NodeId other : std::vector<NodeId>(on_ridge_[v])) {
            const auto ridge = ridges_.find(sorted(Edge{v, other}));
            if (other != w) {
                moved.emplace_back(sorted(Edge{w, other}), ridge->second);
                std::replace(on_ridge_[other].begin(), on_ridge_[other].end(), v, w);
                on_ridge_[w].push_back(other);
            } else {
                std::erase(on_ridge_[w], v);
            }
            ridges_.erase(ridge);
        }
        ridges_.insert(moved.begin(), moved.end());
    }

    void collect() {
        result_.surface.points = given_.points;
        result_.surface.patch_names = given_.patch_names;
        for (const auto f : mesh_.faces()) {
            if (!mesh_.status(f).deleted()) {
                const FaceId id(f.idx());
                result_.surface.faces.push_back(nodes_of(f));
                result_.surface.patch.push_back(given_.patch[id]);
                result_.deviation.push_back(deviation_[id]);
                result_.attached.push_back(attached_[id]);
            }
        }
        for (const auto& [edge, number] : ridges_) {
            result_.ridges.push_back({edge, number});
        }
        result_.removed = removed_;
    }

    const Mesh<3>& given_;
    const ThinningInput& in_;
    SurfaceTree tree_;
    Connectivity mesh_;
    std::vector<bool> kept_, removed_;
    double least_cosine_;
    IdVector<FaceId, double> deviation_;
    std::vector<double> node_deviation_;             ///< [n] largest of the given faces at a node
    IdVector<FaceId, std::vector<NodeId>> attached_; ///< removed nodes at each face
    std::vector<FreshFace> fresh_;                   ///< scratch of `judge`
    std::map<Edge, int> ridges_;
    std::map<NodeId, std::vector<NodeId>> on_ridge_; ///< the other ends of ridges at a node
    Thinning result_;
};

} // namespace

Thinning thin_surface(const Mesh<3>& surface, const ThinningInput& input) {
    return Thinner(surface, input).run();
}

} // namespace ameco
