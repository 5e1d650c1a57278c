// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Meshes with something to swap, and what swaps need to know of them.
#pragma once

#include "core/cases/cube.h"
#include "core/remesh/collapse.h"
#include "core/remesh/front_order.h"
#include "core/remesh/lines.h"
#include "tests/core/remesh/remesh_support.h"

namespace ameco::remesh_test {

inline constexpr SurfaceRules plane_sides{
    .largest_turn_deg = 30, .relative_distance = 1e-9, .layer_share = 1e9};

/// Lines without any node on them.
[[nodiscard]] inline Lines no_lines(std::size_t n) {
    Lines lines;
    lines.previous.resize(n);
    lines.next.resize(n);
    lines.position.assign(n, -1);
    lines.gap_used.assign(n, 0);
    return lines;
}

/// Those across the layers of a mesh.
template <int D>
[[nodiscard]] Lines lines_of(const Workbench<D>& bench) {
    const Couplings couplings = make_couplings(bench.mesh);
    const FrontOrder front = front_order(bench.mesh, bench.metric, couplings.neighbours);
    return find_lines(bench.mesh, couplings, front.key);
}

/// A cube of n^D cells with displaced nodes and random diagonals, made worse.
template <int D>
[[nodiscard]] Mesh<D> displaced_cube(int n, unsigned seed) {
    Mesh<D> mesh = make_cube<D>({.n = n,
                                 .displace = 0.2,
                                 .diagonals = Diagonals::random,
                                 .seed = static_cast<int>(seed),
                                 .shuffle = static_cast<int>(seed) + 1});
    worsen(mesh, 0.5 / n, seed);
    return mesh;
}

/// Removes nodes at random, as long as the mesh allows it, to leave elements of all shapes.
template <int D>
void thin_out(Workbench<D>& bench, int attempts, unsigned seed) {
    std::mt19937 random(seed);
    Cavity<D> ball;
    Star<D> star;
    for (int i = 0; i < attempts; ++i) {
        const NodeId v(random() % bench.edit.node_count());
        if (bench.edit.is_removed(v)) {
            continue;
        }
        const auto around = neighbours(bench.edit, v);
        const Collapse collapse{v, around[random() % around.size()]};
        gather_ball(bench.edit, v, ball);
        if (propose_collapse(bench.edit, bench.sizes, plane_sides, {0, 0}, 1, collapse, ball,
                             star) == Verdict::accepted) {
            const auto in = apply_collapse(bench.edit, collapse, ball, star);
            bench.notes.replaced(in, star.elements, bench.edit, 0);
        }
    }
}

/// Where listed faces are.
template <int D>
[[nodiscard]] std::set<std::vector<std::array<double, D>>> places(const Mesh<D>& mesh,
                                                                  const std::vector<int>& faces) {
    std::set<std::vector<std::array<double, D>>> out;
    for (const int f : faces) {
        out.insert(place_of<D>(mesh, mesh.faces[FaceId(f)]));
    }
    return out;
}

} // namespace ameco::remesh_test
