// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the program asks the window, a module that it loads when it needs one. No Qt here.
#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace ameco::gui {

struct WindowJob {
    std::vector<std::string> files; ///< to open, a window for each; may be empty
    int threads = 0;                ///< as in set_thread_count
    bool dark = false;
};

struct WindowResult {
    std::string error; ///< one line; empty when all went well
    ExitCode code = ExitCode::ok;
};

/// Entry of the module ameco_window; returns when the last window is closed. Throws nothing.
using OpenWindow = void(const WindowJob& job, WindowResult& result);

} // namespace ameco::gui
