// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef Q_MOC_RUN // moc 6.4 cannot parse <chrono> of GCC 12
#include "app/cli/terminal_monitor.h"
#endif

#include <nlohmann/json.hpp>

#include <csignal>
#include <sstream>

#include <QtTest>

using namespace ameco;
using namespace ameco::cli;

class TerminalMonitorTest : public QObject {
    Q_OBJECT
private slots:
    void says_as_much_as_was_asked_for_data();
    void says_as_much_as_was_asked_for();
    void draws_a_bar_that_fits_the_terminal();
    void takes_the_bar_away_before_a_message();
    void draws_no_more_than_ten_times_a_second();
    void prints_progress_that_programs_can_read();
    void is_silent_about_what_is_over_soon();
    void writes_durations_as_people_do();
    void stops_when_interrupted();
};

void TerminalMonitorTest::says_as_much_as_was_asked_for_data() {
    QTest::addColumn<int>("verbosity");
    QTest::addColumn<QString>("text");
    QTest::newRow("quiet") << -1 << "ameco: c\n";
    QTest::newRow("normal") << 0 << "ameco: warning: b\nameco: c\n";
    QTest::newRow("verbose") << 1 << "ameco: a\nameco: warning: b\nameco: c\n";
}

void TerminalMonitorTest::says_as_much_as_was_asked_for() {
    QFETCH(int, verbosity);
    QFETCH(QString, text);
    std::ostringstream err;
    TerminalMonitor monitor(err, {ProgressStyle::none, verbosity});
    monitor.message(Severity::info, "a");
    monitor.message(Severity::warning, "b");
    monitor.message(Severity::error, "c");
    monitor.progress(0.5, "step");
    QCOMPARE(QString::fromStdString(err.str()), text);
}

void TerminalMonitorTest::draws_a_bar_that_fits_the_terminal() {
    std::ostringstream err;
    TerminalMonitor monitor(err, {ProgressStyle::bar, 0, false, 60});
    monitor.progress(0.5, std::string(200, 'x'));
    const QString text = QString::fromStdString(err.str());
    QVERIFY2(text.startsWith("\r[############............] 50 %"), qPrintable(text));
    QCOMPARE(text.size(), 1 + 59 + 3); // return, the line, "clear to the end"
}

void TerminalMonitorTest::takes_the_bar_away_before_a_message() {
    std::ostringstream err;
    TerminalMonitor monitor(err, {ProgressStyle::bar});
    monitor.progress(0.5, "step");
    err.str("");
    monitor.message(Severity::warning, "odd");
    QCOMPARE(QString::fromStdString(err.str()), QString("\r\033[Kameco: warning: odd\n"));
    err.str("");
    monitor.clear_line();
    QCOMPARE(err.str(), std::string());
}

void TerminalMonitorTest::draws_no_more_than_ten_times_a_second() {
    std::ostringstream err;
    TerminalMonitor monitor(err, {ProgressStyle::bar});
    for (int i = 0; i < 1000; ++i) {
        monitor.progress(i / 1000.0, "step");
    }
    QVERIFY(QString::fromStdString(err.str()).count('\r') <= 2);
}

void TerminalMonitorTest::prints_progress_that_programs_can_read() {
    std::ostringstream err;
    TerminalMonitor monitor(err, {ProgressStyle::json});
    monitor.progress(0.25, "level 1: \"swap\"");
    const auto line = nlohmann::json::parse(err.str());
    QCOMPARE(line.at("progress").get<double>(), 0.25);
    QCOMPARE(line.at("step").get<std::string>(), std::string("level 1: \"swap\""));
    QVERIFY(line.at("seconds").get<double>() >= 0);
    QVERIFY(line.at("seconds_left").is_null()); // too early to say
}

void TerminalMonitorTest::is_silent_about_what_is_over_soon() {
    std::ostringstream err;
    TerminalMonitor monitor(err, {ProgressStyle::plain});
    monitor.progress(0.5, "half");
    monitor.progress(1, "all");
    QCOMPARE(err.str(), std::string());
}

void TerminalMonitorTest::writes_durations_as_people_do() {
    QCOMPARE(duration_text(-1), std::string("0 s"));
    QCOMPARE(duration_text(59.4), std::string("59 s"));
    QCOMPARE(duration_text(125), std::string("2 min 05 s"));
    QCOMPARE(duration_text(4830), std::string("1 h 20 min"));
}

void TerminalMonitorTest::stops_when_interrupted() {
    std::ostringstream err;
    const TerminalMonitor monitor(err, {});
    QVERIFY(!monitor.stop_requested());
    handle_interrupts();
    std::raise(SIGINT);
    QVERIFY(monitor.stop_requested());
}

QTEST_APPLESS_MAIN(TerminalMonitorTest)
#include "terminal_monitor_test.moc"
