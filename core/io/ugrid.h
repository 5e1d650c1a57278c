// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The UGRID format of AFLR3, FUN3D and refine, in text and binary, with names from a .mapbc file.
///
///     counts of nodes, triangles, quads, tets, pyramids, prisms, hexahedra
///     coordinates; triangles; quads; patches of triangles, then of quads;
///     tets; pyramids; prisms; hexahedra
///
/// Nodes are numbered from 1. Before the suffix stands the form:
///
///     .ugrid            text
///     .b8  .b4          big-endian, 64-bit or 32-bit coordinates, 32-bit integers
///     .lb8 .lb4         the same, little-endian
///     .r8 .r4 .lr8 .lr4 the same as two records of Fortran
///     .b8l .lb8l        64-bit integers; .b8.ugrid64 and .lb8.ugrid64 are the same
///
/// The node of a pyramid that is not at its quadrilateral is the third: base a b c d and apex e are
/// stored as a d e b c.
#pragma once

#include "core/io/format.h"

namespace ameco::ugrid {

[[nodiscard]] MeshFile read(const Source& source);
/// Writes `<stem>.mapbc` too if patches have names.
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<3>& mesh,
                               const WriteOptions& options);

} // namespace ameco::ugrid
