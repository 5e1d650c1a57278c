// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/python/python_monitor.h"

#include <utility>

namespace ameco::python {
namespace {

/// How long Ctrl-C and `cancel` may go unseen.
constexpr std::chrono::milliseconds look_every(20);
/// Progress by less is not told: each call takes Python's lock.
constexpr double smallest_progress = 0.002;

} // namespace

PythonMonitor::PythonMonitor(py::object progress, py::object cancel)
    : progress_(std::move(progress)), cancel_(std::move(cancel)) {}

template <class Ask>
void PythonMonitor::with_python(const Ask& ask) const {
    if (raised_) {
        return;
    }
    const py::gil_scoped_acquire locked;
    try {
        ask();
    } catch (py::error_already_set& error) {
        raised_.emplace(std::move(error));
        stop_ = true;
    }
}

void PythonMonitor::message(Severity severity, std::string_view text) {
    with_python([&] {
        const py::object logger = py::module_::import("logging").attr("getLogger")("ameco");
        const char* const method = severity == Severity::error     ? "error"
                                   : severity == Severity::warning ? "warning"
                                                                   : "info";
        logger.attr(method)("%s", std::string(text));
    });
}

void PythonMonitor::progress(double fraction, std::string_view step) {
    look();
    const bool news = step != step_ || fraction >= reported_ + smallest_progress;
    if (progress_.is_none() || !news || stop_) {
        return;
    }
    reported_ = fraction;
    step_ = step;
    with_python([&] {
        const py::object answer = progress_(fraction, step_);
        if (answer.is(py::bool_(false))) {
            stop_ = true;
        }
    });
}

bool PythonMonitor::stop_requested() const {
    // Worker threads may ask, too; they see what this thread has found.
    if (std::this_thread::get_id() == owner_) {
        look();
    }
    return stop_;
}

void PythonMonitor::look() const {
    const Clock::time_point now = Clock::now();
    if (stop_ || now < next_look_) {
        return;
    }
    next_look_ = now + look_every;
    with_python([&] {
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
        if (!cancel_.is_none() && cancel_.attr("is_set")().cast<bool>()) {
            stop_ = true;
        }
    });
}

void PythonMonitor::raise_kept() {
    if (raised_) {
        throw py::error_already_set(std::move(*std::exchange(raised_, std::nullopt)));
    }
}

} // namespace ameco::python
