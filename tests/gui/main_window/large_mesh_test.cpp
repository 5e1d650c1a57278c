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
    w.openPath(file);
    QVERIFY(QTest::qWaitFor(
        [&] {
            longest = std::max(longest, since_event.restart());
            return !w.jobs().isRunning();
        },
        600'000));
    QVERIFY(w.document().isOpen());
    const int before = view.renderCount();
    const qint64 read = timer.elapsed();
    QTRY_VERIFY_WITH_TIMEOUT(view.renderCount() > before, 60'000);
    qInfo("open to picture %.1f s, of it reading and measuring %.1f s; deaf for at most %.2f s",
          static_cast<double>(timer.elapsed()) / 1000, static_cast<double>(read) / 1000,
          static_cast<double>(longest) / 1000);
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
