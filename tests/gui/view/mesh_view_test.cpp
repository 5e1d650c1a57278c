// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/view/mesh_view.h"

#include "core/cases/cases.h"
#include "gui/view/compare_view.h"
#include "gui/view/vtk_widget.h"
#include "tests/support/picture.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QPointer>
#include <QSignalSpy>
#include <QUrl>
#include <QWheelEvent>
#include <QtTest>

using namespace ameco;
using namespace ameco::gui;
using ameco::test::share_not_background;

namespace {

std::shared_ptr<const SceneData> cube(const std::string& cells = "4") {
    SceneInput<3> input;
    input.mesh = std::make_shared<const Mesh<3>>(std::get<0>(make_case("cube", {{"n", cells}})));
    return make_scene_data(std::move(input));
}

/// The widget that gets the mouse.
QWidget* canvas_of(MeshView& view) {
    return view.findChild<VtkWidget*>();
}

void wheel(QWidget* widget, const QPoint& at, int delta) {
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(widget, &event);
}

void drag(QWidget* widget, Qt::MouseButton button, const QPoint& from, const QPoint& to) {
    QTest::mousePress(widget, button, {}, from);
    for (int k = 1; k <= 4; ++k) {
        QTest::mouseMove(widget, from + (to - from) * k / 4);
    }
    QTest::mouseRelease(widget, button, {}, to);
}

} // namespace

class MeshViewTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void shows_a_mesh();
    void turns_when_dragged();
    void shifts_with_the_middle_button();
    void zooms_at_the_mouse_with_the_wheel();
    void draws_many_events_in_few_frames();
    void picks_with_a_click_and_not_with_a_drag();
    void drags_the_clip_plane();
    void grabs_larger_and_transparent_pictures();
    void survives_resizing_hiding_and_another_parent();
    void takes_dropped_files();
    void compares_with_linked_cameras_and_planes();
    void closes_while_shown();

private:
    /// Waits for a frame after `change` has been made.
    template <class Change>
    void and_drawn(Change change) {
        const int before = view_->renderCount();
        change();
        QTRY_VERIFY(view_->renderCount() > before);
    }
    [[nodiscard]] QPoint widget_point(const std::pair<double, double>& pixel) const {
        const double ratio = view_->devicePixelRatioF();
        return {static_cast<int>(std::lround(pixel.first / ratio)),
                static_cast<int>(std::lround(canvas_->height() - 1 - pixel.second / ratio))};
    }

    std::unique_ptr<MeshView> view_;
    QWidget* canvas_ = nullptr;
};

void MeshViewTest::initTestCase() {
    if (QGuiApplication::platformName() == "offscreen") {
        QSKIP("no screen: run it under xvfb-run");
    }
}

void MeshViewTest::init() {
    view_ = std::make_unique<MeshView>();
    canvas_ = canvas_of(*view_);
    QVERIFY(view_->hasOpenGL());
    view_->resize(480, 360);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    and_drawn([&] { view_->setData(cube()); });
}

void MeshViewTest::cleanup() {
    view_.reset();
}

void MeshViewTest::shows_a_mesh() {
    const QImage image = view_->grab().toImage();
    QVERIFY(share_not_background(image) > 0.2);
    and_drawn([&] { view_->setData(nullptr); });
    QVERIFY(share_not_background(view_->grab().toImage()) < 0.01);
}

void MeshViewTest::turns_when_dragged() {
    QSignalSpy changed(view_.get(), &MeshView::cameraChanged);
    const Camera before = view_->camera();
    const QImage first = view_->grab().toImage();
    and_drawn([&] { drag(canvas_, Qt::LeftButton, {240, 180}, {320, 180}); });
    const Camera after = view_->camera();
    QVERIFY(changed.count() > 0);
    // A drag by the view's height is half a turn; about the upward direction here.
    const double angle = std::acos(before.sight.normalized().dot(after.sight.normalized()));
    QVERIFY2(angle > 0.4 && angle < 0.9, std::to_string(angle).c_str());
    QCOMPARE(after.focus, before.focus);
    QVERIFY(view_->grab().toImage() != first);
}

void MeshViewTest::shifts_with_the_middle_button() {
    const auto before = view_->scene().pixel_of({0.5, 0.5, 0.5});
    and_drawn([&] { drag(canvas_, Qt::MiddleButton, {200, 200}, {260, 170}); });
    const auto after = view_->scene().pixel_of({0.5, 0.5, 0.5});
    const double ratio = view_->devicePixelRatioF();
    QVERIFY(std::abs(after.first - before.first - 60 * ratio) < 1e-6);
    QVERIFY(std::abs(after.second - before.second - 30 * ratio) < 1e-6);
}

void MeshViewTest::zooms_at_the_mouse_with_the_wheel() {
    const double height = view_->camera().height;
    const auto pick = view_->scene().pick(200, 180);
    QVERIFY(pick.has_value());
    const QPoint at = widget_point({200, 180});
    and_drawn([&] { wheel(canvas_, at, 120); });
    QVERIFY(std::abs(view_->camera().height - height / 1.2) < 1e-12);
    QCOMPARE(widget_point(view_->scene().pixel_of(pick->position)), at);
}

void MeshViewTest::draws_many_events_in_few_frames() {
    const int before = view_->renderCount();
    for (int k = 0; k < 12; ++k) {
        wheel(canvas_, {100, 100}, 30);
    }
    QTRY_VERIFY(view_->renderCount() > before);
    QTest::qWait(50);
    QVERIFY2(view_->renderCount() <= before + 3,
             std::to_string(view_->renderCount() - before).c_str());
}

void MeshViewTest::picks_with_a_click_and_not_with_a_drag() {
    QSignalSpy picked(view_.get(), &MeshView::picked);
    const auto expected = view_->scene().pick(240, 170);
    QVERIFY(expected.has_value());
    drag(canvas_, Qt::LeftButton, {240, 180}, {280, 180});
    QCOMPARE(picked.count(), 0);
    view_->standardView(StandardView::corner);
    QTRY_VERIFY(view_->scene().pick(240, 170).has_value());
    const Vec3 x = view_->scene().data()->position(view_->scene().pick(240, 170)->node);
    QTest::mouseClick(canvas_, Qt::LeftButton, {}, widget_point(view_->scene().pixel_of(x)));
    QCOMPARE(picked.count(), 1);
    const auto pick = picked.front().front().value<Pick>();
    QCOMPARE(view_->scene().data()->position(pick.node), x);
    QTest::mouseClick(canvas_, Qt::LeftButton, {}, {2, 2});
    QCOMPARE(picked.count(), 1); // the background is no node
}

void MeshViewTest::drags_the_clip_plane() {
    QSignalSpy dragged(view_.get(), &MeshView::clipDragged);
    QSignalSpy finished(view_.get(), &MeshView::clipDragFinished);
    SceneOptions options = view_->options();
    options.clip = {true, {0.5, 0.5, 0.5}, {1, 0, 0}, true, false};
    and_drawn([&] {
        view_->setOptions(options);
        view_->standardView(StandardView::minus_y);
    });
    const QPoint middle = widget_point(view_->scene().pixel_of({0.5, 0.5, 0.5}));
    const QPoint edge = widget_point(view_->scene().pixel_of({0.75, 0.5, 0.5}));
    const Camera camera = view_->camera();
    and_drawn([&] { drag(canvas_, Qt::LeftButton, middle + QPoint(20, 0), edge + QPoint(20, 0)); });
    QVERIFY(dragged.count() >= 2);
    QCOMPARE(finished.count(), 1);
    QCOMPARE(view_->camera(), camera); // the camera stays
    QVERIFY(std::abs(view_->options().clip.origin[0] - 0.75) < 0.01);
}

void MeshViewTest::grabs_larger_and_transparent_pictures() {
    const QImage once = view_->grabImage(1, false);
    const QSize size = canvas_->size() * view_->devicePixelRatioF();
    QCOMPARE(once.size(), size);
    for (const int factor : {2, 4}) {
        const QImage image = view_->grabImage(factor, false);
        QCOMPARE(image.size(), size * factor);
        // The same picture: the mesh covers the same share of it.
        QVERIFY(std::abs(share_not_background(image) - share_not_background(once)) < 0.05);
    }
    const QImage open = view_->grabImage(1, true);
    QCOMPARE(open.pixelColor(0, 0).alpha(), 0);
    QCOMPARE(open.pixelColor(size.width() / 2 - 40, size.height() / 2).alpha(), 255);
    QTRY_VERIFY(share_not_background(view_->grab().toImage()) > 0.2); // and the view is as before
}

void MeshViewTest::survives_resizing_hiding_and_another_parent() {
    and_drawn([&] { view_->resize(700, 300); });
    view_->hide();
    and_drawn([&] {
        view_->show();
        view_->resetCamera();
    });
    QWidget other;
    other.resize(500, 500);
    view_->setParent(&other);
    other.show();
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(&other));
    and_drawn([&] { view_->resetCamera(); });
    QVERIFY(share_not_background(view_->grabImage(1, false)) > 0.1);
    view_->setParent(nullptr);
}

void MeshViewTest::takes_dropped_files() {
    QSignalSpy dropped(view_.get(), &MeshView::filesDropped);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile("/somewhere/wing.meshb"), QUrl("https://example.org/a")});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view_.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view_.get(), &event);
    QCOMPARE(dropped.count(), 1);
    QCOMPARE(dropped.front().front().toStringList(), QStringList{"/somewhere/wing.meshb"});
}

void MeshViewTest::compares_with_linked_cameras_and_planes() {
    CompareView compare;
    compare.resize(900, 400);
    compare.setViewCount(2);
    compare.show();
    QVERIFY(QTest::qWaitForWindowExposed(&compare));
    compare.setData(0, cube("5"));
    compare.setData(1, cube("2"));
    QCOMPARE(compare.view(1).camera(), compare.view(0).camera());
    QTRY_VERIFY(compare.view(1).renderCount() > 0);
    drag(canvas_of(compare.view(1)), Qt::LeftButton, {200, 200}, {260, 240});
    QCOMPARE(compare.view(0).camera(), compare.view(1).camera());
    QSignalSpy picked(&compare, &CompareView::picked);
    QTest::mouseClick(canvas_of(compare.view(1)), Qt::LeftButton, {}, {200, 200});
    QCOMPARE(picked.count(), 1);
    QCOMPARE(picked.front().front().toInt(), 1);
    compare.setLinked(false);
    const Camera first = compare.view(0).camera();
    drag(canvas_of(compare.view(1)), Qt::LeftButton, {200, 200}, {260, 240});
    QCOMPARE(compare.view(0).camera(), first);
    compare.setViewCount(4);
    QCOMPARE(compare.viewCount(), 4);
    compare.setViewCount(1);
    QVERIFY(compare.view(0).isVisible() && !compare.view(1).isVisible());
    QTRY_VERIFY(share_not_background(compare.grabImage(1, false)) > 0.08);
}

void MeshViewTest::closes_while_shown() {
    // Five windows, closed in the order they came, with frames under way.
    std::vector<std::unique_ptr<MeshView>> views;
    for (int k = 0; k < 5; ++k) {
        views.push_back(std::make_unique<MeshView>());
        views.back()->resize(200, 150);
        views.back()->setData(view_->scene().data());
        views.back()->show();
        QVERIFY(QTest::qWaitForWindowExposed(views.back().get()));
        views.back()->resetCamera();
    }
    views.erase(views.begin(), views.begin() + 2);
    views.clear();
    and_drawn([&] { view_->resetCamera(); }); // what is left still draws
}

int main(int argc, char** argv) {
    VtkWidget::setDefaultFormat();
    QApplication application(argc, argv);
    MeshViewTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "mesh_view_test.moc"
