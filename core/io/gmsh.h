// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The MSH format of Gmsh (.msh), versions 2.2 and 4.1, text and binary.
///
/// Tags of nodes and elements are sparse and in any order: nodes and cells are put in the order of
/// their tags. A cell's label is its first physical tag; where the file has no physical tags, its
/// elementary tag. Patches are cells of one dimension less than the mesh; their names are those of
/// $PhysicalNames. Curves of a mesh with volume are kept.
#pragma once

#include "core/io/format.h"

namespace ameco::gmsh {

enum class Form { text, binary };

[[nodiscard]] bool recognises(std::string_view bytes);
[[nodiscard]] MeshFile read(const Source& source);

/// Version 2.2 and 4.1. Tags are the numbers from 1: faces first, as a text of Gmsh has them.
template <int D>
std::vector<std::string> write_2(const std::filesystem::path& path, Form form, const Mesh<D>& mesh);
template <int D>
std::vector<std::string> write_4(const std::filesystem::path& path, Form form, const Mesh<D>& mesh);

} // namespace ameco::gmsh
