// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/box.h"

#include "core/cases/grid_wall.h"
#include "core/cases/shuffle.h"

namespace ameco {

template <int D>
Mesh<D> make_box(const BoxOptions& o) {
    const auto seed = static_cast<std::uint64_t>(o.seed);
    const GridWall<D> grid = grid_wall<D>(o.nx, o.ny, o.diagonals, seed);
    std::vector<Vec<D>> points;
    for (const std::size_t k : kept_layers(static_cast<std::size_t>(o.nz), o.every)) {
        const double z = static_cast<double>(k) * (o.ratio * o.dx);
        for (std::size_t c = 0; c < grid.wall.columns; ++c) {
            if constexpr (D == 2) {
                points.push_back({grid.i(c) * o.dx, z});
            } else {
                points.push_back({grid.i(c) * o.dx, grid.j(c) * o.dx, z});
            }
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

template Mesh<2> make_box<2>(const BoxOptions&);
template Mesh<3> make_box<3>(const BoxOptions&);

} // namespace ameco
