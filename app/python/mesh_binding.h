// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Meshes as Python sees them.
#pragma once

#include "app/python/python_monitor.h"
#include "core/mesh/mesh.h"

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace ameco::python {

/// A mesh of either dimension, shared with the arrays that look at it, and never changed: so it can
/// be computed with while other threads of Python run.
struct AnyMesh {
    std::variant<std::shared_ptr<const Mesh<3>>, std::shared_ptr<const Mesh<2>>> mesh;
    std::vector<std::string> repairs; ///< what was mended when it was read or made
    bool known_valid = false;         ///< has passed `check`; changed under Python's lock only

    [[nodiscard]] int dimension() const { return mesh.index() == 0 ? 3 : 2; }
};

/// \throws InputError when the mesh is not valid
void require_valid(AnyMesh& mesh, PythonMonitor& monitor);

/// Adds the class `Mesh`, and `read`, `case` and `make_mesh`, which make one.
void bind_mesh(pybind11::module_& module);

} // namespace ameco::python
