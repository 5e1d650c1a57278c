// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Wall-clock time, for reports.
#pragma once

#include <chrono>

namespace ameco {

/// Runs from the moment it is made.
class Stopwatch {
public:
    /// Since it was made, or since the last lap [s].
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    /// The same, and starts anew.
    double lap() {
        const double result = seconds();
        start_ = std::chrono::steady_clock::now();
        return result;
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace ameco
