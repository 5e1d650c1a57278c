// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/cases.h"
#include "gui/view/mesh_view.h"
#include "gui/view/vtk_widget.h"
#include "tests/support/picture.h"

#include <QApplication>
#include <QSignalSpy>
#include <QtTest>

using namespace ameco;
using namespace ameco::gui;

namespace {

std::shared_ptr<const SceneData> cube() {
    SceneInput<3> input;
    input.mesh = std::make_shared<const Mesh<3>>(std::get<0>(make_case("cube", {{"n", "4"}})));
    return make_scene_data(std::move(input));
}

} // namespace

class MeshViewTest : public QObject {
    Q_OBJECT
private slots:
    void shows_a_mesh();
};

void MeshViewTest::shows_a_mesh() {
    MeshView view;
    view.resize(400, 300);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QTRY_VERIFY(view.renderCount() > 0);
    const int before = view.renderCount();
    view.setData(cube());
    QTRY_VERIFY(view.renderCount() > before);
    const QImage image = view.grab().toImage();
    QVERIFY(ameco::test::share_not_background(image) > 0.2);
}

int main(int argc, char** argv) {
    VtkWidget::setDefaultFormat();
    QApplication application(argc, argv);
    MeshViewTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "mesh_view_test.moc"
