// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/cube.h"

#include "core/cases/grid_wall.h"
#include "core/cases/random.h"
#include "core/cases/shuffle.h"

#include <algorithm>

namespace ameco {
namespace {

/// A displaced node of the grid. The displacement lies in a ball of a fifth of the cell size at
/// most; the least width of a prism's tets, over all ways to cut it, is 1 / sqrt(6) = 0.408 cell
/// sizes, so nodes that move against each other cannot flatten one.
template <int D>
Vec<D> displaced(const std::array<int, D>& at, const CubeOptions& o, std::uint64_t node) {
    Vec<D> shift;
    for (int d = 0; d < D; ++d) {
        shift[d] = random_signed(
            {static_cast<std::uint64_t>(o.seed), 20, node, static_cast<std::uint64_t>(d)});
    }
    shift *= o.displace / std::max(1.0, shift.norm());
    Vec<D> x;
    for (int d = 0; d < D; ++d) {
        const bool on_side = at[d] == 0 || at[d] == o.n;
        x[d] = (at[d] + (on_side ? 0.0 : shift[d])) / o.n;
    }
    return x;
}

} // namespace

template <int D>
Mesh<D> make_cube(const CubeOptions& o) {
    const auto seed = static_cast<std::uint64_t>(o.seed);
    const GridWall<D> grid = grid_wall<D>(o.n, o.n, o.diagonals, seed);
    std::vector<Vec<D>> points;
    for (int k = 0; k <= o.n; ++k) {
        for (std::size_t c = 0; c < grid.wall.columns; ++c) {
            std::array<int, D> at;
            at[0] = grid.i(c);
            at[1] = D == 3 ? grid.j(c) : k;
            at[D - 1] = k;
            points.push_back(displaced<D>(at, o, points.size()));
        }
    }
    Mesh<D> mesh = extrude(grid.wall, std::move(points), grid_rank(grid, o.diagonals, seed),
                           patch_bottom, patch_top);
    mesh.patch_names = grid_patch_names<D>("bottom");
    if (o.shuffle != 0) {
        shuffle(mesh, static_cast<std::uint64_t>(o.shuffle));
    }
    return mesh;
}

template Mesh<2> make_cube<2>(const CubeOptions&);
template Mesh<3> make_cube<3>(const CubeOptions&);

} // namespace ameco
