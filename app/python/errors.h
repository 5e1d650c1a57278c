// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// core/base/error.h as Python's exceptions.
#pragma once

#include <pybind11/pybind11.h>

namespace ameco::python {

/// Adds `Error` and its subclasses to the module; what core throws is raised as one of them. Each
/// has the program's exit code as `exit_code`. FileError is an OSError, too, InputError and
/// UsageError are ValueErrors, NotConverged and CheckFailed RuntimeErrors.
void bind_errors(pybind11::module_& module);

} // namespace ameco::python
