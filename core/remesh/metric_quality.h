// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The paper's quality of an element in a metric (sections 4.2 and 4.4), for elements being edited.
#pragma once

#include "core/metric/metric.h"
#include "core/remesh/edit_mesh.h"

#include <array>

namespace ameco {

/// S = M^(-1/2) at every node, components as in Tensor [L]: what the metric of an element is the
/// mean of.
template <int D>
using RootField = IdVector<NodeId, Tensor<D>>;

/// S = V diag(h) V^T of one metric, upper triangle by rows [L].
template <int D>
[[nodiscard]] Tensor<D> root_of(const Metric<D>& metric);

template <int D>
[[nodiscard]] RootField<D> make_root_field(const MetricField<D>& target);

/// Qualities of an element that has the corners x in a metric M = S^-2, all in [0, 1].
///
/// Both have the shape (17), Q_F = C Vol_M / h_M^D with h_M the root mean square of the lengths.
/// Original: times the size factor (19), min(h_M, 1/h_M)^D. Modified (section 4.4): times the worst
/// min(l, 1/l)^D of the edges and min(v, 1/v) of the volume v, in units of the regular simplex's.
struct MetricQualities {
    double original = 0;
    double modified = 0;
};

/// \param natural  metrics of the element's nodes; S is the mean of their M^(-1/2)
template <int D>
[[nodiscard]] MetricQualities metric_qualities(const std::array<Vec<D>, D + 1>& x,
                                               const std::array<Metric<D>, D + 1>& natural);

/// Q = Q_F Q_S with the shape (17) and the size factor (19) in the metric M(T) = (mean of S)^-2 of
/// the element's nodes; lengths come from |e|_M = |S^-1 e| without an eigenproblem.
/// \return in [0, 1], 1 for a regular simplex of edge 1 in the metric
template <int D>
[[nodiscard]] double metric_quality(const EditMesh<D>& mesh, const RootField<D>& root,
                                    const Simplex<D>& element);

/// The shape Q_F (17) alone, in the same metric.
template <int D>
[[nodiscard]] double metric_shape(const EditMesh<D>& mesh, const RootField<D>& root,
                                  const Simplex<D>& element);

} // namespace ameco
