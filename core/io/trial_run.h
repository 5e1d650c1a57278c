// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A look at what a foreign library does with a file, before it does it to us.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace ameco {

/// How much memory a trial may use beyond what the process has already.
struct TrialMemory {
    std::int64_t bytes = 0;    ///< size of the file, unpacked
    std::int64_t per_byte = 4; ///< times that; good files take at most 3, hexahedra split included
                               ///< (docs/dev/testing.md)
};

/// Runs `read` in a child process, to see whether a library survives a file.
///
/// VTK 9.1, libcgns 3.4 and OpenMesh 9 crash on some damaged files, and ask for as much memory as a
/// file tells them to. A user whose file is damaged should be told so, and nobody's machine should
/// swap. The child has 32 MiB and `memory` to spend. What it throws is thrown here, without a
/// second attempt: so whatever is read after a trial, in the process itself, has been read within
/// that memory before. The price is that a good file is read twice.
///
/// \param name     of the file, for the message
/// \param library  likewise
/// \throws InputError  it crashed, asked for more memory, or threw an error
/// \throws FileError   it threw one
void require_survival(const std::string& name, const char* library, const TrialMemory& memory,
                      const std::function<void()>& read);

} // namespace ameco
