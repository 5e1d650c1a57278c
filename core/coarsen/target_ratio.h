// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One level with a given ratio of nodes.
#pragma once

#include "core/coarsen/coarsen.h"

namespace ameco {

/// Largest coarse size over fine size that is tried to reach a ratio.
inline constexpr double largest_factor = 16;

/// The factor C with which the target metric asks for `ratio` times fewer nodes (expected_nodes.h),
/// by bisection to 1e-4; `largest_factor` if none is large enough.
///
/// \param options  everything but the factor
/// \param ratio    > 1
template <int D>
[[nodiscard]] double factor_for_ratio(const Mesh<D>& mesh, const MetricField<D>& natural,
                                      TargetOptions options, double ratio);

/// Makes the next coarser level with `ratio` times fewer nodes.
///
/// The remesher does not quite reach what the metric asks for, and lines across layers lose every
/// other node whatever the metric asks. So the ratio asked for is corrected by what was reached,
/// and the level made anew, until it is within 2 % or five were made; the closest is returned. A
/// ratio that is missed by more than 5 % is told to the monitor: on the ONERA M6, the rules that
/// keep multigrid converging allow about 1.9 to 2.3.
///
/// \param report  of the level that is returned; `report.factor` is the factor it was made with
/// \throws Cancelled when asked to stop
template <int D>
[[nodiscard]] Level<D> coarsen_by_ratio(const Level<D>& fine, CoarsenOptions options, double ratio,
                                        CoarsenReport& report,
                                        Monitor& monitor = Monitor::silent());

} // namespace ameco
