// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/main_window.h"

#include "core/cases/cases.h"
#include "core/io/io.h"
#include "gui/dialogs/shortcuts_dialog.h"
#include "gui/model/patch_model.h"
#include "gui/panels/chart_panel.h"
#include "gui/panels/coarsen_panel.h"
#include "gui/panels/command_panel.h"
#include "gui/panels/convergence_panel.h"
#include "gui/panels/hierarchy_panel.h"
#include "gui/panels/inspector_panel.h"
#include "gui/panels/log_panel.h"
#include "gui/panels/patch_panel.h"
#include "gui/panels/view_panel.h"
#include "gui/view/compare_view.h"
#include "gui/view/vtk_widget.h"
#include "gui/view_controller.h"
#include "tests/support/picture.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QGroupBox>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

using namespace ameco;
using namespace ameco::gui;

namespace {

constexpr int patience = 120'000; ///< [ms]; only a failing test waits so long

QString sample(const char* name) {
    return QString(AMECO_SOURCE_DIR) + "/sample_meshes/" + name;
}

/// The real window, and what a person does with it.
struct Window : MainWindow {
    Window() {
        resize(1200, 800);
        show();
    }
    bool exposed() { return QTest::qWaitForWindowExposed(this); }
    bool idle() {
        return QTest::qWaitFor([this] { return !jobs().isRunning(); }, patience);
    }
    bool open(const QString& path) {
        openPath(path);
        return idle() && document().isOpen() && drawn();
    }
    bool coarsen(int levels) {
        qobject_cast<QSpinBox*>(coarsenPanel().editor("levels"))->setValue(levels);
        QTest::mouseClick(&coarsenPanel().runButton(), Qt::LeftButton);
        return idle() && drawn();
    }
    /// Waits until a frame later than this moment has been drawn.
    bool drawn(int view = 0) {
        MeshView& widget = views().view(view);
        const int before = widget.renderCount();
        widget.setOptions(widget.options());
        return QTest::qWaitFor([&] { return widget.renderCount() > before; }, patience);
    }
    QImage picture(int view = 0) { return views().view(view).grabImage(); }
    /// Share of the view's pixels that are not background.
    double covered(int view = 0) { return test::share_not_background(picture(view)); }
    /// Clicks where a node is seen.
    void click(NodeId node, int view = 0) {
        MeshView& widget = views().view(view);
        const auto [x, y] = widget.scene().pixel_of(widget.scene().data()->position(node));
        const double ratio = widget.devicePixelRatioF();
        const QPoint place(qRound(x / ratio), qRound(widget.height() - 1 - y / ratio));
        QTest::mouseClick(widget.focusProxy(), Qt::LeftButton, {}, place);
    }
};

double difference(const QImage& a, const QImage& b) {
    qint64 count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            count += test::near_colour(a.pixelColor(x, y), b.pixelColor(x, y), 12) ? 0 : 1;
        }
    }
    return static_cast<double>(count) / (static_cast<double>(a.width()) * a.height());
}

} // namespace

class MainWindowTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void opens_and_shows_a_mesh();
    void opens_by_the_dialog();
    void opens_by_dropping_a_file();
    void a_broken_file_is_told_and_nothing_is_lost();
    void a_mesh_is_seen_before_it_is_measured();
    void a_surface_without_volume_can_be_shown_in_all_ways();
    void a_clip_plane_takes_a_part_away();
    void a_hidden_patch_is_not_seen();
    void picking_a_node_tells_all_about_it();
    void makes_two_levels_and_compares_them();
    void a_frozen_patch_stays_as_it_is();
    void the_prediction_follows_the_settings();
    void cancelling_keeps_what_is_finished();
    void brushing_lights_up_nodes();
    void selected_patches_are_counted_in_the_histogram();
    void the_lens_stretches_the_layers_and_says_so();
    void measures_how_multigrid_converges();
    void means_stand_side_by_side();
    void exports_what_is_seen();
    void a_session_comes_back();
    void closes_while_a_job_runs();
    void every_action_has_its_place_in_the_cheat_sheet();
    void dark_is_dark();
};

void MainWindowTest::initTestCase() {
    QCoreApplication::setOrganizationName("ameco-test");
    QCoreApplication::setApplicationName("main_window_test");
    QStandardPaths::setTestModeEnabled(true);
}

void MainWindowTest::opens_and_shows_a_mesh() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY2(w.views().hasOpenGL(), "this test needs OpenGL");
    const double empty = w.drawn() ? w.covered() : 1;
    QVERIFY(w.open(sample("layer.meshb")));
    QVERIFY(w.windowTitle().startsWith("layer.meshb"));
    QVERIFY2(w.covered() > empty + 0.1, qPrintable(QString::number(w.covered())));
    QCOMPARE(w.hierarchyPanel().table().model()->rowCount(), 1);
    QVERIFY(!w.aspectRatioPanel().chart().chart().series.empty());
    QVERIFY(w.commandPanel().command().startsWith("ameco info "));
}

void MainWindowTest::opens_by_the_dialog() {
    Window w;
    QVERIFY(w.exposed());
    for (QAction* action : w.menuBar()->actions()[0]->menu()->actions()) {
        if (action->shortcut() == QKeySequence::Open) {
            action->trigger();
        }
    }
    auto* const dialog = w.findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr);
    QVERIFY(dialog->nameFilters()[0].contains("*.meshb"));
    QVERIFY(dialog->nameFilters()[0].contains("*.su2"));
    emit dialog->fileSelected(sample("box.mesh"));
    dialog->close();
    QVERIFY(w.idle());
    QVERIFY(w.document().isOpen());
}

void MainWindowTest::opens_by_dropping_a_file() {
    Window w;
    QVERIFY(w.exposed());
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(sample("layer_2d.meshb"))});
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&w.views().view(0), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&w.views().view(0), &drop);
    QVERIFY(w.idle());
    QCOMPARE(w.document().file().dimension, 2);
}

void MainWindowTest::a_broken_file_is_told_and_nothing_is_lost() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    const QTemporaryDir folder;
    QFile broken(folder.filePath("broken.meshb"));
    QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("this is no mesh") > 0);
    broken.close();
    w.openPath(broken.fileName());
    QVERIFY(w.idle());
    QVERIFY2(w.logPanel().toPlainText().contains("error: " + broken.fileName()),
             qPrintable(w.logPanel().toPlainText()));
    QVERIFY(w.windowTitle().startsWith("layer.meshb"));
    QCOMPARE(w.document().levels().size(), std::size_t{1});
    QVERIFY(w.coarsen(1)); // and work goes on
    QCOMPARE(w.document().levels().size(), std::size_t{2});
}

void MainWindowTest::a_mesh_is_seen_before_it_is_measured() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    const auto layer = w.views().view(0).scene().data();
    std::size_t seen = 0;
    connect(&w.document(), &Document::sketched, &w, [&] {
        seen = w.views().view(0).scene().data()->node_count;
        w.jobs().cancel();
    });
    w.openPath(sample("m6_8k.meshb"));
    QVERIFY(w.idle());
    QVERIFY(seen > 8000);
    // It was cancelled: what was open before is shown again.
    QCOMPARE(w.views().view(0).scene().data(), layer);
    QVERIFY(w.windowTitle().startsWith("layer.meshb"));
}

void MainWindowTest::a_surface_without_volume_can_be_shown_in_all_ways() {
    const QTemporaryDir folder;
    QFile file(folder.filePath("corner.mesh"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n"
               "0 0 1 1\nTriangles 4\n1 3 2 1\n1 2 4 1\n1 4 3 2\n2 3 4 2\nEnd\n");
    file.close();
    Window w;
    QVERIFY(w.exposed());
    QVERIFY2(w.open(file.fileName()), qPrintable(w.logPanel().toPlainText()));
    for (int colour = 0; colour < w.viewPanel().colourBox().count(); ++colour) {
        w.viewPanel().colourBox().setCurrentIndex(colour);
        QVERIFY(w.idle() && w.drawn());
        QVERIFY2(w.covered() > 0.02, qPrintable(w.viewPanel().colourBox().currentText()));
    }
    w.viewPanel().clipAcross(0);
    QVERIFY(w.drawn());
    QTest::mouseClick(w.views().view(0).focusProxy(), Qt::LeftButton, {},
                      w.views().view(0).rect().center());
    QVERIFY(w.drawn());
    QVERIFY(!w.coarsenPanel().runButton().isEnabled());
}

void MainWindowTest::a_clip_plane_takes_a_part_away() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    w.views().standardView(StandardView::plus_z);
    w.views().resetCamera();
    QVERIFY(w.drawn());
    const double before = w.covered();
    w.viewPanel().clipAcross(0);
    QVERIFY(w.drawn());
    const double after = w.covered();
    QVERIFY2(after < 0.85 * before && after > 0.2 * before,
             qPrintable(QString("%1 -> %2").arg(before).arg(after)));
    w.viewPanel().clipBox().setChecked(false);
    QVERIFY(w.drawn());
    QVERIFY(std::abs(w.covered() - before) < 0.01);
}

void MainWindowTest::a_hidden_patch_is_not_seen() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    const double before = w.covered();
    QAbstractItemModel& patches = w.patches();
    for (int row = 0; row < patches.rowCount(); ++row) {
        patches.setData(patches.index(row, PatchModel::visible), Qt::Unchecked, Qt::CheckStateRole);
    }
    QVERIFY(w.drawn());
    QVERIFY(w.covered() < before / 2);
    w.patchPanel().showAll();
    QVERIFY(w.drawn());
    QVERIFY(std::abs(w.covered() - before) < 0.02);
}

void MainWindowTest::picking_a_node_tells_all_about_it() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("box.mesh")));
    QVERIFY(w.coarsen(1));
    w.document().setCurrent(0);
    w.views().standardView(StandardView::corner);
    QVERIFY(w.drawn());
    // A node of the boundary that is seen: pick in the middle of the view.
    MeshView& view = w.views().view(0);
    QTest::mouseClick(view.focusProxy(), Qt::LeftButton, {}, view.rect().center());
    QTRY_VERIFY(w.inspectorPanel().inspection().has_value());
    const Inspection& i = *w.inspectorPanel().inspection();
    QCOMPARE(i.level_id, 0);
    QVERIFY(i.means.size() >= 4);
    QVERIFY(!i.patches.empty());
    QCOMPARE(i.point[0], view.scene().data()->position(i.node)[0]);
    QVERIFY(w.inspectorPanel().text().contains("Level 1"));
    // And about the tet that was hit.
    QVERIFY(i.element.has_value());
    QCOMPARE(i.element->nodes.size(), std::size_t{4});
    QVERIFY(std::count(i.element->nodes.begin(), i.element->nodes.end(), i.node.value()) == 1);
    QVERIFY(i.element->volume > 0 && i.element->quality > 0 && i.element->quality <= 1);
    QVERIFY(w.inspectorPanel().text().contains(QString("Element %1").arg(i.element->id.value())));
    w.inspectorPanel().copy();
    QVERIFY(QGuiApplication::clipboard()->text().contains("aspect ratio"));
    QVERIFY(QGuiApplication::clipboard()->text().contains("element "));
    // The same node by its number.
    const int node = i.node.value();
    emit w.inspectorPanel().nodeRequested(node + 1);
    QTRY_COMPARE(w.inspectorPanel().inspection()->node.value(), node + 1);
    QVERIFY(!w.inspectorPanel().inspection()->element.has_value());
}

void MainWindowTest::makes_two_levels_and_compares_them() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    QVERIFY(w.coarsen(2));
    QCOMPARE(w.document().levels().size(), std::size_t{3});
    QCOMPARE(w.hierarchyPanel().table().model()->rowCount(), 3);
    QVERIFY(w.commandPanel().command().startsWith("ameco coarsen "));
    QVERIFY(w.commandPanel().command().contains("--levels 2"));
    const auto& series = w.aspectRatioPanel().chart().chart().series;
    QVERIFY(series.size() >= 3);
    w.setViewCount(2);
    QTRY_VERIFY(w.views().view(1).renderCount() > 0);
    QCOMPARE(w.viewController().shownLevel(0), 0);
    QCOMPARE(w.viewController().shownLevel(1), 2);
    QVERIFY(w.drawn(1));
    QVERIFY(w.covered(1) > 0.1);
    // Cameras are linked: turning one turns the other.
    const Camera before = w.views().view(1).camera();
    MeshView& left = w.views().view(0);
    const QPoint middle = left.rect().center();
    QTest::mousePress(left.focusProxy(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(left.focusProxy(), middle + QPoint(60, 30));
    QTest::mouseRelease(left.focusProxy(), Qt::LeftButton, {}, middle + QPoint(60, 30));
    QTRY_VERIFY(!(w.views().view(1).camera() == before));
}

void MainWindowTest::a_frozen_patch_stays_as_it_is() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    PatchModel& patches = w.patches();
    patches.setData(patches.index(0, PatchModel::frozen), Qt::Checked, Qt::CheckStateRole);
    const int patch = patches.patchOf(0);
    QCOMPARE(w.coarsenPanel().options().coarsen.features.frozen_patches, std::vector<int>{patch});
    QVERIFY(w.coarsen(1));
    const auto faces = [&](int id) {
        const auto& ids = w.document().level(id)->scene->triangle_patch;
        return std::count(ids.begin(), ids.end(), patch);
    };
    QVERIFY(faces(0) > 0);
    QCOMPARE(faces(1), faces(0));
    QVERIFY(w.commandPanel().command().contains(QString("--freeze %1").arg(patch)));
}

void MainWindowTest::the_prediction_follows_the_settings() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    QTRY_VERIFY_WITH_TIMEOUT(w.coarsenPanel().predictionText().contains("predicted"), patience);
    const QString before = w.coarsenPanel().predictionText();
    qobject_cast<QDoubleSpinBox*>(w.coarsenPanel().editor("factor"))->setValue(2.6);
    QTRY_VERIFY_WITH_TIMEOUT(w.coarsenPanel().predictionText() != before, patience);
    QVERIFY(w.coarsenPanel().predictionText().contains("2.6"));
    const auto& series = w.aspectRatioPanel().chart().chart().series;
    QVERIFY(series.back().hollow);
}

void MainWindowTest::cancelling_keeps_what_is_finished() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("m6_8k.meshb")));
    qobject_cast<QSpinBox*>(w.coarsenPanel().editor("levels"))->setValue(5);
    QTest::mouseClick(&w.coarsenPanel().runButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(w.document().levels().size() >= 2, patience);
    QVERIFY(w.jobs().isRunning());
    QElapsedTimer timer;
    timer.start();
    QTest::mouseClick(&w.coarsenPanel().cancelButton(), Qt::LeftButton);
    QVERIFY(!w.jobs().isRunning());
    QVERIFY2(timer.elapsed() < 200, qPrintable(QString::number(timer.elapsed())));
    const std::size_t kept = w.document().levels().size();
    QVERIFY(w.coarsenPanel().runButton().isEnabled());
    QTRY_COMPARE_WITH_TIMEOUT(w.jobs().windingDown(), 0, patience);
    QCOMPARE(w.document().levels().size(), kept);
    QVERIFY(kept >= 2 && kept < 6);
    QVERIFY(w.logPanel().toPlainText().contains("cancelled"));
}

void MainWindowTest::brushing_lights_up_nodes() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    const QImage before = w.picture();
    ChartWidget& chart = w.aspectRatioPanel().chart();
    const int last = chart.chart().classCount() - 1;
    QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.classBox(last).center().toPoint());
    // The last class of the chart is class 0 of the statistics: the most stretched nodes.
    QCOMPARE(static_cast<std::int64_t>(w.viewController().highlightedCount()),
             w.document().current()->statistics.classes.counts[0]);
    QVERIFY(w.drawn());
    QVERIFY2(difference(before, w.picture()) > 0.001, "nothing lights up");
    QTest::keyClick(&chart, Qt::Key_Escape);
    QCOMPARE(w.viewController().highlightedCount(), std::size_t{0});
    QVERIFY(w.drawn());
    QVERIFY(difference(before, w.picture()) < 0.001);
}

void MainWindowTest::selected_patches_are_counted_in_the_histogram() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    const auto before = w.aspectRatioPanel().chart().chart().series.size();
    w.patchPanel().table().selectRow(0);
    const Chart& chart = w.aspectRatioPanel().chart().chart();
    QCOMPARE(chart.series.size(), before + 1);
    const auto& counts = chart.series.back().values;
    const auto nodes = nodes_of_patches(*w.document().current(), w.patchPanel().selectedPatches());
    QVERIFY(!nodes.empty());
    QCOMPARE(std::accumulate(counts.begin(), counts.end(), 0.0), static_cast<double>(nodes.size()));
}

void MainWindowTest::the_lens_stretches_the_layers_and_says_so() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    QVERIFY(w.views().view(0).scene().scale_label().empty());
    MeshView& view = w.views().view(0);
    QTest::mouseClick(view.focusProxy(), Qt::LeftButton, {}, view.rect().center());
    QTRY_VERIFY(w.viewController().picked().has_value());
    const QImage before = w.picture();
    SceneOptions options = w.viewController().options();
    options.lens.factor = 20;
    emit w.viewPanel().optionsChanged(options);
    emit w.viewPanel().lensAtPickRequested();
    QVERIFY(w.drawn());
    QVERIFY(w.viewController().options().lens.enabled);
    QVERIFY(w.viewController().options().lens.origin ==
            w.viewController().picked()->pick->position);
    QVERIFY(!view.scene().scale_label().empty());
    QVERIFY(difference(before, w.picture()) > 0.02);
}

void MainWindowTest::measures_how_multigrid_converges() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    w.convergencePanel().measure();
    QVERIFY(!w.convergencePanel().jobs().isRunning()); // there is one level only
    QVERIFY(w.coarsen(1));
    w.convergencePanel().measure();
    QTRY_COMPARE_WITH_TIMEOUT(w.convergencePanel().chart().chart().series.size(), std::size_t{2},
                              patience);
    for (const ChartSeries& s : w.convergencePanel().chart().chart().series) {
        QCOMPARE(s.values.front(), 1.0);
        QVERIFY(s.values.back() < 1e-8);
    }
}

void MainWindowTest::means_stand_side_by_side() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("model_layer.mesh")));
    SceneOptions options = w.viewController().options();
    options.ellipsoids.where = EllipsoidOptions::Where::picked;
    emit w.viewPanel().optionsChanged(options);
    emit w.inspectorPanel().nodeRequested(2);
    emit w.viewPanel().meansSideBySideRequested(true);
    QCOMPARE(w.views().viewCount(), 4);
    std::set<std::string> captions;
    std::set<Mean> means;
    for (int v = 0; v < 4; ++v) {
        QVERIFY(w.drawn(v));
        captions.insert(w.views().view(v).scene().data()->name());
        means.insert(w.views().view(v).options().ellipsoids.mean);
        QCOMPARE(w.views().view(v).scene().shown_ellipsoids(), std::size_t{1});
    }
    QCOMPARE(captions.size(), std::size_t{4});
    QCOMPARE(means.size(), std::size_t{4});
    w.setViewCount(1);
    QVERIFY(w.drawn());
    QCOMPARE(w.views().view(0).scene().data()->name(), std::string("level 0"));
}

void MainWindowTest::exports_what_is_seen() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    const QTemporaryDir folder;
    for (const char* name : {"h.png", "h.svg", "h.csv"}) {
        w.aspectRatioPanel().exportTo(folder.filePath(name));
        QVERIFY2(QFileInfo(folder.filePath(name)).size() > 100, name);
    }
    w.saveScreenshot(folder.filePath("view.png"), 2, false);
    const QImage image(folder.filePath("view.png"));
    QCOMPARE(image.size(), w.views().size() * 2 * w.devicePixelRatio());
    QVERIFY(test::share_not_background(image) > 0.1);
    w.document().exportMesh(0, folder.filePath("level.su2"));
    QVERIFY(w.idle());
    QCOMPARE(std::get<0>(read_mesh(folder.filePath("level.su2").toStdString()).mesh).points.size(),
             static_cast<std::size_t>(w.document().current()->statistics.nodes));
}

void MainWindowTest::a_session_comes_back() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("my work.ameco");
    SceneOptions scene;
    Camera camera;
    QImage picture;
    {
        Window w;
        QVERIFY(w.exposed());
        QVERIFY(w.open(sample("layer.meshb")));
        QVERIFY(w.coarsen(2));
        w.document().setCurrent(1);
        qobject_cast<QDoubleSpinBox*>(w.coarsenPanel().editor("factor"))->setValue(1.7);
        QVERIFY(w.coarsen(1)); // a branch
        w.viewPanel().clipAcross(1);
        w.viewPanel().colourBox().setCurrentIndex(2);
        w.views().standardView(StandardView::plus_x);
        w.setViewCount(2);
        scene = w.viewController().options();
        camera = w.views().view(0).camera();
        QVERIFY(w.drawn(1));
        picture = w.picture(1);
        w.saveSessionTo(file);
        QVERIFY(w.idle());
    }
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(file));
    QVERIFY2(!w.logPanel().toPlainText().contains("warning"),
             qPrintable(w.logPanel().toPlainText()));
    QCOMPARE(w.document().levels().size(), std::size_t{4});
    QCOMPARE(w.document().current()->id, 3);
    QCOMPARE(w.document().branch(3).size(), std::size_t{3});
    QVERIFY(w.viewController().options() == scene);
    QCOMPARE(w.views().viewCount(), 2);
    QVERIFY(w.views().view(0).camera() == camera);
    QCOMPARE(w.coarsenPanel().options().coarsen.target.factor, 1.7);
    QVERIFY(w.drawn(1));
    QVERIFY2(difference(w.picture(1), picture) < 0.02,
             qPrintable(QString::number(difference(w.picture(1), picture))));
}

void MainWindowTest::closes_while_a_job_runs() {
    auto w = std::make_unique<Window>();
    QVERIFY(w->exposed());
    QVERIFY(w->open(sample("m6_8k.meshb")));
    QTest::mouseClick(&w->coarsenPanel().runButton(), Qt::LeftButton);
    QVERIFY(w->jobs().isRunning());
    QElapsedTimer timer;
    timer.start();
    QVERIFY(w->close());
    QVERIFY(!w->isVisible());
    QVERIFY(timer.elapsed() < 500);
    w.reset(); // waits for the worker, which stops soon
    QVERIFY2(timer.elapsed() < 20'000, qPrintable(QString::number(timer.elapsed())));
}

void MainWindowTest::every_action_has_its_place_in_the_cheat_sheet() {
    const Window w;
    const QString sheet = shortcuts_html(*w.menuBar());
    for (const char* key : {"Ctrl+O", "Ctrl+S", "Ctrl+R", "Ctrl+G", "F", "PgDown", "Shift+X"}) {
        QVERIFY2(sheet.contains(QString("<b>%1</b>").arg(key)), key);
    }
    // No shortcut means two things.
    QStringList keys;
    for (const QAction* action : w.findChildren<QAction*>()) {
        if (!action->shortcut().isEmpty()) {
            keys << action->shortcut().toString();
        }
    }
    const qsizetype all = keys.size();
    keys.removeDuplicates();
    QCOMPARE(keys.size(), all);
    QVERIFY(all > 30);
}

void MainWindowTest::dark_is_dark() {
    Window w;
    QVERIFY(w.exposed());
    QVERIFY(w.open(sample("layer.meshb")));
    w.setDark(true);
    QVERIFY(w.drawn());
    QVERIFY(w.picture().pixelColor(2, 2).lightness() < 100);
    QVERIFY(w.grab().toImage().pixelColor(3, 3).lightness() < 100);
    w.setDark(false);
    QVERIFY(w.drawn());
    QVERIFY(w.picture().pixelColor(2, 2).lightness() > 150);
}

int main(int argc, char** argv) {
    VtkWidget::setDefaultFormat();
    QApplication application(argc, argv);
    MainWindowTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "main_window_test.moc"
