// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/error.h"
#include "gui/main_window.h"
#include "gui/model/patch_model.h"
#include "gui/panels/chart_panel.h"
#include "gui/panels/coarsen_panel.h"
#include "gui/panels/view_panel.h"
#include "gui/view/compare_view.h"
#include "gui/view_controller.h"

#include <QFileInfo>

namespace ameco::gui {

void MainWindow::openSession(const QString& path) {
    try {
        session_ = read_session(path.toStdString());
    } catch (const Error& error) {
        tell(Severity::error, QString::fromUtf8(error.what()));
        return;
    }
    session_path_ = QFileInfo(path).absoluteFilePath();
    const Session wanted =
        *session_; // a job that is running is cancelled, and its session forgotten
    jobs_.cancel();
    session_ = wanted;
    document_.openStored(QString::fromStdString(wanted.mesh), wanted.levels);
}

Session MainWindow::currentSession() const {
    Session session;
    session.mesh = document_.file().path;
    session.current = document_.current() != nullptr ? document_.current()->id : 0;
    session.shown.clear();
    for (int v = 0; v < views_->viewCount(); ++v) {
        session.shown.push_back(controller_->shownLevel(v));
    }
    session.camera = views_->view(0).camera();
    session.scene = controller_->options();
    session.options = coarsen_->options();
    session.threads = coarsen_->threads();
    session.percent = aspect_ratios_->chart().chart().percent;
    session.logarithmic = aspect_ratios_->chart().chart().logarithmic;
    return session;
}

void MainWindow::saveSessionTo(const QString& path) {
    if (!document_.isOpen()) {
        return;
    }
    const Session session = currentSession();
    jobs_.start(tr("Saving the session"), [this, path, session, file = document_.file(),
                                           levels = document_.levels()](JobContext& job) {
        save_session(path.toStdString(), session, file, levels, job);
        job.post([this, path] {
            session_path_ = QFileInfo(path).absoluteFilePath();
            remember(session_path_);
            tell(Severity::info, tr("written: %1").arg(path));
        });
    });
}

void MainWindow::restore(const Session& session) {
    coarsen_->setOptions(session.options);
    coarsen_->setThreads(session.threads);
    patches_->setFrozen(session.options.coarsen.features.frozen_patches);
    for (ChartPanel* const panel : {aspect_ratios_, qualities_, lengths_}) {
        panel->setPercent(session.percent);
        panel->setLogarithmic(session.logarithmic);
    }
    document_.setCurrent(session.current);
    setViewCount(static_cast<int>(session.shown.size()));
    for (std::size_t v = 0; v < session.shown.size(); ++v) {
        controller_->showLevel(static_cast<int>(v), session.shown[v]);
    }
    if (session.scene.dark != controller_->options().dark) {
        setDark(session.scene.dark);
    }
    changeScene(session.scene);
    views_->setCamera(session.camera);
}

} // namespace ameco::gui
