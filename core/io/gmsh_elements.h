// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The codes of elements in Gmsh's files, beyond those of cell_type.h.
#pragma once

#include "core/io/cell_type.h"

#include <optional>

namespace ameco::gmsh {

/// A kind of elements as the file counts their nodes.
struct ElementKind {
    std::optional<CellType> type; ///< nothing for points, which are left out
    int nodes = 1;
    bool curved = false; ///< of second order: the first nodes are the corners
};

/// The kind with a code; nothing if it is not known.
[[nodiscard]] inline std::optional<ElementKind> element_kind(std::int64_t code) {
    struct Curved {
        int code;
        ElementKind kind;
    };
    static constexpr std::array<Curved, 11> curved{{{8, {CellType::line, 3, true}},
                                                    {9, {CellType::triangle, 6, true}},
                                                    {10, {CellType::quadrilateral, 9, true}},
                                                    {11, {CellType::tetrahedron, 10, true}},
                                                    {12, {CellType::hexahedron, 27, true}},
                                                    {13, {CellType::prism, 18, true}},
                                                    {14, {CellType::pyramid, 14, true}},
                                                    {16, {CellType::quadrilateral, 8, true}},
                                                    {17, {CellType::hexahedron, 20, true}},
                                                    {18, {CellType::prism, 15, true}},
                                                    {19, {CellType::pyramid, 13, true}}}};
    constexpr int point = 15;
    if (code == point) {
        return ElementKind{};
    }
    if (const CellTypeInfo* type = find_cell_type(&CellTypeInfo::gmsh, code)) {
        return ElementKind{type->type, type->nodes, false};
    }
    for (const Curved& entry : curved) {
        if (entry.code == code) {
            return entry.kind;
        }
    }
    return std::nullopt;
}

} // namespace ameco::gmsh
