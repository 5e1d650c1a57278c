// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A metric on the way to another.
#pragma once

#include "core/metric/metric.h"

namespace ameco {

/// The metric nearest to `target` in which no vector is more than `most` times longer, or shorter,
/// than in `from`: the singular values of F_target F_from^-1 are brought into [1 / most, most].
///
/// A mesh that is unit in `from` is changed little to be unit in this one: no edge of it is longer
/// than `most`.
/// \param most    > 1
/// \param excess  by which factor the worst direction goes beyond `most`; 1 where none does, and
///                the result is `target`
template <int D>
[[nodiscard]] Metric<D> limited_metric(const Metric<D>& from, const Metric<D>& target, double most,
                                       double& excess);

} // namespace ameco
