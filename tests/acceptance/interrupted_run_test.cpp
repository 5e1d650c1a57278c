// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/acceptance/run_ameco.h"

#include <csignal>

using namespace ameco::test;

/// Ctrl-C and kill -9 while levels are being made.
class InterruptedRunTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void keeps_finished_levels_on_ctrl_c();
    void stops_without_a_level_on_an_early_ctrl_c();
    void stops_at_once_on_a_second_ctrl_c();
    void leaves_whole_files_when_killed_data();
    void leaves_whole_files_when_killed();

private:
    /// Starts a run and waits until it has printed the row of `level`.
    void start_until(QProcess& process, const QString& folder, int level);
    [[nodiscard]] nlohmann::json hierarchy(const QString& folder) const {
        return nlohmann::json::parse(here_.content(folder + "/hierarchy.json").toStdString());
    }
    void verify_resumes_to_the_same(const QString& folder);

    Workspace here_;
};

void InterruptedRunTest::initTestCase() {
    QCOMPARE(here_.ameco({"case", "layer", "--nx", "16", "--ny", "16", "-o", "layer.meshb"}).code,
             0);
    QCOMPARE(here_.ameco({"coarsen", "layer.meshb", "-o", "whole"}).code, 0);
}

void InterruptedRunTest::start_until(QProcess& process, const QString& folder, int level) {
    process.setProcessChannelMode(QProcess::SeparateChannels);
    here_.start(process, {"coarsen", "layer.meshb", "-o", folder, "--threads", "1"});
    const QByteArray row = "\n    " + QByteArray::number(level) + " ";
    QByteArray out;
    while (!out.contains(row)) {
        QVERIFY2(process.waitForReadyRead(60'000), out);
        out += process.readAllStandardOutput();
    }
}

void InterruptedRunTest::verify_resumes_to_the_same(const QString& folder) {
    const Run run = here_.ameco({"coarsen", "layer.meshb", "-o", folder, "--resume"});
    QVERIFY2(run.code == 0, run.text());
    QCOMPARE(here_.files(folder), here_.files("whole"));
    for (const QString& file : here_.files("whole")) {
        if (file != "timing.json") {
            QVERIFY2(here_.content(folder + "/" + file) == here_.content("whole/" + file),
                     qPrintable(file));
        }
    }
}

void InterruptedRunTest::keeps_finished_levels_on_ctrl_c() {
    QProcess process;
    start_until(process, "stopped", 1);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    const Run run = result_of(process);
    QVERIFY2(run.code == 6, run.text());
    QVERIFY2(run.err.contains("--resume goes on from here"), run.text());
    QCOMPARE(hierarchy("stopped").at("status").get<std::string>(), std::string("cancelled"));
    QVERIFY(hierarchy("stopped").at("levels").size() >= 2);
    QCOMPARE(broken_part_of(here_, "stopped"), QString());
    verify_resumes_to_the_same("stopped");
}

void InterruptedRunTest::stops_without_a_level_on_an_early_ctrl_c() {
    QProcess process;
    start_until(process, "early", 0);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    const Run run = result_of(process);
    QVERIFY2(run.code == 130, run.text());
    QCOMPARE(hierarchy("early").at("levels").size(), std::size_t{1});
    verify_resumes_to_the_same("early");
}

void InterruptedRunTest::stops_at_once_on_a_second_ctrl_c() {
    QProcess process;
    start_until(process, "twice", 0);
    // The same signal sent again before the first is handled would merge with it.
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
    const Run run = result_of(process);
    QVERIFY2(run.code == 130, run.text());
    QVERIFY2(run.err.contains("stopped at once"), run.text());
    QCOMPARE(broken_part_of(here_, "twice"), QString());
}

void InterruptedRunTest::leaves_whole_files_when_killed_data() {
    QTest::addColumn<int>("level");
    QTest::addColumn<int>("milliseconds"); ///< after that level's row
    for (const int level : {0, 1, 2, 3}) {
        for (const int milliseconds : {0, 7, 31}) {
            QTest::addRow("%d ms after level %d", milliseconds, level) << level << milliseconds;
        }
    }
}

void InterruptedRunTest::leaves_whole_files_when_killed() {
    QFETCH(int, level);
    QFETCH(int, milliseconds);
    const QString folder = QString("killed_%1_%2").arg(level).arg(milliseconds);
    QProcess process;
    start_until(process, folder, level);
    QTest::qSleep(std::max(1, milliseconds));
    ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
    process.waitForFinished();
    QVERIFY(hierarchy(folder).at("levels").size() > static_cast<std::size_t>(level));
    QCOMPARE(broken_part_of(here_, folder), QString());
    if (milliseconds == 0) {
        verify_resumes_to_the_same(folder);
    }
}

QTEST_GUILESS_MAIN(InterruptedRunTest)
#include "interrupted_run_test.moc"
