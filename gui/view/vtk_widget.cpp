// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/view/vtk_widget.h"

#include "gui/bridge/generic_window.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QSurface>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>

#include <cmath>

namespace ameco::gui {
namespace {

constexpr double click_distance = 4; ///< a press that moves less is a click [pixels]

void makeCurrent(vtkObject*, unsigned long, void* client, void*) {
    // Not QOpenGLWidget::makeCurrent(): that binds the widget's framebuffer behind VTK's back.
    auto* const widget = static_cast<VtkWidget*>(client);
    if (widget->context() != nullptr && widget->surface() != nullptr) {
        widget->context()->makeCurrent(widget->surface());
    }
}

void isCurrent(vtkObject*, unsigned long, void* client, void* answer) {
    const auto* const widget = static_cast<VtkWidget*>(client);
    *static_cast<bool*>(answer) =
        widget->context() != nullptr && QOpenGLContext::currentContext() == widget->context();
}

} // namespace

void VtkWidget::setDefaultFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setRedBufferSize(8);
    format.setGreenBufferSize(8);
    format.setBlueBufferSize(8);
    format.setAlphaBufferSize(8);
    format.setDepthBufferSize(24);
    format.setSamples(0);
    QSurfaceFormat::setDefaultFormat(format);
}

VtkWidget::VtkWidget(MeshScene& scene, QWidget* parent)
    : QOpenGLWidget(parent), scene_(scene),
      window_(vtkSmartPointer<GenericWindow>::Take(GenericWindow::New())) {
    setFocusPolicy(Qt::StrongFocus);
    window_->drawOffSide();
    observeWindow();
    scene_.attach(window_);
    scene_.set_handles(true);
}

VtkWidget::~VtkWidget() {
    // ~QOpenGLWidget emits aboutToBeDestroyed when our members are gone already.
    disconnect(context_gone_);
    scene_.attach(nullptr);
    release();
    window_->RemoveObserver(make_current_);
    window_->RemoveObserver(is_current_);
}

void VtkWidget::observeWindow() {
    make_current_ = vtkSmartPointer<vtkCallbackCommand>::New();
    make_current_->SetClientData(this);
    make_current_->SetCallback(gui::makeCurrent);
    window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, make_current_);
    is_current_ = vtkSmartPointer<vtkCallbackCommand>::New();
    is_current_->SetClientData(this);
    is_current_->SetCallback(gui::isCurrent);
    window_->AddObserver(vtkCommand::WindowIsCurrentEvent, is_current_);
}

void VtkWidget::release() {
    if (context() == nullptr) {
        return;
    }
    makeCurrent();
    window_->Finalize();
    window_->SetReadyForRendering(false);
    doneCurrent();
    surface_ = nullptr;
}

void VtkWidget::requestRender() {
    dirty_ = true;
    update();
}

void VtkWidget::initializeGL() {
    surface_ = context()->surface();
    context_gone_ = connect(
        context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); },
        Qt::DirectConnection);
    window_->start();
    dirty_ = true;
}

void VtkWidget::resizeGL(int width, int height) {
    const double ratio = devicePixelRatioF();
    window_->SetSize(static_cast<int>(std::lround(width * ratio)),
                     static_cast<int>(std::lround(height * ratio)));
    dirty_ = true;
}

void VtkWidget::paintGL() {
    if (surface_ == nullptr || window_->GetSize()[0] <= 0 || window_->GetSize()[1] <= 0) {
        return;
    }
    const bool renders = dirty_;
    {
        const GenericWindow::StateGuard guard(*window_);
        if (renders) {
            dirty_ = false;
            scene_.prepare(devicePixelRatioF());
            window_->Render();
        }
        makeCurrent();
        window_->copyTo(defaultFramebufferObject());
    }
    if (renders) {
        ++renders_;
        emit rendered();
    }
}

QImage VtkWidget::grabImage(int factor, bool transparent) {
    if (!isValid() || surface_ == nullptr) {
        return {};
    }
    makeCurrent();
    const int width = window_->GetSize()[0];
    const int height = window_->GetSize()[1];
    QImage image(width * factor, height * factor, QImage::Format_RGBA8888);
    {
        const GenericWindow::StateGuard guard(*window_);
        window_->SetSize(width * factor, height * factor);
        scene_.set_transparent(transparent);
        scene_.set_handles(false);
        scene_.prepare(devicePixelRatioF() * factor);
        window_->Render();
        const std::vector<unsigned char> pixels = window_->readPixels(!transparent);
        const auto row = static_cast<std::size_t>(image.width()) * 4;
        for (int y = 0; y < image.height(); ++y) {
            std::copy_n(pixels.data() + row * static_cast<std::size_t>(y), row, image.scanLine(y));
        }
        scene_.set_transparent(false);
        scene_.set_handles(true);
        window_->SetSize(width, height);
    }
    requestRender();
    return image;
}

QPointF VtkWidget::devicePixel(const QPointF& position) const {
    const double ratio = devicePixelRatioF();
    return {position.x() * ratio, height() * ratio - 1 - position.y() * ratio};
}

void VtkWidget::mousePressEvent(QMouseEvent* event) {
    const QPointF at = devicePixel(event->position());
    pressed_at_ = last_at_ = at;
    moved_ = false;
    action_ = Action::none;
    if (event->button() == Qt::LeftButton) {
        if (const auto handle = scene_.clip_handle_at(at.x(), at.y())) {
            action_ = Action::clip;
            handle_ = *handle;
        } else {
            action_ = (event->modifiers() & Qt::ShiftModifier) != 0 ? Action::shift : Action::turn;
        }
    } else if (event->button() == Qt::MiddleButton) {
        action_ = Action::shift;
    } else if (event->button() == Qt::RightButton) {
        action_ = Action::zoom;
    }
}

void VtkWidget::mouseMoveEvent(QMouseEvent* event) {
    if (action_ == Action::none) {
        return;
    }
    const QPointF at = devicePixel(event->position());
    const QPointF way = at - pressed_at_;
    if (!moved_ && std::hypot(way.x(), way.y()) < click_distance * devicePixelRatioF()) {
        return;
    }
    moved_ = true;
    const QPointF step = at - last_at_;
    scene_.set_interactive(true);
    switch (action_) {
    case Action::turn:
        scene_.turn(step.x(), step.y());
        emit cameraChanged();
        break;
    case Action::shift:
        scene_.shift(step.x(), step.y());
        emit cameraChanged();
        break;
    case Action::zoom:
        scene_.zoom_at(pressed_at_.x(), pressed_at_.y(), std::pow(1.01, step.y()));
        emit cameraChanged();
        break;
    case Action::clip:
        emit clipDragged(scene_.dragged_clip(handle_, last_at_.x(), last_at_.y(), at.x(), at.y()));
        break;
    case Action::none:
        break;
    }
    last_at_ = at;
    requestRender();
}

void VtkWidget::mouseReleaseEvent(QMouseEvent* event) {
    const Action action = action_;
    action_ = Action::none;
    if (moved_) {
        scene_.set_interactive(false);
        requestRender();
        if (action == Action::clip) {
            emit clipDragFinished();
        }
    } else if (event->button() == Qt::LeftButton) {
        if (const auto pick = scene_.pick(pressed_at_.x(), pressed_at_.y())) {
            emit picked(*pick);
        }
    }
}

void VtkWidget::wheelEvent(QWheelEvent* event) {
    const QPointF at = devicePixel(event->position());
    scene_.zoom_at(at.x(), at.y(), std::pow(1.2, event->angleDelta().y() / 120.0));
    emit cameraChanged();
    requestRender();
    event->accept();
}

} // namespace ameco::gui
