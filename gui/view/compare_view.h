// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One, two or four levels beside each other.
#pragma once

#include "gui/view/mesh_view.h"

#include <QWidget>

#include <array>

class QGridLayout;

namespace ameco::gui {

/// Mesh views whose cameras and clip planes move together.
class CompareView : public QWidget {
    Q_OBJECT
public:
    explicit CompareView(QWidget* parent = nullptr);

    [[nodiscard]] int viewCount() const { return count_; }
    /// \param count  1, 2 or 4
    void setViewCount(int count);
    /// \param index  0 ... 3; views beyond the count exist when they were shown before
    [[nodiscard]] MeshView& view(int index);
    /// Shows a level; a linked view takes the camera of one that shows a level already.
    void setData(int index, std::shared_ptr<const SceneData> level);
    [[nodiscard]] bool hasOpenGL() const;

    [[nodiscard]] bool isLinked() const { return linked_; }
    void setLinked(bool linked); ///< the first view's camera and clip plane become everyone's

    /// All views in one picture.
    [[nodiscard]] QImage grabImage(int factor = 1, bool transparent = false);

public slots:
    void resetCamera();
    void standardView(ameco::gui::StandardView view);
    void setCamera(const ameco::gui::Camera& camera);

signals:
    void picked(int view, const ameco::gui::Pick& pick);
    void cameraChanged(int view);
    void clipDragged(int view, const ameco::gui::ClipPlane& clip);
    void clipDragFinished(int view);
    void rendered(int view);
    void filesDropped(const QStringList& files);

private:
    void addView();
    void followCamera(int leader);
    void followClip(int leader, const ClipPlane& clip);

    std::vector<MeshView*> views_;
    QGridLayout* layout_ = nullptr;
    int count_ = 0;
    bool linked_ = true;
};

} // namespace ameco::gui
