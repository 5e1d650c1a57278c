// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The paper's quality of an element in a metric (sections 4.2 and 4.4), for elements being edited.
#pragma once

#include "core/metric/metric.h"
#include "core/remesh/edit_mesh.h"

namespace ameco {

/// S = M^(-1/2) at every node, components as in Tensor [L]: what the metric of an element is the
/// mean of.
template <int D>
using RootField = IdVector<NodeId, Tensor<D>>;

template <int D>
[[nodiscard]] RootField<D> make_root_field(const MetricField<D>& target);

/// Q = Q_F Q_S with the shape (17) and the size factor (19) in the metric M(T) = (mean of S)^-2 of
/// the element's nodes; lengths come from |e|_M = |S^-1 e| without an eigenproblem.
/// \return in [0, 1], 1 for a regular simplex of edge 1 in the metric
template <int D>
[[nodiscard]] double metric_quality(const EditMesh<D>& mesh, const RootField<D>& root,
                                    const Simplex<D>& element);

} // namespace ameco
