// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// From the metrics of the elements to one metric per node.
#pragma once

#include "core/base/monitor.h"
#include "core/mesh/mesh.h"
#include "core/metric/means.h"

namespace ameco {

/// The natural metric of a mesh at its nodes.
///
/// \param mesh  every node belongs to an element
/// \return      one metric per node [n]; the same for any number of threads
/// \throws NotConverged  geodesic_fixed_step only; names the first such node
/// \see docs/theory/means.md; paper, section 2.3
template <int D>
[[nodiscard]] MetricField<D> nodal_metric(const Mesh<D>& mesh, Mean mean = Mean::corrected,
                                          Monitor& monitor = Monitor::silent());

} // namespace ameco
