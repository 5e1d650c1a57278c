// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// "Did you mean": the known word nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ameco::cli {

/// Fewest letters to insert, delete, replace or exchange with a neighbour to turn `a` into `b`.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// `", did you mean <word>?"` for the known word nearest to `word`, or `""` if none is near enough
/// to be what was meant.
[[nodiscard]] std::string did_you_mean(const std::string& word,
                                       const std::vector<std::string>& known);

} // namespace ameco::cli
