// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/monitor.h"

#include "core/base/error.h"

#include <QTest>

#include <string>
#include <vector>

using namespace ameco;

namespace {

class Listener : public Monitor {
public:
    void message(Severity, std::string_view text) override { messages.emplace_back(text); }
    void progress(double fraction, std::string_view step) override {
        fractions.push_back(fraction);
        steps.emplace_back(step);
    }
    [[nodiscard]] bool stop_requested() const override { return stop; }

    std::vector<std::string> messages;
    std::vector<double> fractions;
    std::vector<std::string> steps;
    bool stop = false;
};

} // namespace

class MonitorTest : public QObject {
    Q_OBJECT
private slots:
    void maps_a_part_to_its_share_of_the_bar();
    void passes_messages_and_stop_requests_through_parts();
    void is_silent_by_default();
    void errors_carry_their_exit_code();
};

void MonitorTest::maps_a_part_to_its_share_of_the_bar() {
    Listener listener;
    MonitorPart half(listener, 0.5, 1.0);
    MonitorPart quarter(half, 0.0, 0.5);
    half.progress(0.0, "half");
    quarter.progress(1.0, "quarter");
    half.progress(1.0, "done");
    QCOMPARE(listener.fractions, (std::vector<double>{0.5, 0.75, 1.0}));
    QCOMPARE(listener.steps, (std::vector<std::string>{"half", "quarter", "done"}));
}

void MonitorTest::passes_messages_and_stop_requests_through_parts() {
    Listener listener;
    MonitorPart part(listener, 0, 1);
    part.message(Severity::warning, "hello");
    QCOMPARE(listener.messages, std::vector<std::string>{"hello"});
    QVERIFY(!part.stop_requested());
    listener.stop = true;
    QVERIFY(part.stop_requested());
}

void MonitorTest::is_silent_by_default() {
    Monitor& silent = Monitor::silent();
    silent.message(Severity::error, "nobody hears this");
    silent.progress(0.5, "nor sees this");
    QVERIFY(!silent.stop_requested());
}

void MonitorTest::errors_carry_their_exit_code() {
    // Numbers other people's scripts rely on.
    QCOMPARE(static_cast<int>(FileError("x").code()), 4);
    QCOMPARE(static_cast<int>(InputError("x").code()), 5);
    QCOMPARE(static_cast<int>(UsageError("x").code()), 2);
    QCOMPARE(static_cast<int>(Cancelled().code()), 130);
    QCOMPARE(std::string(FileError("wing.meshb: gone").what()), std::string("wing.meshb: gone"));
}

QTEST_APPLESS_MAIN(MonitorTest)
#include "monitor_test.moc"
