// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The binary format of the paper's own program (.dimeco), appendix A.2.
///
///     counts of nodes, elements, faces
///     coordinates; nodes of the elements; nodes of the faces (from 1); logical numbers of the
///     faces
///
/// The paper gives neither widths nor byte order. Written are 32-bit integers and 64-bit
/// coordinates, little-endian, one behind the other. Read are also big-endian files, 32-bit
/// coordinates, and each of the five blocks as a record of Fortran, where the size of the file
/// decides.
#pragma once

#include "core/io/format.h"

namespace ameco::dimeco {

[[nodiscard]] MeshFile read(const Source& source);
template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions& options);

} // namespace ameco::dimeco
