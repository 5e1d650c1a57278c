// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Adaptation to a metric for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace ameco::python {

/// Adds `remesh`.
void bind_remesh(pybind11::module_& module);

} // namespace ameco::python
