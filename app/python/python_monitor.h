// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Computations without Python's lock, that tell Python how far they are and listen to it.
#pragma once

#include "core/base/error.h"
#include "core/base/monitor.h"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <thread>

namespace ameco::python {

namespace py = pybind11;

/// Passes progress to a function and messages to the logger "ameco"; stops when the function
/// returns False or raises, when `cancel` is set, and at Ctrl-C.
///
/// What Python raises does not travel through core: it is kept, core is asked to stop, and
/// `call` raises it afterwards.
class PythonMonitor : public Monitor {
public:
    /// \param progress  called with the share done and the step, or None
    /// \param cancel    has `is_set()`, as threading.Event does, or None
    PythonMonitor(py::object progress, py::object cancel);

    void message(Severity severity, std::string_view text) override;
    void progress(double fraction, std::string_view step) override;
    [[nodiscard]] bool stop_requested() const override;

    /// Calls `work()` without Python's lock, from the thread that holds it now.
    template <class Work>
    auto call(const Work& work) {
        const auto run = [&] {
            const py::gil_scoped_release unlocked;
            return work();
        };
        try {
            auto result = run();
            raise_kept();
            return result;
        } catch (const Cancelled&) {
            raise_kept();
            throw;
        }
    }

private:
    using Clock = std::chrono::steady_clock;

    void raise_kept();
    /// Runs `ask` with Python's lock; what it raises is kept.
    template <class Ask>
    void with_python(const Ask& ask) const;
    void look() const;

    py::object progress_;
    py::object cancel_;
    std::thread::id owner_ = std::this_thread::get_id();
    double reported_ = -1;
    std::string step_;
    mutable Clock::time_point next_look_{};
    mutable std::atomic<bool> stop_{false};
    mutable std::optional<py::error_already_set> raised_;
};

} // namespace ameco::python
