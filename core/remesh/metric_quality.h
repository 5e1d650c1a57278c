// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The paper's quality of an element in a metric (sections 4.2 and 4.4), for elements being edited.
#pragma once

#include "core/metric/element_measures.h"
#include "core/remesh/edit_mesh.h"

#include <array>
#include <optional>
#include <string_view>

namespace ameco {

/// Which quality of an element in a metric; all in [0, 1], and 1 for the regular one of unit size.
enum class Quality {
    shape,    ///< Q_F (17): any size will do
    original, ///< Q_F Q_S, (16) with the size factor (19)
    modified  ///< Q_F Q_S Q_V of section 4.4: every edge and the volume must have their size
};

inline constexpr std::array all_qualities{Quality::shape, Quality::original, Quality::modified};

[[nodiscard]] std::string_view name(Quality quality);
[[nodiscard]] std::optional<Quality> quality_from_name(std::string_view name);

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

/// The quality in the metric M(T) = (mean of S)^-2 of the element's nodes; lengths come from
/// |e|_M = |S^-1 e| without an eigenproblem.
template <int D>
[[nodiscard]] double metric_quality(const EditMesh<D>& mesh, const RootField<D>& root,
                                    const Simplex<D>& element, Quality quality = Quality::original);

/// The same for the original quality where it is above `least`, else something that is not; most
/// elements that are not are told by their volume alone.
template <int D>
[[nodiscard]] double metric_quality_above(const EditMesh<D>& mesh, const RootField<D>& root,
                                          const Simplex<D>& element, double least);

} // namespace ameco
