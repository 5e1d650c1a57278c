// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Levels and hierarchies as Python sees them.
#pragma once

#include <pybind11/pybind11.h>

namespace ameco::python {

/// Adds the class `Level`, `coarsen` and `hierarchy`, which make some, and `write_hierarchy`.
void bind_levels(pybind11::module_& module);

} // namespace ameco::python
