// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Dassault's text format (.dassault), appendix A.3 of the paper.
///
///     nodes elements faces          (counts)
///     coordinates of each node
///     nodes of each element         (from 1)
///     nodes of each face, and its logical number, the patch
#pragma once

#include "core/io/format.h"

namespace ameco::dassault {

[[nodiscard]] MeshFile read(const Source& source);
template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions& options);

} // namespace ameco::dassault
