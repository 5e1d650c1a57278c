// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The .mapbc file of FUN3D: a count, then rows of patch, number of the boundary condition, name.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace ameco::mapbc {

struct Patch {
    int condition = 0; ///< FUN3D's number of the boundary condition
    std::string name;  ///< may be empty
};

/// \throws InputError
[[nodiscard]] std::map<int, Patch> read(std::string_view bytes, const std::string& name);

/// Writes the file whole or not at all.
/// \throws FileError
void write(const std::filesystem::path& path, const std::map<int, Patch>& patches);

} // namespace ameco::mapbc
