// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Progress and messages on stderr, and Ctrl-C.
#pragma once

#include "core/base/monitor.h"

#include <chrono>
#include <ostream>
#include <string>

namespace ameco::cli {

enum class ProgressStyle {
    none,
    bar,   ///< one line that is drawn again and again; for a terminal
    plain, ///< a line every 10 %, after the first two seconds; for a log file
    json   ///< one JSON object per line; for programs
};

struct MonitorSettings {
    ProgressStyle style = ProgressStyle::plain;
    int verbosity = 0; ///< -1: errors only; 0: warnings too; 1: everything
    bool color = false;
    int width = 80; ///< columns of the terminal
};

/// Writes to one stream. Progress is drawn at most ten times a second; the time left is estimated
/// from the time used so far.
class TerminalMonitor : public Monitor {
public:
    explicit TerminalMonitor(std::ostream& err, const MonitorSettings& settings = {});
    ~TerminalMonitor() override;
    TerminalMonitor(const TerminalMonitor&) = delete;
    TerminalMonitor& operator=(const TerminalMonitor&) = delete;

    void configure(const MonitorSettings& settings);
    [[nodiscard]] const MonitorSettings& settings() const { return settings_; }

    void message(Severity severity, std::string_view text) override;
    void progress(double fraction, std::string_view step) override;
    /// Whether Ctrl-C was pressed (or SIGTERM received) since handle_interrupts().
    [[nodiscard]] bool stop_requested() const override;

    /// Takes the progress line away, so that a result can be printed; the next progress draws it
    /// again.
    void clear_line();

private:
    using Clock = std::chrono::steady_clock;

    void draw_bar(double fraction, std::string_view step, double elapsed);
    void print_plain(double fraction, std::string_view step, double elapsed);
    void print_json(double fraction, std::string_view step, double elapsed);

    std::ostream& err_;
    MonitorSettings settings_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point drawn_{};
    bool line_is_drawn_ = false;
    int tenths_printed_ = 0;
};

/// From now on the first Ctrl-C asks the computation to stop and the second one ends the process
/// with exit code 130.
void handle_interrupts();

/// "3 s", "2 min 05 s", "1 h 20 min".
[[nodiscard]] std::string duration_text(double seconds);

} // namespace ameco::cli
