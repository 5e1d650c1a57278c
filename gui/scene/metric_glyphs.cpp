// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/metric_glyphs.h"

#include "core/base/error.h"
#include "core/metric/element_metric.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

namespace ameco::gui {
namespace {

constexpr std::size_t most_ellipsoids = 2000;

/// Elements at each of some nodes, which ascend.
template <int D>
std::vector<std::vector<ElementId>> elements_at(const Mesh<D>& mesh,
                                                const std::vector<NodeId>& nodes) {
    std::vector<std::int32_t> place(mesh.points.size(), -1);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        place[nodes[k].index()] = static_cast<std::int32_t>(k);
    }
    std::vector<std::vector<ElementId>> elements(nodes.size());
    for (const ElementId e : mesh.elements.ids()) {
        for (const NodeId i : mesh.elements[e]) {
            if (place[i.index()] >= 0) {
                elements[static_cast<std::size_t>(place[i.index()])].push_back(e);
            }
        }
    }
    return elements;
}

template <int D>
Vec<D> drawn_sizes(Vec<D> sizes, const EllipsoidOptions& options) {
    if (options.source == EllipsoidSource::target) {
        sizes = coarsened_sizes<D>(sizes, options.target);
    }
    const double largest = sizes.maxCoeff();
    for (int k = 0; k < D; ++k) {
        sizes[k] = largest * std::pow(sizes[k] / largest, options.compress);
    }
    return options.scale * sizes;
}

template <int D>
std::vector<Ellipsoid> ellipsoids_of(const Mesh<D>& mesh, const std::vector<NodeId>& nodes,
                                     const EllipsoidOptions& options) {
    const auto balls = elements_at(mesh, nodes);
    std::vector<Ellipsoid> ellipsoids;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        std::vector<Metric<D>> metrics(balls[k].size());
        element_metrics<D>(mesh, std::span<const ElementId>(balls[k]), metrics);
        try {
            const Metric<D> metric = mean_of<D>(metrics, options.mean);
            Ellipsoid ellipsoid{nodes[k], Mat<3>::Zero()};
            ellipsoid.axes.template block<D, D>(0, 0) =
                metric.directions * drawn_sizes<D>(metric.sizes, options).asDiagonal();
            ellipsoids.push_back(ellipsoid);
        } catch (const NotConverged&) {
            continue; // only the published fixed-step iteration; the inspector names the failure
        }
    }
    return ellipsoids;
}

/// A triangulated unit sphere, icosahedron with every triangle cut in four `times` times.
struct Sphere {
    std::vector<Vec3> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
};

Sphere icosahedron() {
    const double g = std::numbers::phi;
    Sphere sphere;
    sphere.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (Vec3& p : sphere.points) {
        p.normalize();
    }
    sphere.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                        {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                        {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                        {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return sphere;
}

Sphere unit_sphere(int times) {
    Sphere sphere = icosahedron();
    for (int n = 0; n < times; ++n) {
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
        const auto middle = [&](std::int32_t a, std::int32_t b) {
            const auto [entry, is_new] = middles.try_emplace(
                std::minmax(a, b), static_cast<std::int32_t>(sphere.points.size()));
            if (is_new) {
                sphere.points.push_back((sphere.points[static_cast<std::size_t>(a)] +
                                         sphere.points[static_cast<std::size_t>(b)])
                                            .normalized());
            }
            return entry->second;
        };
        std::vector<std::array<std::int32_t, 3>> finer;
        for (const auto& [a, b, c] : sphere.triangles) {
            const std::int32_t ab = middle(a, b);
            const std::int32_t bc = middle(b, c);
            const std::int32_t ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        sphere.triangles = std::move(finer);
    }
    return sphere;
}

Sphere unit_disc() {
    constexpr std::int32_t pieces = 48;
    Sphere disc;
    disc.points.push_back(Vec3::Zero());
    for (std::int32_t k = 0; k < pieces; ++k) {
        const double angle = 2 * std::numbers::pi * k / pieces;
        disc.points.push_back({std::cos(angle), std::sin(angle), 0});
        disc.triangles.push_back({0, k + 1, (k + 1) % pieces + 1});
    }
    return disc;
}

/// G^-T up to its length: the map of normals, without an inverse that a flat ellipsoid lacks.
Mat<3> cofactors(const Mat<3>& G) {
    Mat<3> C;
    C.col(0) = G.col(1).cross(G.col(2));
    C.col(1) = G.col(2).cross(G.col(0));
    C.col(2) = G.col(0).cross(G.col(1));
    return C;
}

} // namespace

std::vector<NodeId> ellipsoid_nodes(const SceneData& data, const VisibleSurface& surface,
                                    const ClipPlane& clip, const EllipsoidOptions& options,
                                    std::optional<NodeId> picked) {
    using Where = EllipsoidOptions::Where;
    std::vector<NodeId> nodes;
    if (options.where == Where::picked && picked && picked->index() < data.node_count) {
        nodes.push_back(*picked);
    } else if (options.where == Where::sample) {
        nodes = surface.nodes;
    } else if (options.where == Where::clip_plane && clip.enabled) {
        for (const ElementId e : surface.cut_elements) {
            std::visit(
                [&](const auto& input) {
                    const auto& s = input.mesh->elements[e];
                    nodes.insert(nodes.end(), s.begin(), s.end());
                },
                data.input);
        }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const std::size_t most = std::min(options.max_count, most_ellipsoids);
    if (nodes.size() > most) {
        std::vector<NodeId> some;
        for (std::size_t k = 0; k < most; ++k) {
            some.push_back(nodes[k * nodes.size() / most]);
        }
        nodes = std::move(some);
    }
    return nodes;
}

std::vector<Ellipsoid> make_ellipsoids(const SceneData& data, const std::vector<NodeId>& nodes,
                                       const EllipsoidOptions& options) {
    return std::visit([&](const auto& input) { return ellipsoids_of(*input.mesh, nodes, options); },
                      data.input);
}

GlyphMesh glyph_mesh(const SceneData& data, const std::vector<Ellipsoid>& ellipsoids,
                     const ViewTransform& transform) {
    const bool few = ellipsoids.size() <= 20;
    const Sphere sphere = data.dimension == 2 ? unit_disc() : unit_sphere(few ? 4 : 2);
    GlyphMesh glyphs;
    glyphs.points.reserve(ellipsoids.size() * sphere.points.size());
    for (const Ellipsoid& ellipsoid : ellipsoids) {
        const Vec3 centre = transform.forward(data.position(ellipsoid.node));
        const Mat<3> G = transform.A * ellipsoid.axes;
        const Mat<3> C = cofactors(G);
        const auto first = static_cast<std::int32_t>(glyphs.points.size());
        const bool mirrored = data.dimension == 3 && G.determinant() < 0;
        for (const Vec3& p : sphere.points) {
            glyphs.points.push_back(centre + G * p);
            glyphs.normals.push_back(data.dimension == 2
                                         ? Vec3(0, 0, 1)
                                         : Vec3((mirrored ? -1 : 1) * (C * p).normalized()));
        }
        for (const auto& [a, b, c] : sphere.triangles) {
            glyphs.triangles.push_back({first + a, first + b, first + c, -1});
        }
    }
    return glyphs;
}

} // namespace ameco::gui
