// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The keywords of the Gamma Mesh Format (Medit): codes in binary files, words in text files.
#pragma once

#include <string>
#include <string_view>

namespace ameco::gmf {

/// Codes of the records we read and write; a file may hold others.
enum Keyword : int {
    dimension = 3,
    vertices = 4,
    edges = 5,
    triangles = 6,
    quadrilaterals = 7,
    tetrahedra = 8,
    prisms = 9,
    hexahedra = 10,
    required_tetrahedra = 12, ///< as Mmg writes it; libMeshb leaves the code unused
    corners = 13,
    ridges = 14, ///< numbers of edges
    required_vertices = 15,
    required_edges = 16,
    required_triangles = 17,
    pyramids = 49,
    end = 54,
    sol_at_vertices = 62,
    reference_strings = 199
};

/// What one row of a record holds; the reals stand before the integers.
struct RowLayout {
    int reals = 0;
    int integers = 0;
};

/// The word of a keyword, e.g. "Tetrahedra"; "record 77" for a code without a word here.
[[nodiscard]] std::string word(int keyword);

/// The code of a word, or 0.
[[nodiscard]] int code(std::string_view word);

/// Whether the record is a table of rows that begins with their number and has the layout
/// `row_layout`. All others are opaque to us.
[[nodiscard]] bool is_table(int keyword);

/// \param dimension  of the space, 2 or 3: decides the layout of Vertices
[[nodiscard]] RowLayout row_layout(int keyword, int dimension);

/// One of the rows, for messages, e.g. "tetrahedron".
[[nodiscard]] std::string_view entity(int keyword);

/// Several of the rows, e.g. "tetrahedra".
[[nodiscard]] std::string plural(int keyword);

/// Type codes of the fields of a solution.
enum SolutionType : int { scalar = 1, vector = 2, symmetric_tensor = 3, full_tensor = 4 };

/// For messages, e.g. "scalar".
[[nodiscard]] std::string_view type_name(int type);

/// Numbers per row of a field; 0 for an unknown type.
[[nodiscard]] int values_of_type(int type, int dimension);

} // namespace ameco::gmf
