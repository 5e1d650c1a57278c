// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Metric fields as Python sees them.
#pragma once

#include "app/python/mesh_binding.h"
#include "core/base/error.h"
#include "core/metric/metric.h"

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <variant>

namespace ameco::python {

/// A metric field of either dimension, shared with the arrays that look at it, and never changed.
struct AnyMetric {
    std::variant<std::shared_ptr<const MetricField<3>>, std::shared_ptr<const MetricField<2>>>
        field;
};

/// Calls `use(mesh, field)` with both in their own dimension.
/// \throws UsageError when they do not belong together
template <class Use>
auto with_both(const AnyMesh& mesh, const AnyMetric& metric, const Use& use) {
    if (mesh.mesh.index() != metric.field.index()) {
        throw UsageError("metric: has another dimension than the mesh");
    }
    return std::visit(
        [&]<int D>(const std::shared_ptr<const Mesh<D>>& m) {
            const auto& field = *std::get<std::shared_ptr<const MetricField<D>>>(metric.field);
            if (field.size() != m->points.size()) {
                throw UsageError("metric: has " + std::to_string(field.size()) +
                                 " tensors for a mesh of " + std::to_string(m->points.size()) +
                                 " nodes");
            }
            return use(*m, field);
        },
        mesh.mesh);
}

/// Adds the class `MetricField`, and the functions that make, read and judge one.
void bind_metric(pybind11::module_& module);

} // namespace ameco::python
