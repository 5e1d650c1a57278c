// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How many nodes a mesh of the domain has when it is unit in a metric, its boundary counted.
#pragma once

#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

namespace ameco {

/// Number of nodes of a unit mesh of the domain in the metric [-].
///
/// The complexity alone counts cells: a layer of 32 cells between two walls has 33 nodes across,
/// and after a few levels that one node more decides the ratio. A node inside the domain has a
/// whole cell, one on a face half of one, one on an edge of dihedral angle t the share t / 2 pi;
/// counted so for a lattice, in 3-D
///
///     n = sqrt(2) int sqrt(det M) dV + (1/2) (2/sqrt(3)) int sqrt(det M_t) dS
///         + sum over boundary edges (1/2 - t / 2 pi) |e|_M
///
/// with M_t the metric in the plane of the face, and in 2-D (2/sqrt(3)) int sqrt(det M) dA
/// + (1/2) int |dx|_M. For a box of a x b x c cells this is (a+1)(b+1)(c+1) but for its 8 corners.
/// Use the quotient of two fields on one mesh: constants of the lattice then cancel.
///
/// \param mesh  valid, with its boundary faces
template <int D>
[[nodiscard]] double expected_nodes(const Mesh<D>& mesh, const MetricField<D>& field);

} // namespace ameco
