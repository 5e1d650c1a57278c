// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/surface_rules.h"

#include "core/geometry/distance.h"
#include "core/metric/element_metric.h"
#include "core/remesh/original_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace ameco {
namespace {

template <int D>
using Corners = std::array<Vec<D>, D>;

Vec<2> normal(const Corners<2>& c) {
    const Vec<2> t = c[1] - c[0];
    return {t[1], -t[0]};
}

Vec<3> normal(const Corners<3>& c) {
    return (c[1] - c[0]).cross(c[2] - c[0]);
}

template <int D>
Corners<D> corners(const EditMesh<D>& mesh, const Simplex<D>& ghost_element) {
    const Facet<D> f = ghost_face<D>(ghost_element);
    Corners<D> c;
    for (int i = 0; i < D; ++i) {
        c[i] = mesh.point(f[i]);
    }
    return c;
}

template <int D>
bool turns_too_far(const Corners<D>& before, const Corners<D>& after, double least_cosine) {
    const Vec<D> a = normal(before), b = normal(after);
    return !(a.dot(b) >= least_cosine * a.norm() * b.norm()) || b.squaredNorm() == 0;
}

/// Nodes and edge midpoints of a face.
template <int D>
std::vector<Vec<D>> samples(const Corners<D>& c) {
    std::vector<Vec<D>> s(c.begin(), c.end());
    for (std::size_t i = 0; i + 1 < c.size(); ++i) {
        for (std::size_t j = i + 1; j < c.size(); ++j) {
            s.push_back((c[i] + c[j]) / 2);
        }
    }
    return s;
}

/// Largest distance of the samples of `from` to the surface `to`.
template <int D>
double one_sided_distance(const std::vector<Corners<D>>& from, const std::vector<Corners<D>>& to) {
    double largest = 0;
    for (const Corners<D>& face : from) {
        for (const Vec<D>& p : samples<D>(face)) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const Corners<D>& other : to) {
                nearest = std::min(nearest, distance(p, other));
                if (nearest <= largest) {
                    break;
                }
            }
            largest = std::max(largest, nearest);
        }
    }
    return largest;
}

template <int D>
double two_sided_distance(const std::vector<Corners<D>>& a, const std::vector<Corners<D>>& b) {
    return std::max(one_sided_distance<D>(a, b), one_sided_distance<D>(b, a));
}

template <int D>
double mean_edge(const std::vector<Corners<D>>& faces) {
    double sum = 0;
    std::size_t count = 0;
    for (const Corners<D>& c : faces) {
        for (std::size_t i = 0; i + 1 < c.size(); ++i) {
            for (std::size_t j = i + 1; j < c.size(); ++j) {
                sum += (c[i] - c[j]).norm();
                ++count;
            }
        }
    }
    return sum / static_cast<double>(count);
}

template <int D>
bool has_all(const Simplex<D>& s, const Facet<D>& face) {
    return std::all_of(face.begin(), face.end(),
                       [&](NodeId v) { return std::find(s.begin(), s.end(), v) != s.end(); });
}

/// Short size h_1 of an element [L].
template <int D>
double short_size_of(const EditMesh<D>& mesh, const Simplex<D>& element) {
    return element_metric<D>(corners_of(mesh, element)).sizes[0];
}

/// Whether the elements of a star are high enough on boundary faces of the star that may lie at a
/// distance from the original ones.
template <int D>
bool covers_distance(const EditMesh<D>& mesh, double distance, double layer_share,
                     const Star<D>& star) {
    for (const EditElement<D>& ghost : star.elements) {
        if (ghost.nodes[D] != mesh.ghost()) {
            continue;
        }
        const Facet<D> face = ghost_face<D>(ghost.nodes);
        for (const EditElement<D>& e : star.elements) {
            if (e.nodes[D] != mesh.ghost() && has_all<D>(e.nodes, face) &&
                distance > layer_share * short_size_of(mesh, e.nodes)) {
                return false;
            }
        }
    }
    return true;
}

/// The ghost element on a facet whose nodes are all on the boundary; none if it is inside.
template <int D>
ElementId ghost_on(const EditMesh<D>& mesh, const Facet<D>& facet) {
    for (const ElementId e : mesh.ball(facet[0])) {
        if (mesh.is_ghost(e) && has_all<D>(mesh.nodes(e), facet)) {
            return e;
        }
    }
    return {};
}

} // namespace

template <int D>
Verdict judge_layer(const EditMesh<D>& mesh, const Cavity<D>& cavity, const SurfaceRules& rules,
                    const Star<D>& star) {
    for (const EditElement<D>& e : star.elements) {
        for (int i = 0; i <= D; ++i) {
            const Facet<D> facet = facet_of<D>(e.nodes, i);
            if (!std::all_of(facet.begin(), facet.end(),
                             [&](NodeId v) { return mesh.on_boundary(v); })) {
                continue;
            }
            const ElementId ghost = ghost_on<D>(mesh, facet);
            const double distance =
                ghost.valid() ? static_cast<double>(mesh.element(ghost).measure) : 0;
            if (distance == 0) {
                continue;
            }
            const double h = short_size_of(mesh, e.nodes);
            if (distance <= rules.layer_share * h) {
                continue;
            }
            const bool was_thinner =
                std::any_of(cavity.elements.begin(), cavity.elements.end(), [&](ElementId old) {
                    return has_all<D>(mesh.nodes(old), facet) &&
                           short_size_of(mesh, mesh.nodes(old)) <= h;
                });
            if (!was_thinner) {
                return Verdict::surface_distance;
            }
        }
    }
    return Verdict::accepted;
}

template <int D>
Verdict judge_surface(const EditMesh<D>& mesh, const Cavity<D>& cavity, double short_size,
                      const SurfaceRules& rules, Star<D>& star) {
    std::vector<Corners<D>> before, after;
    double deviation = 0;
    for (const ElementId e : cavity.elements) {
        if (mesh.is_ghost(e)) {
            before.push_back(corners(mesh, mesh.nodes(e)));
            deviation = std::max(deviation, static_cast<double>(mesh.element(e).measure));
        }
    }
    const double least_cosine = std::cos(rules.largest_turn_deg * std::numbers::pi / 180);
    for (std::size_t i = 0; i < star.elements.size(); ++i) {
        if (star.elements[i].nodes[D] != mesh.ghost()) {
            continue;
        }
        after.push_back(corners(mesh, star.elements[i].nodes));
        if (turns_too_far<D>(corners(mesh, mesh.nodes(star.sources[i])), after.back(),
                             least_cosine)) {
            return Verdict::surface_normal;
        }
    }
    const double moved = two_sided_distance<D>(before, after);
    const double off = deviation + moved;
    if (moved > rules.layer_share * short_size ||
        off > rules.relative_distance * mean_edge<D>(after) ||
        (off > 0 && !covers_distance(mesh, off, rules.layer_share, star))) {
        return Verdict::surface_distance;
    }
    for (EditElement<D>& e : star.elements) {
        if (e.nodes[D] == mesh.ghost()) {
            e.measure = bound_above(off);
        }
    }
    return Verdict::accepted;
}

template <int D>
void gather_faces(const EditMesh<D>& mesh, NodeId v, NodeFaces<D>& faces) {
    faces.ghosts.clear();
    faces.corners.clear();
    for (const ElementId e : mesh.ball(v)) {
        if (mesh.is_ghost(e)) {
            faces.ghosts.push_back(e);
            faces.corners.push_back(corners(mesh, mesh.nodes(e)));
        }
    }
}

template <int D>
Verdict judge_moved_faces(EditMesh<D>& mesh, NodeId v, const NodeFaces<D>& before,
                          double short_size, const SurfaceRules& rules) {
    NodeFaces<D> after;
    gather_faces(mesh, v, after);
    const double least_cosine = std::cos(rules.largest_turn_deg * std::numbers::pi / 180);
    double deviation = 0;
    for (std::size_t i = 0; i < after.ghosts.size(); ++i) {
        if (turns_too_far<D>(before.corners[i], after.corners[i], least_cosine)) {
            return Verdict::surface_normal;
        }
        deviation = std::max(deviation, static_cast<double>(mesh.element(after.ghosts[i]).measure));
    }
    const double moved = two_sided_distance<D>(before.corners, after.corners);
    if (moved > rules.layer_share * short_size) {
        return Verdict::surface_distance;
    }
    const auto farthest = [&](const NodeFaces<D>& faces) {
        double largest = 0;
        for (std::size_t i = 0; i < faces.ghosts.size(); ++i) {
            largest = std::max(largest, distance_to_original<D>(faces.corners[i],
                                                                mesh.element(faces.ghosts[i]).label,
                                                                *mesh.original_surface()));
        }
        return largest;
    };
    const double distance_after = farthest(after);
    if (distance_after > rules.relative_distance * mean_edge<D>(after.corners) &&
        distance_after > farthest(before)) {
        return Verdict::surface_distance;
    }
    for (const ElementId e : after.ghosts) {
        mesh.set_measure(e, bound_above(deviation + moved));
    }
    return Verdict::accepted;
}

namespace {

/// Facets of the ball of `v` opposite it, sorted nodes, in ascending order: the link of v.
template <int D>
std::vector<Facet<D>> link_facets(const EditMesh<D>& mesh, NodeId v) {
    std::vector<Facet<D>> facets;
    for (const ElementId e : mesh.ball(v)) {
        Facet<D> f;
        std::size_t k = 0;
        for (const NodeId w : mesh.nodes(e)) {
            if (w != v) {
                f[k++] = w;
            }
        }
        facets.push_back(sorted(f));
    }
    std::sort(facets.begin(), facets.end());
    return facets;
}

/// All nodes, and in 3-D all edges, of a set of facets.
template <int D, std::size_t N>
std::vector<std::array<NodeId, N>> faces_of(const std::vector<Facet<D>>& facets) {
    std::vector<std::array<NodeId, N>> out;
    for (const Facet<D>& f : facets) {
        for (std::size_t i = 0; i < f.size(); ++i) {
            if constexpr (N == 1) {
                out.push_back({f[i]});
            } else {
                for (std::size_t j = i + 1; j < f.size(); ++j) {
                    out.push_back({f[i], f[j]});
                }
            }
        }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

template <class T>
std::size_t count_common(const std::vector<T>& a, const std::vector<T>& b) {
    std::vector<T> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    return common.size();
}

/// Facets of `link` that contain `v`, with v left out: the link of an edge.
template <int D>
std::vector<std::array<NodeId, D - 1>> link_of_edge(const std::vector<Facet<D>>& link, NodeId v) {
    std::vector<std::array<NodeId, D - 1>> out;
    for (const Facet<D>& f : link) {
        std::array<NodeId, D - 1> rest;
        std::size_t k = 0;
        for (const NodeId w : f) {
            if (w != v && k < rest.size()) {
                rest[k++] = w;
            } else if (w != v) {
                k = D; // v is not in f
            }
        }
        if (k == D - 1) {
            out.push_back(rest);
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace

template <int D>
Verdict check_link(const EditMesh<D>& mesh, NodeId removed, NodeId kept) {
    const auto a = link_facets(mesh, removed), b = link_facets(mesh, kept);
    const auto edge_link = link_of_edge<D>(a, kept);
    if (count_common(a, b) != 0) {
        return Verdict::link_condition;
    }
    if constexpr (D == 2) {
        if (count_common(faces_of<D, 1>(a), faces_of<D, 1>(b)) != edge_link.size()) {
            return Verdict::link_condition;
        }
    } else {
        if (count_common(faces_of<D, 2>(a), faces_of<D, 2>(b)) != edge_link.size()) {
            return Verdict::link_condition;
        }
        std::vector<std::array<NodeId, 1>> ring;
        for (const auto& e : edge_link) {
            ring.push_back({e[0]});
            ring.push_back({e[1]});
        }
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        if (count_common(faces_of<D, 1>(a), faces_of<D, 1>(b)) != ring.size()) {
            return Verdict::link_condition;
        }
    }
    return Verdict::accepted;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template Verdict judge_surface(const EditMesh<D>&, const Cavity<D>&, double,                   \
                                   const SurfaceRules&, Star<D>&);                                 \
    template Verdict judge_layer(const EditMesh<D>&, const Cavity<D>&, const SurfaceRules&,        \
                                 const Star<D>&);                                                  \
    template void gather_faces(const EditMesh<D>&, NodeId, NodeFaces<D>&);                         \
    template Verdict judge_moved_faces(EditMesh<D>&, NodeId, const NodeFaces<D>&, double,          \
                                       const SurfaceRules&);                                       \
    template Verdict check_link(const EditMesh<D>&, NodeId, NodeId);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
