// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How help looks: what the command is for, examples, usage, options.
#pragma once

#include "app/cli/command.h"

#include <CLI/CLI.hpp>

namespace ameco::cli {

/// Group of the options that every subcommand has.
inline constexpr const char* common_group = "Common options";

/// Prints the help of one subcommand.
class HelpFormatter : public CLI::FormatterBase {
public:
    explicit HelpFormatter(CommandHelp help) : help_(std::move(help)) {}
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override;

private:
    CommandHelp help_;
};

/// Prints the help of the whole program.
class ProgramHelpFormatter : public CLI::FormatterBase {
public:
    explicit ProgramHelpFormatter(std::vector<CommandHelp> commands)
        : commands_(std::move(commands)) {}
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override;

private:
    std::vector<CommandHelp> commands_;
};

} // namespace ameco::cli
