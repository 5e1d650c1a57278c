// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A subcommand: its name, its help, its options, and what it does.
#pragma once

#include "app/cli/terminal_monitor.h"
#include "core/base/error.h"

#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ameco::cli {

/// One line of the examples, which come first in every help.
struct Example {
    std::string command; ///< as it would be typed, without the leading "ameco "
    std::string what;    ///< what it does, a few words
};

struct CommandHelp {
    std::string name;    ///< "coarsen"
    std::string summary; ///< one line, for the list of commands
    std::string usage;   ///< "coarsen MESH -o DIR [options]"
    std::vector<Example> examples;
    std::string notes; ///< paragraphs after the options, one per line; may be empty
};

/// What a running subcommand gets from the program.
struct Session {
    std::ostream& out;        ///< results, and nothing else
    TerminalMonitor& monitor; ///< progress, messages, Ctrl-C: all on stderr
    bool json = false;        ///< results as JSON
    int verbosity = 0;        ///< -1 quiet, 0, 1 verbose
    int threads = 0;          ///< as asked for; 0: all of the machine's
};

class Command {
public:
    virtual ~Command() = default;

    [[nodiscard]] virtual CommandHelp help() const = 0;
    /// Tells the parser the options; their values land in members of the command.
    virtual void add_options(CLI::App& app) = 0;
    /// \throws Error for trouble from outside
    virtual ExitCode run(Session& session) = 0;
};

/// All subcommands, in the order of the help.
[[nodiscard]] std::vector<std::unique_ptr<Command>> all_commands();

} // namespace ameco::cli
