// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Surfaces, and meshes from them, for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace ameco::python {

/// Adds `read_surface` and `fill`.
void bind_surfaces(pybind11::module_& module);

} // namespace ameco::python
