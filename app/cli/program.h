// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The batch program: from the words of a command line to a subcommand and an exit code.
#pragma once

#include "core/base/error.h"

namespace ameco::cli {

/// Runs the program on the process's stdout and stderr. Trouble from outside is reported here, in
/// one line on stderr; what else is thrown is the caller's to catch.
[[nodiscard]] ExitCode run_program(int argc, const char* const* argv);

} // namespace ameco::cli
