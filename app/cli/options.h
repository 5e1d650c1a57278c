// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Options that several subcommands share, and tests of their values that say what is wrong in
/// plain words.
#pragma once

#include "core/hierarchy/settings.h"

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace ameco::cli {

/// Accepts a whole number in [low, high].
[[nodiscard]] CLI::Validator whole_number(long low, long high);
/// Accepts a finite number greater than `bound`.
[[nodiscard]] CLI::Validator greater_than(double bound);
/// Accepts a finite number in [low, high].
[[nodiscard]] CLI::Validator number_within(double low, double high);
/// Accepts one of the words.
[[nodiscard]] CLI::Validator one_of(std::vector<std::string> words);

/// Finite numbers with commas between them; empty when the text is something else.
[[nodiscard]] std::vector<double> numbers_from(const std::string& text);

/// Adds the option of a setting (core/hierarchy/settings.h): its name, help, default and test are
/// those of the table. `options` must live as long as the parser.
/// \param short_name  "n" for -n; may be empty
CLI::Option* add_setting(CLI::App& app, HierarchyOptions& options, std::string_view name,
                         const std::string& group = "Options", const std::string& short_name = "");

} // namespace ameco::cli
