// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The text format of SU2 (.su2). Nodes are numbered from 0.
///
///     NDIME= 3
///     NELEM= n          rows: VTK's code, nodes, [number]
///     NPOIN= n [m]      rows: coordinates, [number]
///     NMARK= n          then for each marker
///     MARKER_TAG= wing
///     MARKER_ELEMS= n   rows as those of elements
///
/// Sections come in any order; `%` begins a comment. The file knows patches by name only: comments
/// `% ameco patch 3 upper wing` keep their numbers and their exact names.
#pragma once

#include "core/io/format.h"

namespace ameco::su2 {

[[nodiscard]] bool recognises(std::string_view bytes);
[[nodiscard]] MeshFile read(const Source& source);
template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions& options);

} // namespace ameco::su2
