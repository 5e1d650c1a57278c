// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Keyword arguments as options: the settings of the command line by their own names.
#pragma once

#include "core/hierarchy/hierarchy.h"

#include <pybind11/pybind11.h>

namespace ameco::python {

struct AnyMesh;

/// Options from keyword arguments, "-" written as "_": those of core/hierarchy/settings.h, where
/// None stands for what is off; `factor`, a number or one per level; `freeze`, patches of `mesh` by
/// id or name.
/// \throws UsageError
[[nodiscard]] HierarchyOptions options_from(const pybind11::dict& given, const AnyMesh& mesh);

/// Adds `settings`, the table of them.
void bind_options(pybind11::module_& module);

} // namespace ameco::python
