// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/jobs/job_runner.h"

#include "core/base/error.h"

#include <QThread>

#include <algorithm>
#include <new>
#include <utility>

namespace ameco::gui {
namespace {

/// More often than this progress is not worth a repaint [ms].
constexpr qint64 progress_interval = 50;

QString from_view(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// Runs the work; what it throws becomes an end and a reason.
std::pair<JobEnd, QString> run(const JobRunner::Work& work, JobContext& context) {
    try {
        work(context);
        return {JobEnd::done, QString()};
    } catch (const Cancelled&) {
        return {JobEnd::cancelled, QString()};
    } catch (const std::bad_alloc&) {
        return {JobEnd::failed,
                JobRunner::tr("not enough memory: close other programs, or use a smaller mesh")};
    } catch (const std::exception& error) {
        return {JobEnd::failed, QString::fromUtf8(error.what())};
    }
}

} // namespace

void JobContext::message(Severity severity, std::string_view text) {
    post([this, severity, words = from_view(text)] { emit runner_.said(severity, words); });
}

void JobContext::progress(double fraction, std::string_view step) {
    const bool first = last_fraction_ < 0;
    if (!first && (fraction <= last_fraction_ || since_progress_.elapsed() < progress_interval)) {
        return;
    }
    last_fraction_ = std::max(fraction, 0.0);
    since_progress_.restart();
    post([this, fraction, words = from_view(step)] { emit runner_.progressed(fraction, words); });
}

void JobContext::post(std::function<void()> action) {
    // The job's thread is waited for before the runner dies, so the runner is there.
    QMetaObject::invokeMethod(
        &runner_,
        [self = shared_from_this(), action = std::move(action)] {
            if (!self->closed_) {
                action();
            }
        },
        Qt::QueuedConnection);
}

JobRunner::~JobRunner() {
    if (current_) {
        current_->stop_ = true;
    }
    for (QThread* const thread : std::exchange(threads_, {})) {
        thread->disconnect(this);
        thread->wait();
        delete thread;
    }
}

void JobRunner::start(const QString& title, Work work) {
    cancel();
    title_ = title;
    current_ = std::shared_ptr<JobContext>(new JobContext(*this));
    QThread* const thread = QThread::create([context = current_, work = std::move(work)] {
        const auto [end, reason] = run(work, *context);
        context->post([context = context.get(), end = end, reason = reason] {
            context->runner_.close(end, reason);
        });
    });
    connect(thread, &QThread::finished, this, [this, thread] {
        threads_.erase(std::find(threads_.begin(), threads_.end(), thread));
        thread->deleteLater();
    });
    threads_.push_back(thread);
    emit started(title);
    thread->start();
}

int JobRunner::windingDown() const {
    return static_cast<int>(threads_.size()) - (isRunning() ? 1 : 0);
}

void JobRunner::cancel() {
    if (current_) {
        current_->stop_ = true;
        close(JobEnd::cancelled, QString());
    }
}

void JobRunner::close(JobEnd end, const QString& reason) {
    const std::shared_ptr<JobContext> job = std::exchange(current_, nullptr);
    job->closed_ = true;
    emit ended(end, reason);
}

} // namespace ameco::gui
