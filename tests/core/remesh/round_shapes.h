// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Round domains, and how far a boundary is from theirs.
#pragma once

#include "core/cases/icosphere.h"
#include "core/geometry/distance.h"
#include "tests/core/remesh/remesh_support.h"

#include <cmath>
#include <numbers>

namespace ameco::remesh_test {

/// A regular polygon of radius 1 around node 0, with corners 1 ... n.
[[nodiscard]] inline Mesh<2> polygon(int n) {
    Mesh<2> mesh;
    mesh.points.push_back(Vec<2>::Zero());
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        mesh.points.push_back({std::cos(angle), std::sin(angle)});
        mesh.elements.push_back(shapes::nodes(0, i + 1, (i + 1) % n + 1));
    }
    mesh.region.assign(mesh.elements.size(), 1);
    shapes::add_boundary(mesh);
    return mesh;
}

/// A ball: a node in the middle, joined to the triangles of a sphere.
[[nodiscard]] inline Mesh<3> ball_of(int frequency) {
    const SphereSurface sphere = icosphere(frequency, 0.1, 0.1, 1);
    Mesh<3> mesh;
    for (const Vec<3>& x : sphere.points) {
        mesh.points.push_back(x);
    }
    const NodeId centre = mesh.points.next_id();
    mesh.points.push_back(Vec<3>::Zero());
    for (const auto& t : sphere.triangles) {
        mesh.elements.push_back({NodeId(t[0]), NodeId(t[2]), NodeId(t[1]), centre});
    }
    mesh.region.assign(mesh.elements.size(), 1);
    shapes::add_boundary(mesh);
    return mesh;
}

/// Distance between a face and the boundary of `finest`, sampled at nodes and edge midpoints.
template <int D>
[[nodiscard]] double sampled_distance(const Mesh<D>& mesh, FaceId id, const Mesh<D>& finest) {
    const Facet<D>& face = mesh.faces[id];
    double largest = 0;
    for (const NodeId a : face) {
        for (const NodeId b : face) {
            const Vec<D> p = (mesh.points[a] + mesh.points[b]) / 2;
            double nearest = INFINITY;
            for (const Facet<D>& f : finest.faces) {
                std::array<Vec<D>, D> corners;
                for (int i = 0; i < D; ++i) {
                    corners[i] = finest.points[f[i]];
                }
                nearest = std::min(nearest, distance(p, corners));
            }
            largest = std::max(largest, nearest);
        }
    }
    return largest;
}

} // namespace ameco::remesh_test
