// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Meshes under edit, and what must not change while they are; for the tests of the operators.
#pragma once

#include "core/geometry/volume.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/boundary.h"
#include "core/mesh/check.h"
#include "core/metric/nodal_metric.h"
#include "core/remesh/cavity.h"
#include "core/remesh/collapse.h"
#include "core/remesh/edit_notes.h"
#include "core/remesh/metric_quality.h"
#include "core/remesh/removed_nodes.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <vector>

namespace ameco::remesh_test {

/// The same metric at all nodes.
template <int D>
[[nodiscard]] MetricField<D> uniform_metric(std::size_t nodes, const Metric<D>& metric) {
    return MetricField<D>(nodes, metric);
}

/// Cubes of side `h`, at all nodes.
template <int D>
[[nodiscard]] MetricField<D> isotropic(std::size_t nodes, double h) {
    return MetricField<D>(nodes, {Vec<D>::Constant(h), Mat<D>::Identity()});
}

/// A mesh under edit with all that the operators ask for.
template <int D>
struct Workbench {
    Mesh<D> mesh;
    GeometryClasses<D> classes;
    MetricField<D> metric;
    SizeField<D> sizes;
    RootField<D> root;
    const Couplings no_couplings;
    RemovedNodes<D> removed{no_couplings, {}}; ///< none
    IdVector<NodeId, float> short_size;
    EditMesh<D> edit;
    EditNotes notes{edit};

    Workbench(const Mesh<D>& m, const MetricField<D>& field, const FeatureOptions& features = {})
        : mesh(m), classes(classify_geometry(m, features)), metric(field),
          sizes(make_size_field(field)), root(make_root_field(field)), edit(m, classes) {
        for (const Metric<D>& at : field) {
            short_size.push_back(static_cast<float>(at.sizes[0]));
        }
        for (const ElementId e : mesh.elements.ids()) {
            const double q = size_quality(edit, sizes, edit.nodes(e));
            edit.set_measure(e, static_cast<float>(q));
        }
    }
    /// With the natural metric of the mesh.
    explicit Workbench(const Mesh<D>& m) : Workbench(m, nodal_metric(m)) {}
};

constexpr int rod_corners = 24;

/// A slanted rod of polygons, `rod_corners` corners and a radius of 0.2 each, one upon the other in
/// distances of 1. The first node of each polygon is its middle. Diagonals rise with x, so that
/// couplings between the middles are strong, and negative ones cancel them.
[[nodiscard]] inline Mesh<3> make_rod(int polygons) {
    Mesh<3> mesh;
    const auto add_node = [&](double x, double y, int k) {
        mesh.points.push_back({x + k, y, static_cast<double>(k)});
    };
    for (int k = 0; k < polygons; ++k) {
        add_node(0, 0, k);
        for (int i = 0; i < rod_corners; ++i) {
            const double angle = 2 * M_PI * (i + 0.5) / rod_corners;
            add_node(0.2 * std::cos(angle), 0.2 * std::sin(angle), k);
        }
    }
    const auto add = [&](Simplex<3> s) {
        const Vec<3> a = mesh.points[s[0]];
        if ((mesh.points[s[1]] - a).cross(mesh.points[s[2]] - a).dot(mesh.points[s[3]] - a) < 0) {
            std::swap(s[2], s[3]);
        }
        mesh.elements.push_back(s);
        mesh.region.push_back(0);
    };
    for (std::size_t below = 0; below + rod_corners + 1 < mesh.points.size();
         below += rod_corners + 1) {
        for (std::size_t i = 0; i < rod_corners; ++i) {
            std::array<NodeId, 3> v{NodeId(below), NodeId(below + 1 + i),
                                    NodeId(below + 1 + (i + 1) % rod_corners)};
            std::sort(v.begin(), v.end(), [&](NodeId a, NodeId b) {
                const double xa = mesh.points[a][0], xb = mesh.points[b][0];
                return std::abs(xa - xb) > 1e-12 ? xa < xb : a < b;
            });
            std::array<NodeId, 3> up;
            std::transform(v.begin(), v.end(), up.begin(),
                           [](NodeId n) { return NodeId(n.index() + rod_corners + 1); });
            add({v[0], v[1], v[2], up[2]});
            add({v[0], v[1], up[1], up[2]});
            add({v[0], up[0], up[1], up[2]});
        }
    }
    complete_boundary(mesh);
    return mesh;
}

/// Nodes that share an element with `v`, the ghost not among them, ascending.
template <int D>
[[nodiscard]] std::vector<NodeId> neighbours(const EditMesh<D>& mesh, NodeId v) {
    std::set<NodeId> found;
    for (const ElementId e : mesh.ball(v)) {
        found.insert(mesh.nodes(e).begin(), mesh.nodes(e).end());
    }
    found.erase(v);
    found.erase(mesh.ghost());
    return {found.begin(), found.end()};
}

/// Tries collapses of random nodes of the boundary, each along a random edge; any positive quality
/// will do. Returns how many were made.
template <int D>
std::size_t collapse_boundary_nodes(Workbench<D>& bench, std::mt19937& random, int attempts,
                                    const SurfaceRules& surface) {
    Cavity<D> ball;
    Star<D> star;
    std::size_t made = 0;
    for (int i = 0; i < attempts; ++i) {
        const NodeId v(random() % bench.edit.node_count());
        if (bench.edit.is_removed(v) || !bench.edit.on_boundary(v)) {
            continue;
        }
        const auto around = neighbours(bench.edit, v);
        const Collapse collapse{v, around[random() % around.size()]};
        gather_ball(bench.edit, v, ball);
        if (propose_collapse(bench.edit, bench.sizes, surface, {0, 0}, 1, collapse, ball, star) ==
            Verdict::accepted) {
            (void)apply_collapse(bench.edit, collapse, ball, star);
            ++made;
        }
    }
    return made;
}

/// Signed volume of an element under edit.
template <int D>
[[nodiscard]] double volume_of(const EditMesh<D>& mesh, const Simplex<D>& s) {
    std::array<Vec<D>, D + 1> x;
    for (int i = 0; i <= D; ++i) {
        x[i] = mesh.point(s[i]);
    }
    return volume(x).value;
}

/// Area of a face times its unit normal.
[[nodiscard]] inline Vec<2> area_vector(const Mesh<2>& mesh, const Facet<2>& f) {
    const Vec<2> t = mesh.points[f[1]] - mesh.points[f[0]];
    return {t[1], -t[0]};
}
[[nodiscard]] inline Vec<3> area_vector(const Mesh<3>& mesh, const Facet<3>& f) {
    const Vec<3> a = mesh.points[f[1]] - mesh.points[f[0]];
    return a.cross(mesh.points[f[2]] - mesh.points[f[0]]) / 2;
}

/// What operators on a mesh with plane sides must leave as it is. Each number is a sum over a
/// patch or region.
struct Extent {
    std::map<int, double> patch_area;
    std::map<int, double> region_volume;
};

template <int D>
[[nodiscard]] Extent extent(const Mesh<D>& mesh) {
    Extent out;
    for (const FaceId f : mesh.faces.ids()) {
        out.patch_area[mesh.patch[f]] += area_vector(mesh, mesh.faces[f]).norm();
    }
    for (const ElementId e : mesh.elements.ids()) {
        out.region_volume[mesh.region[e]] += volume(corners_of(mesh, mesh.elements[e])).value;
    }
    return out;
}

/// Largest relative difference of two sets of sums; infinite where a patch or region is missing.
[[nodiscard]] inline double difference(const std::map<int, double>& a,
                                       const std::map<int, double>& b) {
    double largest = a.size() == b.size() ? 0 : INFINITY;
    for (const auto& [id, value] : a) {
        const auto other = b.find(id);
        largest = std::max(largest,
                           other == b.end() ? INFINITY : std::abs(other->second - value) / value);
    }
    return largest;
}

[[nodiscard]] inline double difference(const Extent& a, const Extent& b) {
    return std::max(difference(a.patch_area, b.patch_area),
                    difference(a.region_volume, b.region_volume));
}

/// A point that can be put into a set.
template <int D>
[[nodiscard]] std::array<double, D> key_of(const Vec<D>& x) {
    std::array<double, D> key;
    std::copy(x.data(), x.data() + D, key.begin());
    return key;
}

/// The corners of an entity, in an order that does not depend on numbering.
template <int D, std::size_t N>
[[nodiscard]] std::vector<std::array<double, D>> place_of(const Mesh<D>& mesh,
                                                          const std::array<NodeId, N>& nodes) {
    std::vector<std::array<double, D>> place;
    for (const NodeId v : nodes) {
        place.push_back(key_of<D>(mesh.points[v]));
    }
    std::sort(place.begin(), place.end());
    return place;
}

/// Moves inner nodes at random, by up to `amount`, as long as their elements stay positive.
template <int D>
void worsen(Mesh<D>& mesh, double amount, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-amount, amount);
    const NodeElements ball = node_elements(mesh);
    const GeometryClasses<D> classes = classify_geometry(mesh);
    for (const NodeId v : mesh.points.ids()) {
        const Vec<D> before = mesh.points[v];
        for (int i = 0; i < D; ++i) {
            mesh.points[v][i] += uniform(random);
        }
        const auto at = std::as_const(ball)[v];
        const bool valid = classes.node[v] == NodeClass::interior &&
                           std::all_of(at.begin(), at.end(), [&](ElementId e) {
                               return orientation(mesh, mesh.elements[e]) > 0;
                           });
        if (!valid) {
            mesh.points[v] = before;
        }
    }
}

/// Puts the elements whose centre has x < `border` into region 2, and lists the faces between the
/// regions as patch 20.
template <int D>
void split_regions(Mesh<D>& mesh, double border) {
    std::map<Facet<D>, std::set<int>> sides;
    std::map<Facet<D>, Facet<D>> facets;
    for (const ElementId e : mesh.elements.ids()) {
        double centre = 0;
        for (const NodeId v : mesh.elements[e]) {
            centre += mesh.points[v][0] / (D + 1);
        }
        mesh.region[e] = centre < border ? 2 : 1;
        for (int i = 0; i <= D; ++i) {
            const Facet<D> f = facet_of<D>(mesh.elements[e], i);
            sides[sorted(f)].insert(mesh.region[e]);
            facets[sorted(f)] = f;
        }
    }
    for (const auto& [f, regions] : sides) {
        if (regions.size() == 2) {
            mesh.faces.push_back(facets[f]);
            mesh.patch.push_back(20);
        }
    }
}

} // namespace ameco::remesh_test
