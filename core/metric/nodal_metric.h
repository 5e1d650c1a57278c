// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// From the metrics of the elements to one metric per node.
#pragma once

#include "core/base/monitor.h"
#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

#include <string_view>

namespace ameco {

/// How the metrics of the elements around a node become one.
enum class Mean {
    corrected,     ///< (9)-(10): directions of (8), sizes the mean of the sorted sizes; the default
    interpolation, ///< (8): mean of M^-1/2
    log_euclidean  ///< proposition 4: exponential of the mean of the logarithms
};

[[nodiscard]] std::string_view name(Mean mean);

/// The natural metric of a mesh at its nodes.
///
/// \param mesh  every node belongs to an element
/// \return      one metric per node [n]; the same for any number of threads
/// \see docs/theory/metric.md, "From elements to nodes"; paper, section 2.3
template <int D>
[[nodiscard]] MetricField<D> nodal_metric(const Mesh<D>& mesh, Mean mean = Mean::corrected,
                                          Monitor& monitor = Monitor::silent());

} // namespace ameco
