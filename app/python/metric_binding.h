// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Metric fields as Python sees them.
#pragma once

#include "core/metric/metric.h"

#include <pybind11/pybind11.h>

#include <memory>
#include <variant>

namespace ameco::python {

/// A metric field of either dimension, shared with the arrays that look at it, and never changed.
struct AnyMetric {
    std::variant<std::shared_ptr<const MetricField<3>>, std::shared_ptr<const MetricField<2>>>
        field;
};

/// Adds the class `MetricField`, and the functions that make, read and judge one.
void bind_metric(pybind11::module_& module);

} // namespace ameco::python
