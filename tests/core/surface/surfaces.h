// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Small surfaces for the tests of surface/ and recovery/.
#pragma once

#include "core/cases/icosphere.h"
#include "core/surface/boundary_surface.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <numbers>

namespace ameco::surfaces {

/// The boundary of the unit cube, n x n cells on each side; one patch per side.
[[nodiscard]] inline Mesh<3> cube(int n) {
    return boundary_surface(shapes::cube(n));
}

/// An icosphere of 20 frequency^2 faces; patch 1.
[[nodiscard]] inline Mesh<3> sphere(int frequency, double radius = 1,
                                    const Vec<3>& centre = Vec<3>::Zero()) {
    const SphereSurface sphere = icosphere(frequency, 0, 0, 1);
    Mesh<3> mesh;
    for (const Vec<3>& x : sphere.points) {
        mesh.points.push_back(centre + radius * x);
    }
    for (const auto& t : sphere.triangles) {
        mesh.faces.push_back({NodeId(t[0]), NodeId(t[1]), NodeId(t[2])});
        mesh.patch.push_back(1);
    }
    return mesh;
}

/// A torus of n x m quadrilaterals, each cut in two; patch 1.
[[nodiscard]] inline Mesh<3> torus(int n, int m, double radius = 1, double tube = 0.3) {
    Mesh<3> mesh;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / m;
            const double r = radius + tube * std::cos(v);
            mesh.points.push_back({r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
        }
    }
    const auto node = [&](int i, int j) { return NodeId((i % n) * m + j % m); };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            mesh.faces.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
            mesh.faces.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
        }
    }
    mesh.patch.assign(mesh.faces.size(), 1);
    return mesh;
}

/// Both surfaces side by side, each with its own nodes.
[[nodiscard]] inline Mesh<3> both(Mesh<3> a, const Mesh<3>& b) {
    const std::size_t n = a.points.size();
    for (const Vec<3>& x : b.points) {
        a.points.push_back(x);
    }
    for (const FaceId f : b.faces.ids()) {
        Facet<3> face = b.faces[f];
        for (NodeId& v : face) {
            v = NodeId(v.index() + n);
        }
        a.faces.push_back(face);
        a.patch.push_back(b.patch[f]);
    }
    return a;
}

/// The surface with every face having three nodes of its own, as in an STL file.
[[nodiscard]] inline Mesh<3> unmerged(const Mesh<3>& mesh) {
    Mesh<3> soup;
    for (const FaceId f : mesh.faces.ids()) {
        const auto first = static_cast<std::int32_t>(soup.points.size());
        for (const NodeId v : mesh.faces[f]) {
            soup.points.push_back(mesh.points[v]);
        }
        soup.faces.push_back({NodeId(first), NodeId(first + 1), NodeId(first + 2)});
        soup.patch.push_back(mesh.patch[f]);
    }
    return soup;
}

inline void turn(Mesh<3>& mesh, FaceId f) {
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
}

inline void remove_face(Mesh<3>& mesh, FaceId f) {
    mesh.faces.raw().erase(mesh.faces.raw().begin() + f.value());
    mesh.patch.raw().erase(mesh.patch.raw().begin() + f.value());
}

inline void add_face(Mesh<3>& mesh, const Facet<3>& face) {
    mesh.faces.push_back(face);
    mesh.patch.push_back(1);
}

} // namespace ameco::surfaces
