// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf_keyword.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace ameco::gmf {
namespace {

struct Entry {
    int code;
    int integers; ///< of one row; 0 for records that are not tables to us
    std::string_view word;
    std::string_view entity;
};

constexpr std::array<Entry, 36> entries{{
    {dimension, 0, "Dimension", ""},
    {vertices, 1, "Vertices", "vertex"},
    {edges, 3, "Edges", "edge"},
    {triangles, 4, "Triangles", "triangle"},
    {quadrilaterals, 5, "Quadrilaterals", "quadrilateral"},
    {tetrahedra, 5, "Tetrahedra", "tetrahedron"},
    {prisms, 7, "Prisms", "prism"},
    {hexahedra, 9, "Hexahedra", "hexahedron"},
    {required_tetrahedra, 1, "RequiredTetrahedra", "required tetrahedron"},
    {corners, 1, "Corners", "corner"},
    {ridges, 1, "Ridges", "ridge"},
    {required_vertices, 1, "RequiredVertices", "required vertex"},
    {required_edges, 1, "RequiredEdges", "required edge"},
    {required_triangles, 1, "RequiredTriangles", "required triangle"},
    {18, 0, "RequiredQuadrilaterals", ""},
    {20, 0, "NormalAtVertices", ""},
    {24, 0, "TrianglesP2", ""},
    {25, 0, "EdgesP2", ""},
    {30, 0, "TetrahedraP2", ""},
    {40, 0, "VerticesOnGeometricVertices", ""},
    {41, 0, "VerticesOnGeometricEdges", ""},
    {42, 0, "VerticesOnGeometricTriangles", ""},
    {43, 0, "VerticesOnGeometricQuadrilaterals", ""},
    {44, 0, "EdgesOnGeometricEdges", ""},
    {pyramids, 6, "Pyramids", "pyramid"},
    {end, 0, "End", ""},
    {59, 0, "Tangents", ""},
    {60, 0, "Normals", ""},
    {61, 0, "TangentAtVertices", ""},
    {sol_at_vertices, 0, "SolAtVertices", ""},
    {64, 0, "SolAtTriangles", ""},
    {66, 0, "SolAtTetrahedra", ""},
    {78, 0, "Time", ""},
    {96, 0, "TetrahedraP3", ""},
    {126, 0, "ByteFlow", ""},
    {reference_strings, 0, "ReferenceStrings", ""},
}};

const Entry* find(int keyword) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& e) { return e.code == keyword; });
    return found == entries.end() ? nullptr : &*found;
}

} // namespace

std::string word(int keyword) {
    const Entry* entry = find(keyword);
    return entry ? std::string(entry->word) : "record " + std::to_string(keyword);
}

int code(std::string_view word) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& e) { return e.word == word; });
    return found == entries.end() ? 0 : found->code;
}

bool is_table(int keyword) {
    const Entry* entry = find(keyword);
    return entry && entry->integers > 0;
}

RowLayout row_layout(int keyword, int dimension) {
    const Entry* entry = find(keyword);
    return {keyword == vertices ? dimension : 0, entry ? entry->integers : 0};
}

std::string_view entity(int keyword) {
    const Entry* entry = find(keyword);
    return entry ? entry->entity : std::string_view{};
}

std::string plural(int keyword) {
    std::string text = word(keyword);
    std::transform(text.begin(), text.end(), text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

std::string_view type_name(int type) {
    constexpr std::array<std::string_view, 5> names{"unknown", "scalar", "vector",
                                                    "symmetric tensor", "full tensor"};
    return names[type >= scalar && type <= full_tensor ? static_cast<std::size_t>(type) : 0];
}

int values_of_type(int type, int dimension) {
    switch (type) {
    case scalar:
        return 1;
    case vector:
        return dimension;
    case symmetric_tensor:
        return dimension * (dimension + 1) / 2;
    case full_tensor:
        return dimension * dimension;
    default:
        return 0;
    }
}

} // namespace ameco::gmf
