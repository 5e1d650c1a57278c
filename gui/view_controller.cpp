// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/view_controller.h"

#include "core/metric/aspect_ratio.h"

#include <algorithm>
#include <array>
#include <string>

namespace ameco::gui {
namespace {

/// Those of the paper's figures 2 and 3.
constexpr std::array compared_means{Mean::corrected, Mean::interpolation, Mean::log_euclidean,
                                    Mean::geodesic};

} // namespace

ViewController::ViewController(Document& document, CompareView& views, QObject* parent)
    : QObject(parent), document_(document), views_(views) {
    connect(&document, &Document::sketched, this, &ViewController::sketch);
    connect(&document, &Document::opened, this, &ViewController::openAll);
    connect(&document, &Document::closed, this, &ViewController::openAll);
    connect(&document, &Document::currentChanged, this, &ViewController::follow);
    connect(&document, &Document::levelRemoved, this, [this] {
        for (int v = 0; v < views_.viewCount(); ++v) {
            if (document_.level(shownLevel(v)) == nullptr && document_.current() != nullptr) {
                showLevel(v, document_.current()->id);
            }
        }
    });
    connect(&document, &Document::levelChanged, this, &ViewController::refresh);
    connect(&views, &CompareView::picked, this, &ViewController::takePick);
    connect(&views, &CompareView::clipDragged, this, [this](int, const ClipPlane& clip) {
        options_.clip = clip;
        emit optionsChanged(options_);
    });
}

int ViewController::shownLevel(int view) const {
    return shown_.at(static_cast<std::size_t>(view));
}

void ViewController::setOptions(const SceneOptions& options) {
    options_ = options;
    for (int v = 0; v < views_.viewCount(); ++v) {
        views_.view(v).setOptions(optionsOf(v));
    }
}

SceneOptions ViewController::optionsOf(int view) const {
    SceneOptions options = options_;
    if (means_side_by_side_) {
        options.ellipsoids.mean = compared_means.at(static_cast<std::size_t>(view));
    }
    return options;
}

std::shared_ptr<const SceneData> ViewController::sceneOf(int view) const {
    const CaseLevel* const level = document_.level(shownLevel(view));
    if (level == nullptr || !means_side_by_side_) {
        return level != nullptr ? level->scene : nullptr;
    }
    // The same level under the name of its mean.
    auto scene = std::make_shared<SceneData>(*level->scene);
    std::visit(
        [&](auto& input) {
            input.name = name(compared_means.at(static_cast<std::size_t>(view)));
            input.name += " mean, level " + std::to_string(level->number);
        },
        scene->input);
    return scene;
}

void ViewController::setMeansSideBySide(bool on) {
    if (on) {
        setViewCount(4);
    }
    means_side_by_side_ = on;
    for (int v = 0; v < views_.viewCount() && document_.current() != nullptr; ++v) {
        shown_.at(static_cast<std::size_t>(v)) = document_.current()->id;
        show(v);
    }
    emit shownLevelsChanged();
}

void ViewController::setViewCount(int count) {
    means_side_by_side_ = false;
    const int before = views_.viewCount();
    views_.setViewCount(count);
    active_ = count - 1;
    const Branch branch = document_.currentBranch();
    const int last = static_cast<int>(branch.size()) - 1;
    for (int v = 0; v < count && last >= 0; ++v) {
        // The finest level first; in the last view the current one.
        const int id = v == active_ ? document_.current()->id
                                    : branch[static_cast<std::size_t>(std::min(v, last))]->id;
        shown_.at(static_cast<std::size_t>(v)) = id;
        show(v);
        if (v >= before) {
            views_.view(v).setCamera(views_.view(0).camera());
        }
    }
    emit shownLevelsChanged();
}

void ViewController::showLevel(int view, int level_id) {
    if (document_.level(level_id) == nullptr || view >= views_.viewCount()) {
        return;
    }
    shown_.at(static_cast<std::size_t>(view)) = level_id;
    show(view);
    emit shownLevelsChanged();
}

void ViewController::sketch(const std::shared_ptr<const SceneData>& scene) {
    SceneOptions plain = options_;
    plain.clip.enabled = false;
    plain.lens.enabled = false;
    plain.range.reset();
    plain.colour = ColourBy::patch; // others have to be measured first
    plain.ellipsoids.where = EllipsoidOptions::Where::none;
    plain.hidden_patches = patches_hidden_at_first(*scene);
    for (int v = 0; v < views_.viewCount(); ++v) {
        MeshView& view = views_.view(v);
        view.setData(nullptr);
        view.mark(std::nullopt);
        view.highlight({});
        view.setData(scene);
        view.setOptions(plain);
    }
    views_.resetCamera();
    sketched_ = true;
}

void ViewController::dropSketch() {
    if (sketched_) {
        sketched_ = false;
        for (int v = 0; v < views_.viewCount(); ++v) {
            show(v);
        }
        views_.resetCamera();
    }
}

void ViewController::openAll() {
    picked_.reset();
    classes_.clear();
    const int id = document_.isOpen() ? document_.levels().front().id : -1;
    options_.clip.enabled = false;
    options_.lens.enabled = false;
    options_.range.reset();
    if (id >= 0) {
        const SceneData& scene = *document_.levels().front().scene;
        options_.clip.origin = (scene.focus_low + scene.focus_high) / 2;
        options_.hidden_patches = patches_hidden_at_first(scene);
    }
    for (int v = 0; v < views_.viewCount(); ++v) {
        shown_.at(static_cast<std::size_t>(v)) = id;
        if (!sketched_) {
            views_.view(v).setData(nullptr);
        }
        show(v);
    }
    if (!sketched_) { // else somebody may have turned it already
        views_.resetCamera();
    }
    sketched_ = false;
    emit optionsChanged(options_);
    emit nodePicked();
    emit shownLevelsChanged();
}

void ViewController::follow() {
    if (document_.current() != nullptr && shownLevel(active_) != document_.current()->id) {
        showLevel(active_, document_.current()->id);
    }
}

void ViewController::refresh(int level_id) {
    for (int v = 0; v < views_.viewCount(); ++v) {
        if (shownLevel(v) == level_id) {
            show(v);
        }
    }
}

void ViewController::show(int view) {
    MeshView& widget = views_.view(view);
    widget.setData(sceneOf(view));
    widget.setOptions(optionsOf(view));
    markIn(view);
    highlightIn(view);
}

void ViewController::pick(const PickedNode& picked) {
    picked_ = picked;
    for (int v = 0; v < views_.viewCount(); ++v) {
        markIn(v);
    }
    emit nodePicked();
}

void ViewController::takePick(int view, const Pick& pick) {
    active_ = view;
    const int id = shownLevel(view);
    document_.setCurrent(id);
    this->pick({id, pick.node, pick});
}

void ViewController::markIn(int view) {
    const int id = shownLevel(view);
    views_.view(view).mark(picked_ && id >= 0
                               ? document_.sameNode(picked_->level_id, picked_->node, id)
                               : std::nullopt);
}

void ViewController::lookAtPicked() {
    const CaseLevel* const level = picked_ ? document_.level(picked_->level_id) : nullptr;
    if (level == nullptr) {
        return;
    }
    Camera camera = views_.view(active_).camera();
    camera.focus = level->scene->position(picked_->node);
    views_.setCamera(camera);
}

void ViewController::highlightClasses(const std::set<int>& classes) {
    classes_ = classes;
    for (int v = 0; v < views_.viewCount(); ++v) {
        highlightIn(v);
    }
}

void ViewController::highlightIn(int view) {
    const CaseLevel* const level = document_.level(shownLevel(view));
    std::vector<NodeId> nodes;
    if (level != nullptr && !classes_.empty()) {
        nodes = nodes_of_classes(*level, classes_);
    }
    if (view == active_) {
        highlighted_ = nodes.size();
    }
    views_.view(view).highlight(nodes);
}

std::vector<NodeId> nodes_of_classes(const CaseLevel& level, const std::set<int>& classes) {
    std::vector<NodeId> nodes;
    std::visit(
        [&]<int D>(const Level<D>& l) {
            for (const NodeId v : l.natural.ids()) {
                const auto k = level.statistics.classes.class_of(aspect_ratio<D>(l.natural[v]));
                if (classes.count(static_cast<int>(k)) > 0) {
                    nodes.push_back(v);
                }
            }
        },
        *level.level);
    return nodes;
}

std::vector<NodeId> nodes_of_patches(const CaseLevel& level, const std::set<int>& patches) {
    std::vector<NodeId> nodes;
    std::visit(
        [&](const auto& l) {
            for (const FaceId f : l.mesh.faces.ids()) {
                if (patches.count(l.mesh.patch[f]) > 0) {
                    nodes.insert(nodes.end(), l.mesh.faces[f].begin(), l.mesh.faces[f].end());
                }
            }
        },
        *level.level);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

} // namespace ameco::gui
