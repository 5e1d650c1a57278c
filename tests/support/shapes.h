// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Small meshes for tests, built in code so that a failure can be drawn by hand.
///
/// Boundary faces are found here by brute force and not with the library's own facet matching, so
/// that a mistake there cannot hide.
#pragma once

#include "core/mesh/mesh.h"
#include "core/mesh/simplex.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace ameco::shapes {

/// Nodes from plain numbers: nodes(0, 3, 1) is std::array<NodeId, 3>.
template <class... Ints>
[[nodiscard]] std::array<NodeId, sizeof...(Ints)> nodes(Ints... ids) {
    return {NodeId(static_cast<std::int32_t>(ids))...};
}

/// Lists each facet that belongs to one element only, normal outwards, all on patch 1.
template <int D>
void add_boundary(Mesh<D>& mesh) {
    std::map<Facet<D>, std::vector<Facet<D>>> uses;
    for (const Simplex<D>& s : mesh.elements) {
        for (int i = 0; i <= D; ++i) {
            uses[sorted(facet_of<D>(s, i))].push_back(facet_of<D>(s, i));
        }
    }
    for (const auto& [key, facets] : uses) {
        if (facets.size() == 1) {
            mesh.faces.push_back(facets[0]);
            mesh.patch.push_back(1);
        }
    }
}

/// A mesh from literal points and elements, with its boundary on patch 1 and all elements in region
/// 1. Elements are taken as given, whatever their orientation.
template <int D>
[[nodiscard]] Mesh<D> from_literals(std::initializer_list<std::array<double, D>> points,
                                    std::initializer_list<Simplex<D>> elements) {
    Mesh<D> mesh;
    for (const auto& p : points) {
        mesh.points.push_back(Eigen::Map<const Vec<D>>(p.data()));
    }
    for (const Simplex<D>& s : elements) {
        mesh.elements.push_back(s);
        mesh.region.push_back(1);
    }
    add_boundary(mesh);
    return mesh;
}

/// The unit corner triangle: area 1/2.
[[nodiscard]] inline Mesh<2> single_triangle() {
    return from_literals<2>({{0, 0}, {1, 0}, {0, 1}}, {nodes(0, 1, 2)});
}

/// The unit corner tetrahedron: volume 1/6.
[[nodiscard]] inline Mesh<3> single_tet() {
    return from_literals<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {nodes(0, 1, 2, 3)});
}

/// Two unit tets on either side of the triangle 0 1 2: volume 1/3.
[[nodiscard]] inline Mesh<3> two_tets() {
    return from_literals<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
                            {nodes(0, 1, 2, 3), nodes(0, 2, 1, 4)});
}

/// Gives the boundary faces of an axis-aligned box the patches 1 ... 2 D, in the order low x,
/// high x, low y, high y, ...
template <int D>
void number_box_sides(Mesh<D>& mesh) {
    Vec<D> low = mesh.points[NodeId(0)];
    Vec<D> high = low;
    for (const Vec<D>& x : mesh.points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    const auto lies_on = [&](FaceId f, int axis, double value) {
        const Facet<D>& facet = mesh.faces[f];
        return std::all_of(facet.begin(), facet.end(),
                           [&](NodeId v) { return mesh.points[v][axis] == value; });
    };
    for (const FaceId f : mesh.faces.ids()) {
        for (int axis = 0; axis < D; ++axis) {
            if (lies_on(f, axis, low[axis])) {
                mesh.patch[f] = 2 * axis + 1;
            } else if (lies_on(f, axis, high[axis])) {
                mesh.patch[f] = 2 * axis + 2;
            }
        }
    }
}

/// The rectangle [0, x.back()] x [0, y.back()] on the grid lines x, y, which begin at 0 and ascend;
/// each cell is cut along its rising diagonal. Node (i, j) is number i + j * x.size().
[[nodiscard]] inline Mesh<2> rectangle(const std::vector<double>& x, const std::vector<double>& y) {
    Mesh<2> mesh;
    for (const double yj : y) {
        for (const double xi : x) {
            mesh.points.push_back({xi, yj});
        }
    }
    const auto at = [&](std::size_t i, std::size_t j) { return NodeId(i + j * x.size()); };
    for (std::size_t j = 0; j + 1 < y.size(); ++j) {
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            mesh.elements.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.elements.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    mesh.region.resize(mesh.elements.size(), 1);
    add_boundary(mesh);
    number_box_sides(mesh);
    return mesh;
}

/// The box on the grid planes x, y, z, each cell cut into the six Kuhn tetrahedra around its
/// rising diagonal. Node (i, j, k) is number i + (j + k * y.size()) * x.size().
[[nodiscard]] inline Mesh<3> box(const std::vector<double>& x, const std::vector<double>& y,
                                 const std::vector<double>& z) {
    Mesh<3> mesh;
    for (const double zk : z) {
        for (const double yj : y) {
            for (const double xi : x) {
                mesh.points.push_back({xi, yj, zk});
            }
        }
    }
    using Cell = std::array<std::size_t, 3>;
    const auto at = [&](const Cell& c) {
        return NodeId(c[0] + (c[1] + c[2] * y.size()) * x.size());
    };
    const auto add_cell = [&](const Cell& low) {
        // A tet for each order in which the axes may be walked from the low to the high corner.
        std::array<int, 3> axes{0, 1, 2};
        do {
            Cell corner = low;
            Simplex<3> s;
            s[0] = at(corner);
            for (std::size_t i = 0; i < 3; ++i) {
                ++corner[static_cast<std::size_t>(axes[i])];
                s[i + 1] = at(corner);
            }
            const bool odd = (axes[0] + 1) % 3 != axes[1];
            if (odd) {
                std::swap(s[2], s[3]);
            }
            mesh.elements.push_back(s);
        } while (std::next_permutation(axes.begin(), axes.end()));
    };
    for (std::size_t k = 0; k + 1 < z.size(); ++k) {
        for (std::size_t j = 0; j + 1 < y.size(); ++j) {
            for (std::size_t i = 0; i + 1 < x.size(); ++i) {
                add_cell({i, j, k});
            }
        }
    }
    mesh.region.resize(mesh.elements.size(), 1);
    add_boundary(mesh);
    number_box_sides(mesh);
    return mesh;
}

/// 0, 1/n, ..., 1.
[[nodiscard]] inline std::vector<double> uniform(int n) {
    std::vector<double> x;
    for (int i = 0; i <= n; ++i) {
        x.push_back(static_cast<double>(i) / n);
    }
    return x;
}

/// 0, h, h (1 + g), h (1 + g + g^2), ...: n intervals that grow from `h` by the factor `g`.
[[nodiscard]] inline std::vector<double> geometric(int n, double h, double g) {
    std::vector<double> x{0};
    for (int i = 0; i < n; ++i) {
        x.push_back(x.back() + h);
        h *= g;
    }
    return x;
}

/// The unit square, n x n cells.
[[nodiscard]] inline Mesh<2> square(int n) {
    return rectangle(uniform(n), uniform(n));
}

/// The unit cube, n x n x n cells of six tets.
[[nodiscard]] inline Mesh<3> cube(int n) {
    return box(uniform(n), uniform(n), uniform(n));
}

/// A boundary layer over the unit square, n x n cells wide: `layers` layers of tets that begin with
/// height `h` at the wall z = 0 (patch 5) and grow by `g`.
[[nodiscard]] inline Mesh<3> stretched_slab(int n, int layers, double h, double g = 1.2) {
    return box(uniform(n), uniform(n), geometric(layers, h, g));
}

/// The same in two dimensions, over the unit interval; the wall is y = 0 (patch 3).
[[nodiscard]] inline Mesh<2> stretched_strip(int n, int layers, double h, double g = 1.2) {
    return rectangle(uniform(n), geometric(layers, h, g));
}

/// The mesh with its nodes and elements in random order (the same one for the same seed).
template <int D>
[[nodiscard]] Mesh<D> shuffled(const Mesh<D>& mesh, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::size_t> order(mesh.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    Mesh<D> result = mesh;
    for (std::size_t i = 0; i < order.size(); ++i) {
        result.points[NodeId(order[i])] = mesh.points[NodeId(i)];
    }
    const auto renumber = [&](auto& tuples) {
        for (auto& tuple : tuples) {
            for (NodeId& v : tuple) {
                v = NodeId(order[v.index()]);
            }
        }
    };
    renumber(result.elements);
    renumber(result.faces);
    std::shuffle(result.elements.begin(), result.elements.end(), random);
    return result;
}

} // namespace ameco::shapes
