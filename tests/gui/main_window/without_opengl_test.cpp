// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/main_window.h"

#include "gui/panels/chart_panel.h"
#include "gui/panels/coarsen_panel.h"
#include "gui/panels/hierarchy_panel.h"
#include "gui/panels/inspector_panel.h"
#include "gui/panels/log_panel.h"
#include "gui/view/compare_view.h"

#include <QApplication>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

using namespace ameco;
using namespace ameco::gui;

/// The window on a machine where Qt has no OpenGL: the platform `offscreen` is one.
class WithoutOpenglTest : public QObject {
    Q_OBJECT
private slots:
    void says_so();
    void tables_histograms_and_runs_work();
    void a_screenshot_is_refused_with_a_reason();
};

namespace {

struct Window : MainWindow {
    bool idle() {
        return QTest::qWaitFor([this] { return !jobs().isRunning(); }, 120'000);
    }
    bool open(const char* name) {
        openPath(QString(AMECO_SOURCE_DIR) + "/sample_meshes/" + name);
        return idle() && document().isOpen();
    }
};

} // namespace

void WithoutOpenglTest::says_so() {
    Window w;
    w.show();
    QVERIFY(!w.views().hasOpenGL());
    QVERIFY(w.logPanel().toPlainText().contains("OpenGL"));
}

void WithoutOpenglTest::tables_histograms_and_runs_work() {
    Window w;
    w.show();
    QVERIFY(w.open("layer.meshb"));
    qobject_cast<QSpinBox*>(w.coarsenPanel().editor("levels"))->setValue(2);
    w.coarsenPanel().runButton().click();
    QVERIFY(w.idle());
    QCOMPARE(w.hierarchyPanel().table().model()->rowCount(), 3);
    QVERIFY(w.aspectRatioPanel().chart().chart().series.size() >= 3);
    emit w.inspectorPanel().nodeRequested(5);
    QTRY_VERIFY(w.inspectorPanel().inspection().has_value());
    w.setViewCount(4);
    w.setDark(true);
}

void WithoutOpenglTest::a_screenshot_is_refused_with_a_reason() {
    Window w;
    w.show();
    QVERIFY(w.open("box.mesh"));
    const QTemporaryDir folder;
    w.saveScreenshot(folder.filePath("a.png"), 1, false);
    QVERIFY(!QFileInfo::exists(folder.filePath("a.png")));
    QVERIFY(w.logPanel().toPlainText().contains("no OpenGL here"));
}

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    WithoutOpenglTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "without_opengl_test.moc"
