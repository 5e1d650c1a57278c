// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How far the boundary of a coarse level lies from that of the finest one, measured and not
/// bounded.
#pragma once

#include "core/coarsen/coarsen.h"
#include "core/mesh/boundary_projection.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>

namespace ameco::boundary_fit {

/// Areas of patches, by patch; faces inside the domain are listed among them.
[[nodiscard]] inline std::map<int, double> patch_areas(const Mesh<3>& mesh) {
    std::map<int, double> area;
    for (const FaceId f : mesh.faces.ids()) {
        const Facet<3>& n = mesh.faces[f];
        const Vec<3> a = mesh.points[n[1]] - mesh.points[n[0]];
        area[mesh.patch[f]] += a.cross(mesh.points[n[2]] - mesh.points[n[0]]).norm() / 2;
    }
    return area;
}

/// Largest relative change of a patch's area; infinite where a patch has gone.
[[nodiscard]] inline double area_change(const Mesh<3>& mesh, const Mesh<3>& finest) {
    const auto now = patch_areas(mesh);
    double largest = 0;
    for (const auto& [patch, area] : patch_areas(finest)) {
        const auto it = now.find(patch);
        largest = std::max(largest, it == now.end() ? INFINITY : std::abs(it->second / area - 1));
    }
    return largest;
}

/// Distances of places on the finest boundary, its nodes, and of places on the coarse one, the
/// middles of its faces, from the other boundary; the largest ones.
struct Fit {
    double over_edge = 0;  ///< over the mean edge of the coarse face there [-]
    double over_short = 0; ///< over the smallest h_1 of the coarse level at its nodes [-]
};

/// By patch. Nodes between patches are left out.
[[nodiscard]] inline std::map<int, Fit> measure(const Level<3>& coarse, const Mesh<3>& finest) {
    std::map<int, Fit> fits;
    const auto add = [&](int patch, double distance, const Facet<3>& face) {
        double edges = 0, shortest = INFINITY;
        for (std::size_t i = 0; i < 3; ++i) {
            edges +=
                (coarse.mesh.points[face[i]] - coarse.mesh.points[face[(i + 1) % 3]]).norm() / 3;
            shortest = std::min(shortest, coarse.natural[face[i]].sizes[0]);
        }
        Fit& fit = fits[patch];
        fit.over_edge = std::max(fit.over_edge, distance / edges);
        fit.over_short = std::max(fit.over_short, distance / shortest);
    };
    const BoundaryProjection<3> to_coarse(coarse.mesh), to_finest(finest);
    const auto patches = node_patches(finest);
    for (const NodeId v : finest.points.ids()) {
        if (patches[v].size() == 1) {
            const auto hit = to_coarse.project(finest.points[v], patches[v]);
            add(patches[v][0], hit.distance, hit.nodes);
        }
    }
    for (const FaceId f : outer_faces(coarse.mesh)) {
        const Facet<3>& face = coarse.mesh.faces[f];
        const Vec<3> middle = (coarse.mesh.points[face[0]] + coarse.mesh.points[face[1]] +
                               coarse.mesh.points[face[2]]) /
                              3;
        const int patch = coarse.mesh.patch[f];
        add(patch, to_finest.project(middle, {patch}).distance, face);
    }
    return fits;
}

} // namespace ameco::boundary_fit
