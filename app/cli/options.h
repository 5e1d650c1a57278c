// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Options that several subcommands share, and tests of their values that say what is wrong in
/// plain words.
#pragma once

#include "core/coarsen/target_metric.h"
#include "core/metric/nodal_metric.h"

#include <CLI/CLI.hpp>

#include <string>
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

/// Adds `--mean`; its value is converted by `chosen_mean`.
CLI::Option* add_mean_option(CLI::App& app, std::string& mean);
[[nodiscard]] Mean chosen_mean(const std::string& text);

/// Adds what decides the metric of the next level, but for the factor: `--slack`, `--algorithm`,
/// `--gradation`.
void add_target_options(CLI::App& app, TargetOptions& target, const std::string& group);

} // namespace ameco::cli
