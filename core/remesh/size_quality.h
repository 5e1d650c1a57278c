// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How far the three sizes of an element are from the sizes asked for, whatever their directions.
///
/// In curved layers the direction of the short size turns, from one node to the next, by more than
/// the thickness of a layer over its width: lengths in a nodal metric and the paper's Q (16) then
/// call every element bad. Operators are therefore accepted on the sizes alone.
#pragma once

#include "core/base/id.h"
#include "core/mesh/mesh.h"
#include "core/metric/metric.h"

namespace ameco {

template <int D>
class EditMesh;

/// Target sizes at a node, as the ratios of their elementary symmetric polynomials that
/// `size_quality` compares: r_1 = sqrt(e_1), r_k = sqrt(e_k / e_{k-1}), e_k of h_1^2 ... h_D^2 [L].
template <int D>
struct SizeRatios {
    std::array<float, D> r;
};

template <int D>
using SizeField = IdVector<NodeId, SizeRatios<D>>;

template <int D>
[[nodiscard]] SizeField<D> make_size_field(const MetricField<D>& target);

/// Product over k of min(r_k / R_k, R_k / r_k), where r_k are the ratios above of the element's
/// own sizes (from edge lengths, face areas and volume, without an eigenproblem) and R_k the mean
/// of its nodes' target ratios. In [0, 1]; 1 for the sizes asked for.
template <int D>
[[nodiscard]] double size_quality(const EditMesh<D>& mesh, const SizeField<D>& sizes,
                                  const Simplex<D>& element);

} // namespace ameco
