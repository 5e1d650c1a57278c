// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/cell_type.h"

namespace ameco {
namespace {

constexpr std::array<CellFace, 4> tetrahedron{
    {{3, {0, 2, 1, 0}}, {3, {0, 1, 3, 0}}, {3, {1, 2, 3, 0}}, {3, {2, 0, 3, 0}}}};
constexpr std::array<CellFace, 5> pyramid{{{4, {0, 3, 2, 1}},
                                           {3, {0, 1, 4, 0}},
                                           {3, {1, 2, 4, 0}},
                                           {3, {2, 3, 4, 0}},
                                           {3, {3, 0, 4, 0}}}};
constexpr std::array<CellFace, 5> prism{{{3, {0, 2, 1, 0}},
                                         {3, {3, 4, 5, 0}},
                                         {4, {0, 1, 4, 3}},
                                         {4, {1, 2, 5, 4}},
                                         {4, {2, 0, 3, 5}}}};
constexpr std::array<CellFace, 6> hexahedron{{{4, {0, 3, 2, 1}},
                                              {4, {4, 5, 6, 7}},
                                              {4, {0, 1, 5, 4}},
                                              {4, {1, 2, 6, 5}},
                                              {4, {2, 3, 7, 6}},
                                              {4, {3, 0, 4, 7}}}};

} // namespace

std::span<const CellFace> faces_of(CellType type) {
    switch (type) {
    case CellType::tetrahedron:
        return tetrahedron;
    case CellType::pyramid:
        return pyramid;
    case CellType::prism:
        return prism;
    case CellType::hexahedron:
        return hexahedron;
    default:
        return {};
    }
}

} // namespace ameco
