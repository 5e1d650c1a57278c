// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Obeying stop requests.
#pragma once

#include "core/base/error.h"
#include "core/base/monitor.h"

namespace ameco {

/// \throws Cancelled when a stop was requested
inline void stop_if_asked(const Monitor& monitor) {
    if (monitor.stop_requested()) {
        throw Cancelled();
    }
}

/// Asks a monitor now and then: for loops whose steps are much faster than the question.
class StopCheck {
public:
    explicit StopCheck(const Monitor& monitor) : monitor_(monitor) {}

    /// Whether a stop was requested, as far as it was asked: once in 1024 calls.
    [[nodiscard]] bool asked() {
        asked_ = asked_ || ((++calls_ & 1023U) == 0 && monitor_.stop_requested());
        return asked_;
    }

private:
    const Monitor& monitor_;
    unsigned calls_ = 0;
    bool asked_ = false;
};

} // namespace ameco
