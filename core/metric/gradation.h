// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Bound how fast a coarsened metric changes from node to node.
#pragma once

#include "core/mesh/adjacency.h"
#include "core/metric/metric.h"

#include <cstdint>

namespace ameco {

/// Makes `target` no larger than its own gradation allows, and nowhere smaller than `natural`.
///
/// Along an edge from p to q, l its length in the natural metric (edge_length.h), every size of
/// q in the target obeys
///
///     h'_qk <= w'_p(v_qk) max(beta^l, h_qk / w_p(v_qk)),    w_p(v)^2 = v^T M_p^-1 v
///
/// where h and w belong to the natural metric, h' and w' to the target, and w_p(v) is the extent of
/// p's unit ball along v. So what grows alike on both sides is never held back, however steep the
/// mesh itself is graded; where one side doubles and the other stays (figures 4 and 5), sizes go
/// over from one to the other by beta per edge. The extent, and not the radius of the ball as in
/// the gradation of Alauzet (Finite Elem. Anal. Des. 46, 2010), because the radius of a slab is cut
/// to nothing by a small turn, and curved layers would lose their length.
///
/// A front of changed nodes is followed until nothing changes: O(n) as beta is left behind after
/// log(C) / log(beta) edges.
///
/// \param neighbours  of every node
/// \param target      [n] sizes at least those of `natural`, the same directions; changed, and the
///                    directions put into another order where a larger size was held back more
/// \param beta        > 1
/// \return            how many nodes were changed
template <int D>
std::int64_t limit_gradation(const Mesh<D>& mesh, const NodeNodes& neighbours,
                             const MetricField<D>& natural, MetricField<D>& target, double beta);

} // namespace ameco
