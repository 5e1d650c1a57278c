// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A widget that shows one level.
#pragma once

#include "gui/scene/mesh_scene.h"

#include <QImage>
#include <QStringList>
#include <QWidget>

class QLabel;

namespace ameco::gui {

class VtkWidget;

/// One mesh in a widget: turn with the left button, shift with the middle one or with Shift, zoom
/// with the wheel at the mouse, pick with a click. Where Qt has no OpenGL a text says so instead,
/// and everything else keeps working.
class MeshView : public QWidget {
    Q_OBJECT
public:
    explicit MeshView(QWidget* parent = nullptr);
    ~MeshView() override;

    [[nodiscard]] bool hasOpenGL() const;
    [[nodiscard]] int renderCount() const; ///< frames drawn so far, for tests that wait for one

    [[nodiscard]] MeshScene& scene(); ///< call update() after changing it
    [[nodiscard]] const SceneOptions& options() const;
    [[nodiscard]] Camera camera() const;

    /// \param factor  pixels of the picture per pixel of the widget: 1, 2, 4
    /// \return        a null image without OpenGL
    [[nodiscard]] QImage grabImage(int factor = 1, bool transparent = false);

public slots:
    void setData(std::shared_ptr<const ameco::gui::SceneData> level);
    void setOptions(const ameco::gui::SceneOptions& options);
    void setCamera(const ameco::gui::Camera& camera);
    void resetCamera();
    void standardView(ameco::gui::StandardView view);
    void highlight(const std::vector<ameco::NodeId>& nodes);
    void mark(std::optional<ameco::NodeId> node);
    /// While true (a slider is being dragged, say) large meshes are shown in a simpler way.
    void setInteractive(bool interactive);

signals:
    void picked(const ameco::gui::Pick& pick);
    void cameraChanged();                                ///< by the user's hand
    void clipDragged(const ameco::gui::ClipPlane& clip); ///< by the user's hand; the options follow
    void clipDragFinished();
    void rendered();
    void filesDropped(const QStringList& files);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void redraw();

    std::unique_ptr<MeshScene> scene_;
    VtkWidget* canvas_ = nullptr; ///< null without OpenGL
    QLabel* apology_ = nullptr;
};

} // namespace ameco::gui
