// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A look at what a foreign library does with a file, before it does it to us.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace ameco {

/// Runs `read` in a child process, to see whether a library survives a file.
///
/// VTK 9.1, libcgns 3.4 and OpenMesh 9 crash on some damaged files, and ask for as much memory as a
/// file tells them to. A user whose file is damaged should be told so. The price is that a good
/// file is read twice. What `read` throws is of no matter here: it will be thrown again. \param
/// name     of the file, for the message \param library  likewise \param bytes    size of the file,
/// unpacked: some multiple of it is what `read` may use of memory \throws InputError  it crashed,
/// or asked for more memory
void require_survival(const std::string& name, const char* library, std::int64_t bytes,
                      const std::function<void()>& read);

} // namespace ameco
