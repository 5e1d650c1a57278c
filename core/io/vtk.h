// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// VTK's files, through VTK's own readers and writer: .vtu (read and written), .vtk and .pvd
/// (read).
///
/// Written is one unstructured grid, binary data inline (base64), 64-bit headers, not compressed:
/// elements, then faces, then curves. Cell arrays `region`, `patch` and `curve` hold the labels (0
/// for cells of other kinds), the point array `label` those of nodes, and the field array
/// `patch_names` rows of number and name. On reading, labels in files of other programs are found
/// under the names that meshio, Gmsh and ParaView give them. Of a .pvd the first file is read.
#pragma once

#include "core/io/format.h"

namespace ameco::vtk {

[[nodiscard]] bool recognises_vtu(std::string_view bytes);
[[nodiscard]] bool recognises_legacy(std::string_view bytes);
[[nodiscard]] bool recognises_pvd(std::string_view bytes);

[[nodiscard]] MeshFile read_vtu(const Source& source);
[[nodiscard]] MeshFile read_legacy(const Source& source);
[[nodiscard]] MeshFile read_pvd(const Source& source);

template <int D>
std::vector<std::string> write_vtu(const std::filesystem::path& path, const Mesh<D>& mesh,
                                   const WriteOptions& options);

} // namespace ameco::vtk
