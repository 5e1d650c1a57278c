// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Keeps the views in step with the document: which level each shows, and what of it.
#pragma once

#include "gui/model/document.h"
#include "gui/view/compare_view.h"

#include <QObject>

#include <array>
#include <optional>
#include <set>

namespace ameco::gui {

/// A picked node: of which level, and where.
struct PickedNode {
    int level_id = -1;
    NodeId node;
    std::optional<Pick> pick; ///< what was hit; nothing when the node was named by its number
};

/// Each view shows a level. The active view shows the document's current one and follows it; the
/// others keep theirs. A click in a view makes it the active one.
class ViewController : public QObject {
    Q_OBJECT
public:
    ViewController(Document& document, CompareView& views, QObject* parent = nullptr);

    [[nodiscard]] const SceneOptions& options() const { return options_; }
    /// For all views.
    void setOptions(const SceneOptions& options);
    void setViewCount(int count);
    /// Four views of the current level, the ellipsoids of each with another mean.
    void setMeansSideBySide(bool on);
    [[nodiscard]] bool areMeansSideBySide() const { return means_side_by_side_; }
    [[nodiscard]] int activeView() const { return active_; }
    [[nodiscard]] int shownLevel(int view) const; ///< id; -1 for none
    void showLevel(int view, int level_id);

    /// Marks a node, and the same place in views of other levels.
    void pick(const PickedNode& picked);
    [[nodiscard]] const std::optional<PickedNode>& picked() const { return picked_; }
    /// Moves all cameras so that the picked node is in the middle.
    void lookAtPicked();
    /// Lights up the nodes of these aspect-ratio classes, in all views; class 0 has the largest.
    void highlightClasses(const std::set<int>& classes);
    [[nodiscard]] std::size_t highlightedCount() const { return highlighted_; }

    /// Shows the document's levels again, when a mesh that was sketched has not been opened.
    void dropSketch();

signals:
    void optionsChanged(const ameco::gui::SceneOptions& options); ///< by hand, in a view
    void nodePicked();
    void shownLevelsChanged();

private:
    void sketch(const std::shared_ptr<const SceneData>& scene);
    void openAll();
    void follow();
    void refresh(int level_id);
    void show(int view);
    [[nodiscard]] SceneOptions optionsOf(int view) const;
    [[nodiscard]] std::shared_ptr<const SceneData> sceneOf(int view) const;
    void markIn(int view);
    void highlightIn(int view);
    void takePick(int view, const Pick& pick);

    Document& document_;
    CompareView& views_;
    SceneOptions options_;
    std::array<int, 4> shown_{-1, -1, -1, -1};
    int active_ = 0;
    bool means_side_by_side_ = false;
    bool sketched_ = false; ///< the views show a mesh that is not open yet
    std::optional<PickedNode> picked_;
    std::set<int> classes_;
    std::size_t highlighted_ = 0;
};

/// Nodes of a level whose aspect ratio is in one of the classes.
[[nodiscard]] std::vector<NodeId> nodes_of_classes(const CaseLevel& level,
                                                   const std::set<int>& classes);

/// Nodes on faces of these patches.
[[nodiscard]] std::vector<NodeId> nodes_of_patches(const CaseLevel& level,
                                                   const std::set<int>& patches);

} // namespace ameco::gui
