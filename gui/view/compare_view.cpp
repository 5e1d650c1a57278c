// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/view/compare_view.h"

#include <QGridLayout>
#include <QPainter>

#include <algorithm>

namespace ameco::gui {

CompareView::CompareView(QWidget* parent) : QWidget(parent) {
    layout_ = new QGridLayout(this);
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(2);
    setViewCount(1);
}

void CompareView::addView() {
    const int index = static_cast<int>(views_.size());
    auto* const view = new MeshView;
    views_.push_back(view);
    layout_->addWidget(view, index / 2, index % 2);
    connect(view, &MeshView::picked, this, [this, index](const Pick& p) { emit picked(index, p); });
    connect(view, &MeshView::cameraChanged, this, [this, index] {
        followCamera(index);
        emit cameraChanged(index);
    });
    connect(view, &MeshView::clipDragged, this, [this, index](const ClipPlane& clip) {
        followClip(index, clip);
        emit clipDragged(index, clip);
    });
    connect(view, &MeshView::clipDragFinished, this, [this, index] {
        for (MeshView* v : views_) {
            v->setInteractive(false);
        }
        emit clipDragFinished(index);
    });
    connect(view, &MeshView::rendered, this, [this, index] { emit rendered(index); });
    connect(view, &MeshView::filesDropped, this, &CompareView::filesDropped);
}

void CompareView::setViewCount(int count) {
    Q_ASSERT(count == 1 || count == 2 || count == 4);
    while (static_cast<int>(views_.size()) < count) {
        addView();
    }
    count_ = count;
    for (std::size_t i = 0; i < views_.size(); ++i) {
        views_[i]->setVisible(static_cast<int>(i) < count);
    }
    if (linked_) {
        followCamera(0);
    }
}

MeshView& CompareView::view(int index) {
    return *views_.at(static_cast<std::size_t>(index));
}

void CompareView::setData(int index, std::shared_ptr<const SceneData> level) {
    const auto shows = [&](int i) { return i != index && view(i).scene().data() != nullptr; };
    view(index).setData(std::move(level));
    for (int i = 0; linked_ && i < count_; ++i) {
        if (shows(i)) {
            view(index).setCamera(view(i).camera());
            break;
        }
    }
}

bool CompareView::hasOpenGL() const {
    return views_.front()->hasOpenGL();
}

void CompareView::setLinked(bool linked) {
    linked_ = linked;
    if (linked_) {
        followCamera(0);
        followClip(0, views_.front()->options().clip);
    }
}

void CompareView::followCamera(int leader) {
    if (!linked_) {
        return;
    }
    const Camera camera = view(leader).camera();
    for (int i = 0; i < count_; ++i) {
        if (i != leader) {
            view(i).setCamera(camera);
        }
    }
}

void CompareView::followClip(int leader, const ClipPlane& clip) {
    if (!linked_) {
        return;
    }
    for (int i = 0; i < count_; ++i) {
        if (i != leader) {
            SceneOptions options = view(i).options();
            options.clip = clip;
            view(i).setOptions(options);
        }
    }
}

QImage CompareView::grabImage(int factor, bool transparent) {
    if (!hasOpenGL()) {
        return {};
    }
    const double scale = factor * devicePixelRatioF();
    QImage all(QSize(static_cast<int>(width() * scale), static_cast<int>(height() * scale)),
               QImage::Format_RGBA8888);
    all.fill(transparent ? Qt::transparent : Qt::white);
    QPainter painter(&all);
    for (int i = 0; i < count_; ++i) {
        const QPoint corner = view(i).pos();
        painter.drawImage(QPointF(corner.x() * scale, corner.y() * scale),
                          view(i).grabImage(factor, transparent));
    }
    return all;
}

void CompareView::resetCamera() {
    view(0).resetCamera();
    followCamera(0);
    for (int i = 1; i < count_ && !linked_; ++i) {
        view(i).resetCamera();
    }
}

void CompareView::standardView(StandardView standard) {
    view(0).standardView(standard);
    followCamera(0);
    for (int i = 1; i < count_ && !linked_; ++i) {
        view(i).standardView(standard);
    }
}

void CompareView::setCamera(const Camera& camera) {
    for (int i = 0; i < count_; ++i) {
        view(i).setCamera(camera);
    }
}

} // namespace ameco::gui
