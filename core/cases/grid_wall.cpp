// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/grid_wall.h"

#include "core/cases/random.h"

namespace ameco {
namespace {

GridWall<2> line_wall(int nx) {
    GridWall<2> grid{{}, nx, 0};
    grid.wall.columns = static_cast<std::size_t>(nx) + 1;
    for (int i = 0; i < nx; ++i) {
        grid.wall.facets.push_back({i, i + 1});
    }
    grid.wall.sides = {{0, 1, patch_x_min}, {grid.wall.facets.size() - 1, 0, patch_x_max}};
    return grid;
}

/// Whether the square (i, j) is cut from its lower left to its upper right corner.
bool rises(int i, int j, Diagonals diagonals, std::uint64_t seed) {
    switch (diagonals) {
    case Diagonals::uniform:
        return true;
    case Diagonals::alternating:
        return (i + j) % 2 == 0;
    case Diagonals::columns:
    case Diagonals::random:
        break;
    }
    return mix({seed, 3, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j)}) % 2 == 0;
}

GridWall<3> square_wall(int nx, int ny, Diagonals diagonals, std::uint64_t seed) {
    GridWall<3> grid{{}, nx, ny};
    Wall<3>& wall = grid.wall;
    wall.columns = (static_cast<std::size_t>(nx) + 1) * (static_cast<std::size_t>(ny) + 1);
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int a = i + j * (nx + 1), b = a + 1, d = a + nx + 1, c = d + 1;
            const std::size_t first = wall.facets.size();
            // Triangles hold: sides x-min and y-max in one of them, y-min and x-max in the other,
            // or x-min and y-min, x-max and y-max; the corner opposite each is written beside it.
            const bool rising = rises(i, j, diagonals, seed);
            if (rising) {
                wall.facets.push_back({a, b, c});
                wall.facets.push_back({a, c, d});
            } else {
                wall.facets.push_back({a, b, d});
                wall.facets.push_back({b, c, d});
            }
            if (j == 0) {
                wall.sides.push_back({first, 2, patch_y_min}); // a b, opposite c or d
            }
            if (j == ny - 1) {
                wall.sides.push_back({first + 1, 0, patch_y_max}); // c d, opposite a or b
            }
            if (i == 0) {
                wall.sides.push_back({rising ? first + 1 : first, 1, patch_x_min}); // d a
            }
            if (i == nx - 1) { // b c
                wall.sides.push_back({rising ? first : first + 1, rising ? 0 : 2, patch_x_max});
            }
        }
    }
    return grid;
}

} // namespace

template <int D>
GridWall<D> grid_wall(int nx, int ny, Diagonals diagonals, std::uint64_t seed) {
    if constexpr (D == 2) {
        return line_wall(nx);
    } else {
        return square_wall(nx, ny, diagonals, seed);
    }
}

template <int D>
ColumnRank grid_rank(const GridWall<D>& grid, Diagonals diagonals, std::uint64_t seed) {
    const int row = grid.nx + 1;
    return column_rank(diagonals, seed, [row](std::size_t column) {
        const int c = static_cast<int>(column);
        return c % row + c / row;
    });
}

template <int D>
std::map<int, std::string> grid_patch_names(const std::string& wall) {
    std::map<int, std::string> names{
        {patch_bottom, wall}, {patch_top, "top"}, {patch_x_min, "x-min"}, {patch_x_max, "x-max"}};
    if constexpr (D == 3) {
        names[patch_y_min] = "y-min";
        names[patch_y_max] = "y-max";
    }
    return names;
}

template GridWall<2> grid_wall<2>(int, int, Diagonals, std::uint64_t);
template GridWall<3> grid_wall<3>(int, int, Diagonals, std::uint64_t);
template ColumnRank grid_rank<2>(const GridWall<2>&, Diagonals, std::uint64_t);
template ColumnRank grid_rank<3>(const GridWall<3>&, Diagonals, std::uint64_t);
template std::map<int, std::string> grid_patch_names<2>(const std::string&);
template std::map<int, std::string> grid_patch_names<3>(const std::string&);

} // namespace ameco
