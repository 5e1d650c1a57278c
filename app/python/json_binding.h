// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What is measured, as Python's dictionaries: with the names of hierarchy.json and of `--json`.
#pragma once

#include "core/hierarchy/statistics_json.h"

#include <pybind11/pybind11.h>

namespace ameco::python {

[[nodiscard]] inline pybind11::object python_value(const Json& json) {
    return pybind11::module_::import("json").attr("loads")(json.dump());
}

} // namespace ameco::python
