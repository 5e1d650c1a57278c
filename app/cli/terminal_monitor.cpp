// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/terminal_monitor.h"

#include "core/base/error.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>

#include <nlohmann/json.hpp>

#include <unistd.h>

namespace ameco::cli {
namespace {

std::atomic<int> interrupts{0};
static_assert(std::atomic<int>::is_always_lock_free, "it is changed by a signal handler");

extern "C" void on_interrupt(int) {
    if (interrupts.fetch_add(1) > 0) {
        constexpr char text[] = "\nameco: stopped at once\n";
        [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof text - 1);
        ::_exit(static_cast<int>(ExitCode::cancelled));
    }
    constexpr char text[] = "\nameco: stopping at the next safe place; again to stop at once\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof text - 1);
}

/// Seconds left if the rest goes as fast as what is done; negative when it is too early to say.
double seconds_left(double fraction, double elapsed) {
    return fraction > 0.02 && elapsed > 1 ? elapsed * (1 - fraction) / fraction : -1;
}

std::string percent(double fraction) {
    return std::to_string(static_cast<int>(std::floor(100 * fraction))) + " %";
}

std::string time_left(double fraction, double elapsed) {
    const double left = seconds_left(fraction, elapsed);
    return left < 0 ? "" : ", " + duration_text(left) + " left";
}

} // namespace

TerminalMonitor::TerminalMonitor(std::ostream& err, const MonitorSettings& settings)
    : err_(err), settings_(settings) {}

TerminalMonitor::~TerminalMonitor() {
    clear_line();
}

void TerminalMonitor::configure(const MonitorSettings& settings) {
    settings_ = settings;
}

void TerminalMonitor::message(Severity severity, std::string_view text) {
    const int needed = severity == Severity::info ? 1 : severity == Severity::warning ? 0 : -1;
    if (settings_.verbosity < needed) {
        return;
    }
    clear_line();
    const char* const code = severity == Severity::error     ? "\033[1;31m"
                             : severity == Severity::warning ? "\033[1;33m"
                                                             : "\033[1m";
    err_ << (settings_.color ? code : "") << "ameco:" << (settings_.color ? "\033[0m" : "")
         << (severity == Severity::warning ? " warning: " : " ") << text << std::endl;
}

void TerminalMonitor::progress(double fraction, std::string_view step) {
    if (settings_.style == ProgressStyle::none) {
        return;
    }
    const double done = std::clamp(fraction, 0.0, 1.0);
    const Clock::time_point now = Clock::now();
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    if (settings_.style == ProgressStyle::plain) {
        print_plain(done, step, elapsed);
        return;
    }
    if (now - drawn_ < std::chrono::milliseconds(100)) {
        return;
    }
    drawn_ = now;
    if (settings_.style == ProgressStyle::bar) {
        draw_bar(done, step, elapsed);
    } else {
        print_json(done, step, elapsed);
    }
}

bool TerminalMonitor::stop_requested() const {
    return interrupts.load(std::memory_order_relaxed) > 0;
}

void TerminalMonitor::clear_line() {
    if (line_is_drawn_) {
        err_ << "\r\033[K" << std::flush;
        line_is_drawn_ = false;
    }
}

void TerminalMonitor::draw_bar(double fraction, std::string_view step, double elapsed) {
    constexpr int bar_width = 24;
    const int filled = static_cast<int>(std::floor(fraction * bar_width));
    std::string line = "[" + std::string(static_cast<std::size_t>(filled), '#') +
                       std::string(static_cast<std::size_t>(bar_width - filled), '.') + "] " +
                       percent(fraction) + time_left(fraction, elapsed) + "  " + std::string(step);
    line.resize(std::min(line.size(), static_cast<std::size_t>(std::max(20, settings_.width - 1))));
    err_ << '\r' << line << "\033[K" << std::flush;
    line_is_drawn_ = true;
}

void TerminalMonitor::print_plain(double fraction, std::string_view step, double elapsed) {
    constexpr double quick = 2; // seconds: what is over sooner needs no lines about it
    const int tenths = static_cast<int>(std::floor(10 * fraction));
    if (elapsed < quick || tenths <= tenths_printed_) {
        return;
    }
    tenths_printed_ = tenths;
    err_ << "ameco: " << 10 * tenths << " %, " << step << time_left(fraction, elapsed) << std::endl;
}

void TerminalMonitor::print_json(double fraction, std::string_view step, double elapsed) {
    nlohmann::ordered_json line = {
        {"progress", fraction}, {"step", step}, {"seconds", elapsed}, {"seconds_left", nullptr}};
    if (const double left = seconds_left(fraction, elapsed); left >= 0) {
        line["seconds_left"] = left;
    }
    err_ << line.dump() << std::endl;
}

void handle_interrupts() {
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART; // reads and writes under way go on
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

std::string duration_text(double seconds) {
    const auto s = static_cast<long>(std::llround(std::max(0.0, seconds)));
    const auto two = [](long value) { return (value < 10 ? "0" : "") + std::to_string(value); };
    if (s < 60) {
        return std::to_string(s) + " s";
    }
    if (s < 3600) {
        return std::to_string(s / 60) + " min " + two(s % 60) + " s";
    }
    return std::to_string(s / 3600) + " h " + two(s / 60 % 60) + " min";
}

} // namespace ameco::cli
