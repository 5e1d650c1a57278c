// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/child_process.h"

#include <QTest>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

using namespace ameco;

class ChildProcessTest : public QObject {
    Q_OBJECT
private slots:
    void brings_back_what_the_work_returns();
    void changes_nothing_of_ours();
    void survives_what_the_child_does_not_data();
    void survives_what_the_child_does_not();
    void keeps_what_is_printed_only_when_asked();
    void ends_the_child_when_asked_to_stop();
};

namespace {

class Impatient : public Monitor {
public:
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view step) override { last_step = step; }
    [[nodiscard]] bool stop_requested() const override { return ++asked > 3; }
    mutable int asked = 0;
    std::string last_step;
};

} // namespace

void ChildProcessTest::brings_back_what_the_work_returns() {
    std::string bytes(5'000'000, 'x'); // more than a pipe holds
    bytes[4'999'999] = '\0';
    const ChildOutcome outcome = run_in_child([&] { return bytes + "end"; });
    QVERIFY(outcome.started && outcome.survived && !outcome.stopped);
    QVERIFY(outcome.result == bytes + "end");
}

void ChildProcessTest::changes_nothing_of_ours() {
    int value = 1;
    QVERIFY(run_in_child([&] {
                value = 2;
                return std::string();
            }).survived);
    QCOMPARE(value, 1);
}

void ChildProcessTest::survives_what_the_child_does_not_data() {
    QTest::addColumn<QString>("end");
    QTest::addColumn<int>("signal");
    QTest::newRow("abort") << "abort" << SIGABRT;
    QTest::newRow("crash") << "crash" << SIGSEGV;
    QTest::newRow("exit") << "exit" << 0;
    QTest::newRow("exception") << "exception" << 0;
}

void ChildProcessTest::survives_what_the_child_does_not() {
    QFETCH(QString, end);
    QFETCH(int, signal);
    const ChildOutcome outcome = run_in_child([&]() -> std::string {
        if (end == "abort") {
            std::abort();
        } else if (end == "crash") {
            std::raise(SIGSEGV);
        } else if (end == "exit") {
            std::_Exit(3);
        }
        throw std::runtime_error("no");
    });
    QVERIFY(outcome.started && !outcome.survived);
    QCOMPARE(outcome.signal, signal);
    QVERIFY(outcome.result.empty());
}

void ChildProcessTest::keeps_what_is_printed_only_when_asked() {
    const auto talk = [] {
        std::printf("to the output");
        std::fprintf(stderr, "; to the errors");
        std::fflush(stdout);
        return std::string("done");
    };
    const ChildOutcome kept = run_in_child(talk, {.keep_output = true});
    QVERIFY(kept.output.find("to the output") != std::string::npos);
    QVERIFY(kept.output.find("to the errors") != std::string::npos);
    QCOMPARE(run_in_child(talk).output, std::string());
}

void ChildProcessTest::ends_the_child_when_asked_to_stop() {
    Impatient monitor;
    const ChildOutcome outcome = run_in_child(
        []() -> std::string {
            for (;;) {
            }
        },
        {.monitor = &monitor, .step = "going round"});
    QVERIFY(outcome.stopped && !outcome.survived);
    QCOMPARE(monitor.last_step, std::string("going round"));
}

QTEST_APPLESS_MAIN(ChildProcessTest)
#include "child_process_test.moc"
