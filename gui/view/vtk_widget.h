// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Hosts a VTK render window in a Qt widget.
///
/// Debian builds VTK's own Qt widget against Qt 5; this one needs VTK's rendering modules only.
#pragma once

#include "gui/scene/mesh_scene.h"

#include <QOpenGLWidget>

#include <vtkSmartPointer.h>

class QSurface;
class vtkCallbackCommand;

namespace ameco::gui {

class GenericWindow;

/// Draws a MeshScene and moves its camera. VTK renders into a framebuffer of its own, which is
/// copied to the widget's; one frame for any number of events.
class VtkWidget : public QOpenGLWidget {
    Q_OBJECT
public:
    /// \param scene  must outlive the widget
    explicit VtkWidget(MeshScene& scene, QWidget* parent = nullptr);
    ~VtkWidget() override;

    /// To be called before the application object is made: the kind of OpenGL VTK needs.
    static void setDefaultFormat();

    [[nodiscard]] int renderCount() const { return renders_; }
    void requestRender();

    [[nodiscard]] QImage grabImage(int factor, bool transparent);
    [[nodiscard]] QSurface* surface() const { return surface_; } ///< null before initializeGL

signals:
    void picked(const ameco::gui::Pick& pick);
    void cameraChanged();
    void clipDragged(const ameco::gui::ClipPlane& clip);
    void clipDragFinished();
    void rendered();

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    enum class Action { none, turn, shift, zoom, clip };

    [[nodiscard]] QPointF devicePixel(const QPointF& position) const;
    void observeWindow();
    void release();

    MeshScene& scene_;
    vtkSmartPointer<GenericWindow> window_;
    vtkSmartPointer<vtkCallbackCommand> make_current_;
    vtkSmartPointer<vtkCallbackCommand> is_current_;
    QSurface* surface_ = nullptr;
    QMetaObject::Connection context_gone_;
    bool dirty_ = true;
    int renders_ = 0;

    Action action_ = Action::none;
    ClipHandle handle_ = ClipHandle::shift;
    QPointF pressed_at_, last_at_;
    bool moved_ = false;
};

} // namespace ameco::gui
