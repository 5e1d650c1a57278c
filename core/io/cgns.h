// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// CGNS (.cgns) through libcgns, in its two containers, ADF and HDF5.
///
/// Read is one unstructured zone, with sections of fixed or mixed kinds. A boundary condition gives
/// its faces a patch, named by its family or by itself; its points are numbers of faces, in a range
/// or a list, or nodes. Faces without a condition get the name of their section.
///
/// Written are one section of elements, and one of faces for each patch, with a condition and a
/// family each. Names in CGNS have 32 characters and patches no numbers: a descriptor "ameco patch"
/// beside each condition holds the number and the whole name.
#pragma once

#include "core/io/format.h"

namespace ameco::cgns {

enum class Container { hdf5, adf };

[[nodiscard]] bool recognises(std::string_view bytes);
[[nodiscard]] MeshFile read(const Source& source);
template <int D>
std::vector<std::string> write(const std::filesystem::path& path, Container container,
                               const Mesh<D>& mesh);

} // namespace ameco::cgns
