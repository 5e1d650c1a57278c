// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/model_layer.h"

#include "core/base/error.h"
#include "core/cases/grid_wall.h"
#include "core/cases/shuffle.h"

#include <cmath>
#include <numbers>

namespace ameco {

Mesh<2> make_model_layer(const ModelLayerOptions& o) {
    const double half = o.angle_deg * std::numbers::pi / 360;
    const double h = 1 / o.stretching;
    if (-std::tan(half) * o.layers * h >= 1) {
        throw UsageError("model-layer: " + std::to_string(o.layers) +
                         " layers are too thick for a turn of " + std::to_string(o.angle_deg) +
                         " degrees: take a larger stretching or fewer layers");
    }
    const auto seed = static_cast<std::uint64_t>(o.seed);
    const GridWall<2> grid = grid_wall<2>(2 * o.cells, 0, o.diagonals, seed);
    std::vector<Vec<2>> points;
    for (const std::size_t k : kept_layers(static_cast<std::size_t>(o.layers), o.every)) {
        const double z = static_cast<double>(k) * h;
        for (int i = -o.cells; i <= o.cells; ++i) {
            const int side = (i > 0) - (i < 0);
            // A bisector's node is as far from both walls as its layer, hence farther from the
            // turn.
            const Vec<2> column = side == 0 ? Vec<2>(0, 1 / std::cos(half))
                                            : Vec<2>(side * std::sin(half), std::cos(half));
            const Vec<2> foot(i * std::cos(half), -std::abs(i) * std::sin(half));
            points.push_back(foot + z * column);
        }
    }
    Mesh<2> mesh = extrude(grid.wall, std::move(points), grid_rank(grid, o.diagonals, seed),
                           patch_bottom, patch_top);
    mesh.patch_names = grid_patch_names<2>("wall");
    if (o.shuffle != 0) {
        shuffle(mesh, static_cast<std::uint64_t>(o.shuffle));
    }
    return mesh;
}

} // namespace ameco
