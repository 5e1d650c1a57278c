// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One spelling in JSON for each thing that is measured, shared by hierarchy.json and by the
/// program's `--json`. Keys keep their order.
#pragma once

#include "core/adapt/adapt.h"
#include "core/hierarchy/hierarchy.h"

#include <nlohmann/json.hpp>

namespace ameco {

using Json = nlohmann::ordered_json;

[[nodiscard]] Json to_json(const AspectRatioSummary& summary, const AspectRatioClasses& classes);
[[nodiscard]] Json to_json(const Conformity& conformity);
[[nodiscard]] Json to_json(const std::vector<Finding>& findings);
[[nodiscard]] Json to_json(const BoundaryRepair& repair);
[[nodiscard]] Json to_json(const VerdictCounts& counts); ///< those that occurred
[[nodiscard]] Json to_json(const LevelStatistics& statistics);
[[nodiscard]] Json to_json(const LevelTiming& timing);
[[nodiscard]] Json to_json(const AdaptReport& report);

/// The opposite of the above. They throw nlohmann's exceptions when a value is missing or of the
/// wrong kind, and InputError for a name that does not exist; the reader of the file adds its name.
void from_json(const Json& json, BoundaryRepair& repair);
void from_json(const Json& json, LevelStatistics& statistics);
void from_json(const Json& json, LevelTiming& timing);

} // namespace ameco
