// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The kinds of cells that files hold, their numbering, and their codes in the formats.
///
///     pyramid: apex 4            prism                      hexahedron
///                                3-------5                  7-------6
///          4                     |\     /|                 /|      /|
///        // \\                   |   4   |                4-------5 |
///       3-----2                  |   |   |                | 3-----|-2
///      /     /                   0---|---2                |/      |/
///     0-----1                     \  |  /                 0-------1
///                                    1
///
/// This is the numbering of CGNS, Gmsh and SU2; others are translated by their readers. Seen from
/// the opposite side, the nodes 0 1 2 (3) run counter-clockwise: the volume is positive.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace ameco {

enum class CellType { line, triangle, quadrilateral, tetrahedron, pyramid, prism, hexahedron };

inline constexpr std::size_t cell_type_count = 7;

struct CellTypeInfo {
    CellType type;
    int dimension;
    int nodes;
    int vtk;  ///< code in VTK and SU2
    int gmsh; ///< code in Gmsh
    int cgns; ///< code in CGNS
    std::string_view name;
    std::string_view plural;
};

inline constexpr std::array<CellTypeInfo, cell_type_count> cell_types{{
    {CellType::line, 1, 2, 3, 1, 3, "line", "lines"},
    {CellType::triangle, 2, 3, 5, 2, 5, "triangle", "triangles"},
    {CellType::quadrilateral, 2, 4, 9, 3, 7, "quadrilateral", "quadrilaterals"},
    {CellType::tetrahedron, 3, 4, 10, 4, 10, "tetrahedron", "tetrahedra"},
    {CellType::pyramid, 3, 5, 14, 7, 12, "pyramid", "pyramids"},
    {CellType::prism, 3, 6, 13, 6, 14, "prism", "prisms"},
    {CellType::hexahedron, 3, 8, 12, 5, 17, "hexahedron", "hexahedra"},
}};

[[nodiscard]] constexpr const CellTypeInfo& info(CellType type) {
    return cell_types[static_cast<std::size_t>(type)];
}

/// The entry with the code in a format, `&CellTypeInfo::vtk` say; null if there is none.
[[nodiscard]] constexpr const CellTypeInfo* find_cell_type(int CellTypeInfo::*format,
                                                           std::int64_t code) {
    for (const CellTypeInfo& entry : cell_types) {
        if (entry.*format == code) {
            return &entry;
        }
    }
    return nullptr;
}

/// One face of a cell, nodes counter-clockwise when seen from outside; three or four of them.
struct CellFace {
    int nodes;
    std::array<int, 4> node;
};

/// The faces of a cell of three dimensions.
[[nodiscard]] std::span<const CellFace> faces_of(CellType type);

} // namespace ameco
