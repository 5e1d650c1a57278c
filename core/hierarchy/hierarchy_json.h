// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// hierarchy.json, schema version 1: the table of contents of a hierarchy's folder.
#pragma once

#include "core/hierarchy/hierarchy.h"

#include <string>
#include <vector>

namespace ameco {

/// The text of hierarchy.json. The same hierarchy gives the same bytes.
[[nodiscard]] std::string hierarchy_text(const Hierarchy& hierarchy);

/// Reads it back.
/// \param file  for messages
/// \throws InputError when the text is not JSON, of another schema version, lacks something or
///         contradicts itself
[[nodiscard]] Hierarchy parse_hierarchy(const std::string& text, const std::string& file);

/// The text of timing.json: what differs from run to run.
[[nodiscard]] std::string timing_text(const std::vector<LevelTiming>& timings, int threads);

/// \throws InputError
[[nodiscard]] std::vector<LevelTiming> parse_timing(const std::string& text,
                                                    const std::string& file);

/// Names of the settings that differ between two hierarchies, so that one cannot be continued as
/// the other: "factor, slack". The number of levels may differ.
[[nodiscard]] std::string different_settings(const Hierarchy& a, const Hierarchy& b);

} // namespace ameco
