// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/cases.h"
#include "core/io/io.h"
#include "gui/main_window.h"
#include "gui/view/compare_view.h"
#include "gui/view/vtk_widget.h"
#include "tests/support/picture.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>

using namespace ameco;
using namespace ameco::gui;

/// Two million nodes, twelve million tets.
class LargeMeshTest : public QObject {
    Q_OBJECT
private slots:
    void is_opened_and_shown_while_the_window_lives();
};

void LargeMeshTest::is_opened_and_shown_while_the_window_lives() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("large.meshb");
    {
        const auto mesh = std::get<0>(make_case("cube", {{"n", "126"}}));
        QVERIFY(mesh.points.size() > 2'000'000);
        write_mesh(file.toStdString(), mesh);
    }
    MainWindow w;
    w.resize(1200, 800);
    w.show();
    QVERIFY(QTest::qWaitForWindowExposed(&w));
    MeshView& view = w.views().view(0);
    QTRY_VERIFY(view.renderCount() > 0);

    QElapsedTimer timer, since_event;
    timer.start();
    since_event.start();
    qint64 longest = 0; // between two turns of the event loop: how long the window is deaf
    qint64 seen = -1;
    connect(&view, &MeshView::rendered, &w,
            [&] { seen = seen < 0 && view.scene().data() != nullptr ? timer.elapsed() : seen; });
    w.openPath(file);
    QVERIFY(QTest::qWaitFor(
        [&] {
            longest = std::max(longest, since_event.restart());
            return !w.jobs().isRunning() && seen >= 0;
        },
        600'000));
    QVERIFY(w.document().isOpen());
    const auto seconds = [](qint64 ms) { return static_cast<double>(ms) / 1000; };
    qInfo("seen after %.1f s, measured after %.1f s; deaf for at most %.2f s", seconds(seen),
          seconds(timer.elapsed()), seconds(longest));
    QVERIFY(test::share_not_background(view.grabImage()) > 0.1);
    QCOMPARE(w.document().current()->statistics.nodes, std::int64_t{127 * 127 * 127});

    // Coarsening it is cancelled at once, however large it is.
    w.document().coarsen(0, {});
    QTest::qWait(0);
    timer.start();
    w.jobs().cancel();
    QVERIFY(timer.elapsed() < 200);
    QVERIFY(!w.jobs().isRunning());
}

int main(int argc, char** argv) {
    VtkWidget::setDefaultFormat();
    QApplication application(argc, argv);
    LargeMeshTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "large_mesh_test.moc"
