// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Takes the pictures of docs/user/gui_tour.md: drives the real window and saves what it shows.
/// Run by scripts/make-gui-pictures, under Xvfb.
#include "gui/main_window.h"
#include "gui/model/patch_model.h"
#include "gui/panels/chart_panel.h"
#include "gui/panels/coarsen_panel.h"
#include "gui/panels/convergence_panel.h"
#include "gui/panels/inspector_panel.h"
#include "gui/panels/view_panel.h"
#include "gui/theme.h"
#include "gui/view/compare_view.h"
#include "gui/view/vtk_widget.h"
#include "gui/view_controller.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QPushButton>
#include <QTest>

#include <cstdio>
#include <functional>

using namespace ameco;
using namespace ameco::gui;

namespace {

/// Waits, with the events going on; ends the program when it takes too long.
void wait_for(const char* what, const std::function<bool()>& done) {
    if (!QTest::qWaitFor(done, 300'000)) {
        std::fprintf(stderr, "gui_tour: waited in vain for %s\n", what);
        std::exit(1);
    }
}

class Tour {
public:
    explicit Tour(QString folder) : folder_(std::move(folder)) {
        window_.resize(1440, 900);
        window_.show();
        wait_for("the window", [&] { return window_.isVisible(); });
    }

    void open(const QString& mesh) {
        window_.openPath(mesh);
        wait_for("the mesh", [&] { return window_.document().isOpen() && idle(); });
        settle();
    }
    void coarsen(int levels) {
        HierarchyOptions options = window_.coarsenPanel().options();
        options.levels = levels;
        window_.coarsenPanel().setOptions(options);
        window_.coarsenPanel().runButton().click();
        wait_for("the levels", [&] { return idle(); });
        settle();
    }
    void scene(const std::function<void(SceneOptions&)>& change) {
        SceneOptions options = window_.viewController().options();
        change(options);
        emit window_.viewPanel().optionsChanged(options);
        settle();
        wait_for("the job", [&] { return idle(); });
    }
    void look(const Camera& camera) {
        window_.views().setCamera(camera);
        settle();
    }
    void save(const QString& name) {
        settle();
        save_widget(window_, name);
    }
    void save_views(const QString& name) {
        settle();
        window_.views().grabImage(1).save(folder_ + "/" + name);
    }
    void save_widget(QWidget& widget, const QString& name) {
        const QImage image = widget.grab().toImage();
        image.convertToFormat(QImage::Format_RGB888).save(folder_ + "/" + name, "PNG", 0);
        std::printf("%s\n", qPrintable(name));
    }
    /// Until the views are drawn and predictions are in.
    void settle() {
        QElapsedTimer timer;
        timer.start();
        int quiet = 0;
        int before = -1;
        wait_for("a still window", [&] {
            int renders = 0;
            for (int v = 0; v < window_.views().viewCount(); ++v) {
                renders += window_.views().view(v).renderCount();
            }
            quiet = renders == before ? quiet + 1 : 0;
            before = renders;
            return quiet > 30 && timer.elapsed() > 400;
        });
    }
    [[nodiscard]] bool idle() { return !window_.jobs().isRunning(); }
    [[nodiscard]] MainWindow& window() { return window_; }

private:
    MainWindow window_;
    QString folder_;
};

} // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: gui_tour M6_MESH BOX_MESH FOLDER\n");
        return 2;
    }
    VtkWidget::setDefaultFormat();
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("ameco-tour");
    apply_theme(application, false);
    Tour tour(argv[3]);
    tour.open(argv[1]);
    tour.save("window.png");
    tour.coarsen(3);
    tour.save("levels.png");
    return 0;
}
