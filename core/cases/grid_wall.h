// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The wall under a plate, box or cube: nx by ny squares cut into triangles, or nx edges in 2-D.
#pragma once

#include "core/cases/extrusion.h"

namespace ameco {

/// Patches that boxes and plates share.
enum GridPatch : int {
    patch_bottom = 1,
    patch_top = 2,
    patch_x_min = 3,
    patch_x_max = 4,
    patch_y_min = 5, ///< 3-D only, as is y-max: in 2-D the columns lead to y
    patch_y_max = 6
};

/// A grid of columns, numbered row by row: column i + j * (nx + 1).
template <int D>
struct GridWall {
    Wall<D> wall;
    int nx = 0, ny = 0; ///< cells; ny = 0 in 2-D

    [[nodiscard]] int i(std::size_t column) const { return static_cast<int>(column) % (nx + 1); }
    [[nodiscard]] int j(std::size_t column) const { return static_cast<int>(column) / (nx + 1); }
};

/// \param diagonals  of the squares in the wall; `columns` and `random` are the same here
template <int D>
[[nodiscard]] GridWall<D> grid_wall(int nx, int ny, Diagonals diagonals, std::uint64_t seed);

/// The ranks that go with the grid.
template <int D>
[[nodiscard]] ColumnRank grid_rank(const GridWall<D>& grid, Diagonals diagonals,
                                   std::uint64_t seed);

/// Names of the patches: `wall` for the bottom, top, x-min and so on for the rest.
template <int D>
[[nodiscard]] std::map<int, std::string> grid_patch_names(const std::string& wall);

} // namespace ameco
