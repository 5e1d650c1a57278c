// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Work done in a child process, where nothing it does can harm us.
#pragma once

#include "core/base/monitor.h"

#include <cstdint>
#include <functional>
#include <string>

namespace ameco {

struct ChildOptions {
    std::int64_t memory = 0;  ///< what it may use beyond what the process has [bytes]; 0: no limit
    bool keep_output = false; ///< what it prints is kept; else it is lost
    /// Where progress is shown while we wait (the step alone: nobody knows how far it is), and who
    /// may ask to stop; then the child is ended. May be null.
    Monitor* monitor = nullptr;
    std::string step = {}; ///< what is being done, a few words
};

struct ChildOutcome {
    bool started = false;  ///< there was a process to be had
    bool survived = false; ///< the work returned
    bool stopped = false;  ///< the monitor asked to stop
    int signal = 0;        ///< that ended the child, 0 if none did
    std::string result;    ///< what the work returned
    std::string output;    ///< what it printed, if that was to be kept
};

/// Calls `work` in a child process and waits for its end. The child has a copy of our memory, so
/// `work` sees all that we see; what it changes is lost, but for the string that it returns.
/// Exceptions that leave `work` end the child as a crash does. The child goes when we go.
///
/// Only the calling thread goes on living in the child: `work` must not wait for others, so it must
/// not run parallel loops.
[[nodiscard]] ChildOutcome run_in_child(const std::function<std::string()>& work,
                                        const ChildOptions& options = {});

} // namespace ameco
