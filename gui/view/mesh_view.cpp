// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/view/mesh_view.h"

#include "gui/view/vtk_widget.h"

#include <QDragEnterEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QMimeData>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QVBoxLayout>

namespace ameco::gui {
namespace {

/// Whether OpenGL widgets work here; asked once. The platforms named know of OpenGL contexts, but
/// show no OpenGL widget.
bool openGLWorks() {
    static const bool works = [] {
        const QString platform = QGuiApplication::platformName();
        if (platform == "offscreen" || platform == "minimal" || platform == "vnc") {
            return false;
        }
        QOpenGLContext context;
        QOffscreenSurface surface;
        surface.create();
        return context.create() && context.makeCurrent(&surface) &&
               context.format().version() >= qMakePair(3, 2);
    }();
    return works;
}

} // namespace

MeshView::MeshView(QWidget* parent) : QWidget(parent), scene_(std::make_unique<MeshScene>()) {
    setAcceptDrops(true);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (!openGLWorks()) {
        apology_ = new QLabel(tr("There is no OpenGL 3.2 here, so meshes cannot be drawn.\n"
                                 "Tables, histograms and runs work all the same."));
        apology_->setAlignment(Qt::AlignCenter);
        apology_->setWordWrap(true);
        layout->addWidget(apology_);
        return;
    }
    canvas_ = new VtkWidget(*scene_);
    layout->addWidget(canvas_);
    setFocusProxy(canvas_);
    connect(canvas_, &VtkWidget::picked, this, &MeshView::picked);
    connect(canvas_, &VtkWidget::cameraChanged, this, &MeshView::cameraChanged);
    connect(canvas_, &VtkWidget::clipDragged, this, [this](const ClipPlane& clip) {
        SceneOptions options = scene_->options();
        options.clip = clip;
        setOptions(options);
        emit clipDragged(clip);
    });
    connect(canvas_, &VtkWidget::clipDragFinished, this, &MeshView::clipDragFinished);
    connect(canvas_, &VtkWidget::rendered, this, &MeshView::rendered);
}

MeshView::~MeshView() {
    delete canvas_; // before the scene it shows
}

bool MeshView::hasOpenGL() const {
    return canvas_ != nullptr;
}

int MeshView::renderCount() const {
    return canvas_ != nullptr ? canvas_->renderCount() : 0;
}

MeshScene& MeshView::scene() {
    return *scene_;
}

const SceneOptions& MeshView::options() const {
    return scene_->options();
}

Camera MeshView::camera() const {
    return scene_->camera();
}

QImage MeshView::grabImage(int factor, bool transparent) {
    return canvas_ != nullptr ? canvas_->grabImage(factor, transparent) : QImage();
}

void MeshView::redraw() {
    if (canvas_ != nullptr) {
        canvas_->requestRender();
    }
}

void MeshView::setData(std::shared_ptr<const SceneData> level) {
    scene_->set_data(std::move(level));
    redraw();
}

void MeshView::setOptions(const SceneOptions& options) {
    scene_->set_options(options);
    redraw();
}

void MeshView::setCamera(const Camera& camera) {
    scene_->set_camera(camera);
    redraw();
}

void MeshView::resetCamera() {
    scene_->reset_camera();
    redraw();
}

void MeshView::standardView(StandardView view) {
    scene_->standard_view(view);
    redraw();
}

void MeshView::highlight(const std::vector<NodeId>& nodes) {
    scene_->highlight(nodes);
    redraw();
}

void MeshView::mark(std::optional<NodeId> node) {
    scene_->mark(node);
    redraw();
}

void MeshView::setInteractive(bool interactive) {
    scene_->set_interactive(interactive);
    redraw();
}

void MeshView::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MeshView::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    if (!files.isEmpty()) {
        event->acceptProposedAction();
        emit filesDropped(files);
    }
}

} // namespace ameco::gui
