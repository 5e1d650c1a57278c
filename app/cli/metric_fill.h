// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A surface filled, and the mesh brought to a metric that is known on the surface.
#pragma once

#include "core/hierarchy/statistics_json.h"
#include "core/recovery/fill.h"

#include <optional>

namespace ameco::cli {

struct MetricFill {
    Fill fill;
    std::optional<Conformity> conformity; ///< of the mesh to the metric, where one was given
};

/// Fills the surface, then adapts the mesh to the metric, whose sizes grow by `growth` times the
/// distance from the surface. Where the given faces are to be kept, they are kept by both.
/// \param field   one metric per node of the surface; empty: the surface is filled, no more
/// \param growth  size per distance [-], >= 0
/// \throws as `fill_surface`
[[nodiscard]] MetricFill fill_to_metric(const Mesh<3>& surface, const MetricField<3>& field,
                                        double growth, FillOptions options, const std::string& name,
                                        Monitor& monitor);

/// What `ameco fill --json` says of it.
[[nodiscard]] Json fill_json(const MetricFill& made);

} // namespace ameco::cli
