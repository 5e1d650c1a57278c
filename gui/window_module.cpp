// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The module's only visible symbol: the application, its windows, and its event loop.
#include "core/base/parallel.h"
#include "gui/main_window.h"
#include "gui/panels/coarsen_panel.h"
#include "gui/theme.h"
#include "gui/view/vtk_widget.h"
#include "gui/window_job.h"

#include <QApplication>
#include <QIcon>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <vector>

namespace ameco::gui {
namespace {

/// Qt ends the program where it finds no screen; one line of ours says so.
void handle_qt_message(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type == QtFatalMsg) {
        std::fprintf(stderr,
                     "ameco: error: the window cannot be opened: %s\n"
                     "ameco: all commands but this one work without a screen (ameco --help)\n",
                     qPrintable(text.simplified()));
        std::_Exit(static_cast<int>(ExitCode::not_built));
    }
    if (type != QtDebugMsg && type != QtInfoMsg) {
        std::fprintf(stderr, "%s\n", qPrintable(text));
    }
}

int run_application(const WindowJob& job) {
    qInstallMessageHandler(handle_qt_message);
    VtkWidget::setDefaultFormat();
    static int count = 1;
    static char name[] = "ameco";
    static char* arguments[] = {name, nullptr};
    QApplication application(count, arguments);
    std::setlocale(LC_NUMERIC, "C"); // 0.5 stays 0.5 in files
    QCoreApplication::setApplicationName(QStringLiteral("ameco"));
    QCoreApplication::setOrganizationName(QStringLiteral("ameco"));
    QCoreApplication::setApplicationVersion(QStringLiteral(AMECO_VERSION));
    QGuiApplication::setDesktopFileName(QStringLiteral("ameco"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/ameco/icon.png")));
    apply_theme(application, job.dark);
    std::vector<std::unique_ptr<MainWindow>> windows;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, job.files.size()); ++i) {
        windows.push_back(std::make_unique<MainWindow>());
        MainWindow& window = *windows.back();
        window.coarsenPanel().setThreads(job.threads);
        if (job.dark) {
            window.setDark(true);
        }
        window.show();
        if (i < job.files.size()) {
            window.openPath(QString::fromStdString(job.files[i]));
        }
    }
    return QApplication::exec();
}

} // namespace
} // namespace ameco::gui

extern "C" __attribute__((visibility("default"))) void
ameco_open_window(const ameco::gui::WindowJob& job, ameco::gui::WindowResult& result) {
    using ameco::ExitCode;
    try {
        ameco::set_thread_count(job.threads);
        if (ameco::gui::run_application(job) != 0) {
            result.code = ExitCode::internal;
        }
    } catch (const ameco::Error& error) {
        result.code = error.code();
        result.error = error.what();
    } catch (const std::bad_alloc&) {
        result.code = ExitCode::memory;
        result.error = "not enough memory for the window";
    } catch (const std::exception& error) {
        result.code = ExitCode::internal;
        result.error = std::string("internal error: ") + error.what();
    }
}
