// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One core call on a worker thread; what it says comes back as queued signals.
#pragma once

#include "core/base/monitor.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

class QThread;

namespace ameco::gui {

/// How a job ended.
enum class JobEnd {
    done,
    cancelled,
    failed ///< threw; the reason is told
};

class JobRunner;

/// What a job sees of the window: a Monitor whose words travel to the GUI thread.
class JobContext : public Monitor, public std::enable_shared_from_this<JobContext> {
public:
    void message(Severity severity, std::string_view text) override;
    void progress(double fraction, std::string_view step) override;
    [[nodiscard]] bool stop_requested() const override { return stop_; }

    /// Runs `action` on the GUI thread, in the order of the posts; not at all when the job has been
    /// cancelled by then.
    void post(std::function<void()> action);

private:
    friend class JobRunner;
    explicit JobContext(JobRunner& runner) : runner_(runner) { since_progress_.start(); }

    JobRunner& runner_;
    std::atomic<bool> stop_ = false;
    bool closed_ = false; ///< GUI thread: nothing of this job is wanted any more
    QElapsedTimer since_progress_;
    double last_fraction_ = -1;
};

/// Runs one job at a time.
///
/// Cancelling answers at once: the job's posts and messages are no longer heard, and its thread,
/// which may be deep in a loop, is left to notice by itself. A new job may start meanwhile.
class JobRunner : public QObject {
    Q_OBJECT
public:
    using Work = std::function<void(JobContext&)>;

    explicit JobRunner(QObject* parent = nullptr) : QObject(parent) {}
    /// Cancels, and waits until all threads are gone.
    ~JobRunner() override;

    /// Starts a job; one that is running is cancelled first.
    /// \param title  what is done, for people: "Coarsening"
    void start(const QString& title, Work work);

    [[nodiscard]] bool isRunning() const { return current_ != nullptr; }
    [[nodiscard]] const QString& title() const { return title_; }
    /// Threads of cancelled jobs that have not noticed yet.
    [[nodiscard]] int windingDown() const;

public slots:
    void cancel();

signals:
    void started(const QString& title);
    void progressed(double fraction, const QString& step);
    void said(ameco::Severity severity, const QString& text);
    void ended(ameco::gui::JobEnd end, const QString& reason);

private:
    friend class JobContext;
    void close(JobEnd end, const QString& reason);

    std::shared_ptr<JobContext> current_;
    QString title_;
    std::vector<QThread*> threads_;
};

} // namespace ameco::gui
