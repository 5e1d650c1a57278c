// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Transfers as the arrays of a sparse matrix.
#pragma once

#include <pybind11/pybind11.h>

namespace ameco::python {

/// Adds `transfer`.
void bind_transfer(pybind11::module_& module);

} // namespace ameco::python
