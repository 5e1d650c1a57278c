// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/program.h"

#include <exception>
#include <iostream>
#include <new>

/// The last catch: what nobody expected becomes one line and an exit code.
int main(int argc, char** argv) {
    using ameco::ExitCode;
    try {
        return static_cast<int>(ameco::cli::run_program(argc, argv));
    } catch (const std::bad_alloc&) {
        std::cerr << "ameco: not enough memory: use a machine with more, or a smaller mesh "
                     "(ameco info says what a mesh needs)\n";
        return static_cast<int>(ExitCode::memory);
    } catch (const std::exception& error) {
        std::cerr << "ameco: internal error: " << error.what()
                  << ": please report it with the command you ran\n";
        return static_cast<int>(ExitCode::internal);
    }
}
