// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Parts of the program that are loaded when they are needed, so that all else runs on machines
/// without the libraries they want.
#pragma once

#include <string>

namespace ameco {

/// The function `symbol` of the module `name` ("ameco_render": libameco_render.so). Looks beside
/// the program, where modules are installed, and where they are built. \throws Error (not_built)
/// when there is no such module, or its libraries are missing
[[nodiscard]] void* load_symbol(const std::string& name, const std::string& symbol);

template <class Function>
[[nodiscard]] Function* load_function(const std::string& name, const std::string& symbol) {
    return reinterpret_cast<Function*>(load_symbol(name, symbol));
}

} // namespace ameco
