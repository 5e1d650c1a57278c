// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/view/compare_view.h"

#include "core/cases/cases.h"

#include <QApplication>
#include <QLabel>
#include <QtTest>

using namespace ameco;
using namespace ameco::gui;

class NoOpenglTest : public QObject {
    Q_OBJECT
private slots:
    void says_so_and_keeps_working();
};

void NoOpenglTest::says_so_and_keeps_working() {
    CompareView view;
    view.setViewCount(2);
    view.show();
    QVERIFY(!view.hasOpenGL());
    const auto labels = view.findChildren<QLabel*>();
    QVERIFY(!labels.isEmpty() && labels.front()->text().contains("OpenGL"));
    SceneInput<3> input;
    input.mesh = std::make_shared<const Mesh<3>>(std::get<0>(make_case("cube", {{"n", "2"}})));
    view.setData(0, make_scene_data(std::move(input)));
    view.setData(1, view.view(0).scene().data());
    view.resetCamera();
    view.standardView(StandardView::plus_x);
    SceneOptions options = view.view(0).options();
    options.clip.enabled = true;
    view.view(0).setOptions(options);
    view.view(0).highlight({NodeId(1)});
    view.view(0).mark(NodeId(1));
    QVERIFY(view.grabImage(2, false).isNull());
    QCOMPARE(view.view(0).renderCount(), 0);
    QVERIFY(view.view(0).options().clip.enabled);
}

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen"); // Qt has no OpenGL widgets there
    QApplication application(argc, argv);
    NoOpenglTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "no_opengl_test.moc"
