// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Layers that are not on the one wall of a plate: between two walls, about a plane inside the
/// domain, about a sheet, around a cylinder. With random columns, as the cases of core/cases.
#pragma once

#include "core/cases/grid_wall.h"
#include "core/cases/random.h"
#include "core/cases/spacing.h"
#include "core/mesh/simplex.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ameco::layered_cases {

/// n layers on either side of the plane 0, thinnest there.
[[nodiscard]] inline std::vector<double> about_plane(double first, double growth, double largest,
                                                     std::size_t n) {
    const std::vector<double> up = growing_layers(first, growth, largest, n);
    std::vector<double> z;
    for (std::size_t k = n; k > 0; --k) {
        z.push_back(-up[k]);
    }
    z.insert(z.end(), up.begin(), up.end());
    return z;
}

/// n layers on each of two walls that face each other, the lower one at 0; thinnest at the walls.
[[nodiscard]] inline std::vector<double> between_walls(double first, double growth, double largest,
                                                       std::size_t n) {
    std::vector<double> z = growing_layers(first, growth, largest, n);
    const double gap = 2 * z.back();
    for (std::size_t k = n; k-- > 0;) {
        z.push_back(gap - z[k]);
    }
    return z;
}

/// A box of n x n displaced columns over the unit square, with its nodes at the heights `z`: node
/// (column, layer) is number column + layer * (n + 1)^2.
[[nodiscard]] inline Mesh<3> box(int n, const std::vector<double>& z, int seed = 1) {
    const auto s = static_cast<std::uint64_t>(seed);
    const GridWall<3> grid = grid_wall<3>(n, n, Diagonals::columns, s);
    std::vector<Vec<3>> points;
    for (const double zk : z) {
        for (std::size_t c = 0; c < grid.wall.columns; ++c) {
            const auto place = [&](int i, std::uint64_t axis) {
                const bool at_side = i == 0 || i == n;
                return (i + (at_side ? 0.0 : 0.2 * random_signed({s, axis, c}))) / n;
            };
            points.emplace_back(place(grid.i(c), 10), place(grid.j(c), 11), zk);
        }
    }
    Mesh<3> mesh = extrude(grid.wall, std::move(points), grid_rank(grid, Diagonals::columns, s),
                           patch_bottom, patch_top);
    mesh.patch_names = grid_patch_names<3>("wall");
    return mesh;
}

/// Patch of the faces inside the domain that `add_sheet` lists.
inline constexpr int sheet_patch = 9;

/// Lists the faces in the plane z = 0 of the columns i >= n / 2: a two-sided sheet that leaves the
/// box at x-max, and ends inside it.
inline void add_sheet(Mesh<3>& mesh, int n) {
    const auto on_sheet = [&](NodeId v) {
        const int column = v.value() % ((n + 1) * (n + 1));
        return mesh.points[v][2] == 0 && column % (n + 1) >= n / 2;
    };
    for (const ElementId e : mesh.elements.ids()) {
        for (int i = 0; i < 4; ++i) {
            const Facet<3> f = facet_of<3>(mesh.elements[e], i);
            const bool above = mesh.points[mesh.elements[e][i]][2] > 0;
            if (above && std::all_of(f.begin(), f.end(), on_sheet)) {
                mesh.faces.push_back(f);
                mesh.patch.push_back(sheet_patch);
            }
        }
    }
    mesh.patch_names[sheet_patch] = "sheet";
}

/// The space around a cylinder of radius 1 along y, closed around it: displaced columns, `along` of
/// them over the length 2 pi along / around. Patches as those of a box, without x-min and x-max.
[[nodiscard]] inline Mesh<3> cylinder(int around, int along, const std::vector<double>& heights,
                                      int seed = 1) {
    const auto s = static_cast<std::uint64_t>(seed);
    Wall<3> wall;
    wall.columns = static_cast<std::size_t>(around * (along + 1));
    const auto at = [&](int i, int j) { return i % around + around * j; };
    for (int j = 0; j < along; ++j) {
        for (int i = 0; i < around; ++i) {
            const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            const bool rising = mix({s, 7, static_cast<std::uint64_t>(a)}) % 2 == 0;
            const std::size_t first = wall.facets.size();
            wall.facets.push_back(rising ? std::array{a, b, c} : std::array{a, b, d});
            wall.facets.push_back(rising ? std::array{a, c, d} : std::array{b, c, d});
            if (j == 0) { // the edge a, b
                wall.sides.push_back({first, 2, patch_y_min});
            }
            if (j + 1 == along) { // the edge c, d
                wall.sides.push_back({first + 1, 0, patch_y_max});
            }
        }
    }
    const double step = 2 * std::numbers::pi / around;
    std::vector<Vec<3>> points;
    for (const double h : heights) {
        for (int c = 0; c < static_cast<int>(wall.columns); ++c) {
            const auto key = static_cast<std::uint64_t>(c);
            const int j = c / around;
            const bool at_end = j == 0 || j == along;
            const double angle = step * (c % around + 0.2 * random_signed({s, 10, key}));
            const double y = step * (j + (at_end ? 0.0 : 0.2 * random_signed({s, 11, key})));
            // The foot is the same for the whole column, so nothing of the height is lost.
            const Vec<3> out(std::cos(angle), 0, -std::sin(angle));
            points.push_back(Vec<3>(out[0], y, out[2]) + h * out);
        }
    }
    Mesh<3> mesh = extrude(wall, std::move(points), column_rank(Diagonals::columns, s),
                           patch_bottom, patch_top);
    mesh.patch_names = {
        {patch_bottom, "wall"}, {patch_top, "top"}, {patch_y_min, "y-min"}, {patch_y_max, "y-max"}};
    return mesh;
}

/// Makes one patch of the whole boundary: lines between patches become ridges inside it.
inline void join_patches(Mesh<3>& mesh) {
    std::fill(mesh.patch.begin(), mesh.patch.end(), patch_bottom);
    mesh.patch_names = {{patch_bottom, "wall"}};
}

} // namespace ameco::layered_cases
