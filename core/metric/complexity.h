// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How many nodes and elements a metric field asks for.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

namespace ameco {

/// Complexity of a field on a mesh: integral of sqrt(det M) over the domain [-], by the lumped rule
/// (each node with the share 1/(D+1) of its elements' volumes).
template <int D>
[[nodiscard]] double complexity(const Mesh<D>& mesh, const MetricField<D>& field);

/// Number of elements of a unit mesh of that complexity: complexity / V_D with the volume of the
/// regular simplex of edge 1, V_2 = sqrt(3)/4, V_3 = sqrt(2)/12.
template <int D>
[[nodiscard]] double predicted_elements(double complexity);

} // namespace ameco
