// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/monitor.h"

namespace ameco {
namespace {

class SilentMonitor : public Monitor {
public:
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view) override {}
    [[nodiscard]] bool stop_requested() const override { return false; }
};

} // namespace

Monitor& Monitor::silent() {
    static SilentMonitor monitor;
    return monitor;
}

} // namespace ameco
