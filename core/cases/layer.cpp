// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/layer.h"

#include "core/base/error.h"
#include "core/cases/grid_wall.h"
#include "core/cases/random.h"
#include "core/cases/shuffle.h"
#include "core/cases/spacing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ameco {
namespace {

/// Displacement of a grid line's node along it: none at the ends, where it would leave the plate.
double displaced(int i, int n, double share, std::initializer_list<std::uint64_t> key) {
    return i == 0 || i == n ? 0.0 : share * random_signed(key);
}

/// Foot of a column on the unbent plate [L]; (x) in 2-D, (x, y) in 3-D.
template <int D>
Vec<D - 1> foot(const GridWall<D>& grid, std::size_t column, const LayerOptions& o) {
    const auto seed = static_cast<std::uint64_t>(o.seed);
    const int i = grid.i(column), j = grid.j(column);
    Vec<D - 1> x;
    x[0] = (i + displaced(i, o.nx, o.displace, {seed, 10, column})) / o.nx;
    if constexpr (D == 3) {
        x[1] = (j + displaced(j, o.ny, o.displace, {seed, 11, column})) / o.nx;
    }
    return x;
}

/// Distance of a node from the wall, with its own movement along the column.
double height(const std::vector<double>& layers, std::size_t k, std::size_t column,
              const LayerOptions& o) {
    if (k == 0 || k + 1 == layers.size()) {
        return layers[k];
    }
    const double local = std::min(layers[k] - layers[k - 1], layers[k + 1] - layers[k]);
    return layers[k] +
           o.jitter * local * random_signed({static_cast<std::uint64_t>(o.seed), 12, column, k});
}

/// Bends the plate. The height z enters as a product with the column's direction and is added to a
/// foot that is the same for the whole column, so nothing of it is lost to cancellation.
template <int D>
Vec<D> place(const Vec<D - 1>& x, double z, double radius) {
    Vec<D> p;
    if constexpr (D == 3) {
        p[1] = x[1];
    }
    if (radius == 0) {
        p[0] = x[0];
        p[D - 1] = z;
        return p;
    }
    const double angle = (x[0] - 0.5) / radius;
    const double half_sine = std::sin(angle / 2);
    p[0] = radius * std::sin(angle) + z * std::sin(angle);
    p[D - 1] = -2 * radius * half_sine * half_sine + z * std::cos(angle);
    return p;
}

} // namespace

template <int D>
Mesh<D> make_layer(const LayerOptions& o) {
    const double dx = 1.0 / o.nx;
    const std::vector<double> layers =
        growing_layers(dx / o.aspect_ratio, o.growth, dx, static_cast<std::size_t>(o.nz));
    if (o.curvature < 0 && layers.back() >= -o.curvature) {
        throw UsageError("layer: the layers reach " + std::to_string(layers.back()) +
                         " from a concave wall of radius " + std::to_string(-o.curvature) +
                         ": take a larger radius, or fewer or thinner layers");
    }
    if (o.curvature != 0 && std::abs(o.curvature) < 1 / std::numbers::pi) {
        throw UsageError("layer: a plate of length 1 cannot bend over a cylinder of radius " +
                         std::to_string(std::abs(o.curvature)) +
                         ": take 0.32 or more, or 0 (flat)");
    }
    const auto seed = static_cast<std::uint64_t>(o.seed);
    const GridWall<D> grid = grid_wall<D>(o.nx, o.ny, o.diagonals, seed);
    std::vector<Vec<D - 1>> feet;
    for (std::size_t c = 0; c < grid.wall.columns; ++c) {
        feet.push_back(foot(grid, c, o));
    }
    std::vector<Vec<D>> points;
    for (const std::size_t k : kept_layers(static_cast<std::size_t>(o.nz), o.every)) {
        for (std::size_t c = 0; c < grid.wall.columns; ++c) {
            points.push_back(place<D>(feet[c], height(layers, k, c, o), o.curvature));
        }
    }
    Mesh<D> mesh = extrude(grid.wall, std::move(points), grid_rank(grid, o.diagonals, seed),
                           patch_bottom, patch_top);
    mesh.patch_names = grid_patch_names<D>("wall");
    if (o.shuffle != 0) {
        shuffle(mesh, static_cast<std::uint64_t>(o.shuffle));
    }
    return mesh;
}

template Mesh<2> make_layer<2>(const LayerOptions&);
template Mesh<3> make_layer<3>(const LayerOptions&);

} // namespace ameco
