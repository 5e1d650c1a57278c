// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The files of TetGen and Triangle: NAME.node, NAME.ele and NAME.face (in 2-D: NAME.edge), text.
///
///     .node  nodes dimension attributes markers; rows: number, coordinates, attributes, marker
///     .ele   elements nodes-per-element attributes; rows: number, nodes, region
///     .face  faces marker; rows: number, nodes, patch (.edge in 2-D likewise)
///
/// Nodes are numbered from 0 or 1, as the first row of .node says. `#` begins a comment; comments
/// `# ameco patch 3 wing` in .face carry names. Any one of the files names them all.
#pragma once

#include "core/io/format.h"

namespace ameco::tetgen_files {

[[nodiscard]] MeshFile read(const Source& source);
template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions& options);

} // namespace ameco::tetgen_files
