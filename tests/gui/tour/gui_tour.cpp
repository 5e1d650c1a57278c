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
#include <QStandardPaths>
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

/// A parallel view with a place in the middle.
Camera camera_at(const Vec3& focus, StandardView from, double height) {
    Camera camera = camera_of(from);
    camera.focus = focus;
    camera.height = height;
    return camera;
}

/// Sections 5.2 and figures 8-11: the wing.
void take_wing(const QString& mesh, const QString& folder) {
    Tour tour(folder);
    tour.open(mesh);
    tour.scene([](SceneOptions& o) { o.colour = ColourBy::aspect_ratio; });
    tour.save("window.png");
    tour.coarsen(4);
    tour.window().aspectRatioPanel().setPercent(true);
    tour.settle();
    tour.window().document().setCurrent(2);
    tour.scene([](SceneOptions& o) {
        o.colour = ColourBy::patch;
        o.legend = false;
        o.axes = false;
    });
    tour.window().setViewCount(2);
    tour.look(camera_at({-0.002, 0, 0}, StandardView::minus_y, 0.036));
    tour.save("compare.png");
    ChartPanel& histogram = tour.window().aspectRatioPanel();
    histogram.exportTo(folder + "/histogram.svg");

    tour.window().setViewCount(1);
    tour.window().document().setCurrent(0);
    tour.scene([](SceneOptions& o) {
        o.colour = ColourBy::aspect_ratio;
        o.legend = true;
        o.axes = true;
        o.clip.enabled = true;
        o.clip.normal = {0, -1, 0};
        o.clip.origin = {0, 0.6, 0};
    });
    tour.look(camera_at({0.45, 0.6, 0.0}, StandardView::minus_y, 0.5));
    tour.window().raisePanel(tour.window().viewPanel());
    tour.save("clip.png");
}

/// Dark colours, four views, and how multigrid converges.
void take_dark(const QString& mesh, const QString& folder) {
    Tour tour(folder);
    tour.open(mesh);
    tour.coarsen(3);
    tour.window().setDark(true);
    tour.window().setViewCount(4);
    tour.scene([](SceneOptions& o) {
        o.representation = Representation::surface_with_edges;
        o.colour = ColourBy::h1;
        o.legend = false;
        o.axes = false;
    });
    tour.window().convergencePanel().measure();
    wait_for("convergence", [&] { return !tour.window().convergencePanel().jobs().isRunning(); });
    tour.window().raisePanel(tour.window().convergencePanel());
    tour.save("dark.png");
    tour.window().setDark(false);
}

/// Section 5.1 and figure 7: the box, its short direction stretched.
void take_box(const QString& mesh, const QString& folder) {
    Tour tour(folder);
    tour.open(mesh);
    tour.coarsen(1);
    tour.window().setViewCount(2);
    tour.scene([](SceneOptions& o) { o.view_scale = {1, 1, 1000}; });
    tour.window().views().standardView(StandardView::corner);
    tour.window().views().resetCamera();
    tour.window().raisePanel(tour.window().viewPanel());
    tour.save("scaled.png");
}

/// Figure 3: the unit balls of four means at a node of a wall that turns.
void take_means(const QString& mesh, const QString& folder) {
    Tour tour(folder);
    tour.open(mesh);
    tour.scene([](SceneOptions& o) {
        o.ellipsoids.where = EllipsoidOptions::Where::picked;
        o.ellipsoids.scale = 1;
        o.colour = ColourBy::none;
    });
    const auto& level = *tour.window().document().current();
    NodeId most; // the node with the most elements stands where the wall turns
    std::visit(
        [&]<int D>(const Level<D>& l) {
            double nearest = 1e300;
            for (const NodeId v : l.mesh.points.ids()) {
                const double d = l.mesh.points[v].norm();
                if (d < nearest) {
                    nearest = d;
                    most = v;
                }
            }
        },
        *level.level);
    emit tour.window().inspectorPanel().nodeRequested(most.value());
    wait_for("the node", [&] { return tour.window().inspectorPanel().inspection().has_value(); });
    // Along the short direction the balls are a thousandth of their width.
    const Inspection node = *tour.window().inspectorPanel().inspection();
    tour.scene([&](SceneOptions& o) {
        o.lens.enabled = true;
        o.lens.origin = {node.point[0], node.point[1], 0};
        o.lens.normal = {node.directions[0][0], node.directions[0][1], 0};
        o.lens.factor = node.aspect_ratio;
        o.axes = false;
    });
    emit tour.window().viewPanel().meansSideBySideRequested(true);
    tour.look(camera_at({node.point[0], node.point[1], 0}, StandardView::plus_z, 4));
    tour.window().raisePanel(tour.window().inspectorPanel());
    tour.save("means.png");
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fprintf(stderr,
                     "usage: gui_tour M6_MESH BOX_MESH MODEL_LAYER_MESH SMALL_M6_MESH FOLDER\n");
        return 2;
    }
    VtkWidget::setDefaultFormat();
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("ameco-tour");
    QStandardPaths::setTestModeEnabled(true);
    apply_theme(application, false);
    take_wing(argv[1], argv[5]);
    take_dark(argv[4], argv[5]);
    take_box(argv[2], argv[5]);
    take_means(argv[3], argv[5]);
    return 0;
}
