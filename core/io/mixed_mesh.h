// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A mesh of several kinds of cells, as most formats hold it, and how it becomes one of simplices.
#pragma once

#include "core/io/cell_type.h"
#include "core/io/io.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace ameco {

/// Cells of one kind.
template <std::size_t N>
struct Cells {
    std::vector<std::array<NodeId, N>> nodes;
    std::vector<int> labels; ///< [nodes.size()] region, patch or curve

    [[nodiscard]] std::size_t size() const { return nodes.size(); }
    void add(const std::array<NodeId, N>& cell, int label) {
        nodes.push_back(cell);
        labels.push_back(label);
    }
    void resize(std::size_t n) {
        nodes.resize(n);
        labels.resize(n);
    }
};

/// What a file of space dimension D holds.
template <int D>
struct MixedMesh {
    IdVector<NodeId, Vec<D>> points;
    IdVector<NodeId, int> labels; ///< of the nodes; may be empty

    Cells<2> lines;
    Cells<3> triangles;
    Cells<4> quadrilaterals;
    Cells<4> tetrahedra;
    Cells<5> pyramids;
    Cells<6> prisms;
    Cells<8> hexahedra;

    std::map<int, std::string> line_names; ///< by label
    std::map<int, std::string> face_names; ///< of triangles and quadrilaterals
    std::map<int, std::string> cell_names; ///< of cells with volume
    Features features; ///< its `edges` are the lines; faces are triangles, elements the tetrahedra
                       ///< (the triangles, in 2-D)
};

/// Calls `f(CellType, cells)` for each kind of cells.
template <int D, class F>
void for_each_kind(MixedMesh<D>& mixed, F&& f) {
    f(CellType::line, mixed.lines);
    f(CellType::triangle, mixed.triangles);
    f(CellType::quadrilateral, mixed.quadrilaterals);
    f(CellType::tetrahedron, mixed.tetrahedra);
    f(CellType::pyramid, mixed.pyramids);
    f(CellType::prism, mixed.prisms);
    f(CellType::hexahedron, mixed.hexahedra);
}

/// Adds a cell whose kind is known at run time only.
/// \param nodes  as many as the kind has
template <int D>
void add_cell(MixedMesh<D>& mixed, CellType type, std::span<const NodeId> nodes, int label);

/// Room for so many cells more of one kind.
template <int D>
void reserve_cells(MixedMesh<D>& mixed, CellType type, std::size_t count);

/// What the readers know of a file beyond its content.
struct FileContext {
    std::string name;      ///< for messages
    int first_number = 1;  ///< the number of the first node in the file, for messages
    bool surfaces = false; ///< whether a surface without volume is welcome
};

/// Makes the mesh of a file from its cells, and adds to its notes what was done for that.
///
/// A mesh with cells of three dimensions becomes a Mesh<3>, one that lies in a plane z = const a
/// Mesh<2>, and other surfaces a Mesh<3> without elements. Cells that are no simplices are split:
/// each is cut from its node of smallest number into the faces not at that node, and each
/// quadrilateral through its node of smallest number. Two cells thus cut the face between them in
/// the same way, whatever their kinds (Dompierre et al. 1999), and no point is added. Parts of
/// degenerate cells (a node twice) are left out. A quadrilateral in 2-D takes the other diagonal
/// where that one would leave it. Where all cells of a kind have negative orientation they are
/// turned: programs disagree on the numbering of prisms.
/// \throws InputError  a node that is not there, a coordinate that is not finite, nothing to work
///                     on, or a surface that is not welcome
template <int D>
void finish_mesh(MixedMesh<D>&& mixed, const FileContext& context, MeshFile& file);

/// Splits one cell; parts with a repeated node are left out.
/// \param nodes  as many as the kind has; positive orientation gives positive tetrahedra
void split_cell(CellType type, std::span<const NodeId> nodes, std::vector<Simplex<3>>& parts);

/// Splits a quadrilateral, likewise.
void split_quadrilateral(const std::array<NodeId, 4>& quadrilateral, std::vector<Facet<3>>& parts);

} // namespace ameco
