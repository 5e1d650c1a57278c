// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Messages, progress and stop requests, in one small interface.
#pragma once

#include <string_view>

namespace ameco {

enum class Severity { info, warning, error };

/// What a long computation tells its caller, and how the caller tells it to stop.
///
/// `message` and `progress` are called from the thread that called the computation;
/// `stop_requested` may be asked from any thread.
class Monitor {
public:
    virtual ~Monitor() = default;

    virtual void message(Severity severity, std::string_view text) = 0;

    /// \param fraction  done so far, in [0, 1]
    /// \param step      what is being done, a few words
    virtual void progress(double fraction, std::string_view step) = 0;

    [[nodiscard]] virtual bool stop_requested() const = 0;

    /// A monitor that says nothing and never stops.
    static Monitor& silent();
};

/// Maps a callee's 0 ... 1 to a share of the caller's progress bar.
class MonitorPart : public Monitor {
public:
    /// \param begin, end  the share of the parent's bar, 0 <= begin <= end <= 1
    MonitorPart(Monitor& parent, double begin, double end)
        : parent_(parent), begin_(begin), end_(end) {}

    void message(Severity severity, std::string_view text) override {
        parent_.message(severity, text);
    }
    void progress(double fraction, std::string_view step) override {
        parent_.progress(begin_ + (end_ - begin_) * fraction, step);
    }
    [[nodiscard]] bool stop_requested() const override { return parent_.stop_requested(); }

private:
    Monitor& parent_;
    double begin_;
    double end_;
};

} // namespace ameco
