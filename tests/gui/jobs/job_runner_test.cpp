// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/jobs/job_runner.h"

#include "core/base/error.h"

#include <QElapsedTimer>
#include <QSemaphore>
#include <QSignalSpy>
#include <QThread>
#include <QtTest>

using namespace ameco;
using namespace ameco::gui;

namespace {

/// Listens to a runner.
struct Ends {
    explicit Ends(JobRunner& runner) {
        QObject::connect(&runner, &JobRunner::ended, &runner,
                         [this](JobEnd end, const QString& reason) {
                             ends.push_back(end);
                             reasons << reason;
                         });
    }
    std::vector<JobEnd> ends;
    QStringList reasons;
};

} // namespace

class JobRunnerTest : public QObject {
    Q_OBJECT
private slots:
    void works_on_another_thread_and_posts_to_this_one();
    void tells_what_goes_wrong();
    void cancelling_answers_at_once_however_deep_the_job_is();
    void nothing_of_a_cancelled_job_is_heard();
    void a_new_job_replaces_the_old_one();
    void progress_is_told_and_never_goes_back();
    void the_runner_can_go_while_a_job_runs();
};

void JobRunnerTest::works_on_another_thread_and_posts_to_this_one() {
    JobRunner runner;
    Ends ends(runner);
    QThread* worker = nullptr;
    QThread* poster = nullptr;
    runner.start("job", [&](JobContext& job) {
        worker = QThread::currentThread();
        job.post([&] { poster = QThread::currentThread(); });
    });
    QVERIFY(runner.isRunning());
    QTRY_COMPARE(ends.ends.size(), std::size_t{1});
    QVERIFY(ends.ends[0] == JobEnd::done);
    QVERIFY(worker != nullptr && worker != QThread::currentThread());
    QCOMPARE(poster, QThread::currentThread());
    QVERIFY(!runner.isRunning());
}

void JobRunnerTest::tells_what_goes_wrong() {
    JobRunner runner;
    Ends ends(runner);
    runner.start("job", [](JobContext&) { throw FileError("wing.meshb: cannot be read"); });
    QTRY_COMPARE(ends.ends.size(), std::size_t{1});
    QVERIFY(ends.ends[0] == JobEnd::failed);
    QCOMPARE(ends.reasons[0], QString("wing.meshb: cannot be read"));
}

void JobRunnerTest::cancelling_answers_at_once_however_deep_the_job_is() {
    JobRunner runner;
    Ends ends(runner);
    QSemaphore inside, leave;
    runner.start("job", [&](JobContext&) {
        inside.release();
        leave.acquire(); // asks nobody whether it shall stop
    });
    inside.acquire();
    QElapsedTimer timer;
    timer.start();
    runner.cancel();
    QVERIFY(timer.elapsed() < 200);
    QVERIFY(!runner.isRunning());
    QCOMPARE(ends.ends.size(), std::size_t{1});
    QVERIFY(ends.ends[0] == JobEnd::cancelled);
    QCOMPARE(runner.windingDown(), 1);
    leave.release();
    QTRY_COMPARE(runner.windingDown(), 0);
    QCOMPARE(ends.ends.size(), std::size_t{1});
}

void JobRunnerTest::nothing_of_a_cancelled_job_is_heard() {
    JobRunner runner;
    bool heard = false;
    QSignalSpy said(&runner, &JobRunner::said);
    QSemaphore posted;
    runner.start("job", [&](JobContext& job) {
        job.post([&] { heard = true; });
        job.message(Severity::info, "hello");
        posted.release();
    });
    posted.acquire();
    runner.cancel(); // before the event loop has seen the post
    QTRY_COMPARE(runner.windingDown(), 0);
    QVERIFY(!heard);
    QCOMPARE(said.count(), 0);
}

void JobRunnerTest::a_new_job_replaces_the_old_one() {
    JobRunner runner;
    Ends ends(runner);
    int heard = 0;
    QSemaphore leave;
    runner.start("old", [&](JobContext& job) {
        leave.acquire();
        job.post([&] { heard = 1; });
    });
    runner.start("new", [&](JobContext& job) { job.post([&] { heard = 2; }); });
    QCOMPARE(runner.title(), QString("new"));
    leave.release();
    QTRY_COMPARE(ends.ends.size(), std::size_t{2});
    QTRY_COMPARE(runner.windingDown(), 0);
    QCOMPARE(heard, 2);
}

void JobRunnerTest::progress_is_told_and_never_goes_back() {
    JobRunner runner;
    Ends ends(runner);
    std::vector<double> fractions;
    connect(&runner, &JobRunner::progressed, this,
            [&](double fraction, const QString&) { fractions.push_back(fraction); });
    runner.start("job", [](JobContext& job) {
        for (const double fraction : {0.0, 0.3, 0.2, 0.9}) {
            job.progress(fraction, "step");
            QThread::msleep(60); // longer than what lies between two reports
        }
    });
    QTRY_COMPARE(ends.ends.size(), std::size_t{1});
    QCOMPARE(fractions, (std::vector<double>{0.0, 0.3, 0.9}));
}

void JobRunnerTest::the_runner_can_go_while_a_job_runs() {
    std::atomic<bool> stopped = false;
    {
        JobRunner runner;
        QSemaphore inside;
        runner.start("job", [&](JobContext& job) {
            inside.release();
            while (!job.stop_requested()) {
                QThread::msleep(1);
            }
            job.post([] { QFAIL("nobody is there any more"); });
            stopped = true;
        });
        inside.acquire();
    }
    QVERIFY(stopped);
}

QTEST_GUILESS_MAIN(JobRunnerTest)
#include "job_runner_test.moc"
