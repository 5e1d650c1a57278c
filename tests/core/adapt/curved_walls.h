// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Small domains with curved walls, for the tests of nodes that are put or move on them, and how
/// far a boundary is from theirs.
#pragma once

#include "core/cases/shell.h"
#include "core/remesh/original_surface.h"
#include "tests/support/layered_cases.h"

#include <algorithm>
#include <set>

namespace ameco::adapt_test {

[[nodiscard]] inline Mesh<3> between_spheres() {
    ShellOptions shell;
    shell.frequency = 4;
    shell.aspect_ratio = 1;
    shell.growth = 1.5;
    shell.far_field = 2;
    shell.displace = 0.2;
    return make_shell(shell);
}

/// Whose ends are planes across the y axis, with circles around them.
[[nodiscard]] inline Mesh<3> between_cylinders() {
    return layered_cases::cylinder(16, 4, {0, 0.4, 0.8});
}

/// The circles are ridges inside the patch.
[[nodiscard]] inline Mesh<3> between_cylinders_of_one_patch() {
    Mesh<3> mesh = between_cylinders();
    layered_cases::join_patches(mesh);
    return mesh;
}

[[nodiscard]] inline std::set<NodeId> ridge_nodes(const Mesh<3>& mesh) {
    std::set<NodeId> nodes;
    for (const RidgeEdge& r : classify_geometry(mesh).ridges) {
        nodes.insert(r.nodes.begin(), r.nodes.end());
    }
    return nodes;
}

/// How far the nodes of a boundary are from the one that was given, patch by patch, those of its
/// ridges from the ridges.
struct Off {
    double farthest = 0; ///< [L]
    int count = 0;       ///< nodes off it beyond rounding
    int nodes = 0;       ///< all of the boundary
    int ridge_nodes = 0;
};

[[nodiscard]] inline Off off_surface(const Mesh<3>& mesh, const Mesh<3>& given) {
    const GeometryClasses<3> classes = classify_geometry(given);
    const BoundaryProjection<3>& projection = classes.original->projection();
    const auto patches = node_patches(mesh);
    const std::set<NodeId> on_ridges = ridge_nodes(mesh);
    Off off;
    for (const NodeId v : mesh.points.ids()) {
        if (patches[v].empty()) {
            continue;
        }
        const bool on_ridge = on_ridges.contains(v);
        const Vec<3>& p = mesh.points[v];
        const double distance = on_ridge ? projection.project_on_line(p, patches[v]).distance
                                         : projection.project(p, patches[v]).distance;
        off.farthest = std::max(off.farthest, distance);
        off.count += distance > 1e-12 ? 1 : 0;
        ++off.nodes;
        off.ridge_nodes += on_ridge ? 1 : 0;
    }
    return off;
}

} // namespace ameco::adapt_test
