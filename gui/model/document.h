// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The open case: a mesh and the tree of levels made from it.
#pragma once

#include "core/hierarchy/build_hierarchy.h"
#include "gui/jobs/job_runner.h"
#include "gui/model/case_level.h"

#include <QObject>
#include <QString>

#include <map>
#include <optional>
#include <set>

namespace ameco::gui {

/// A branch of the tree: the levels from the finest to one of them.
using Branch = std::vector<const CaseLevel*>;

/// Owns the levels, runs what makes them, tells who listens. Knows no widgets.
///
/// Each level may have several successors, made with different settings: that is the window's undo.
/// A job that fails or is cancelled leaves the levels that were finished.
class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(JobRunner& jobs, QObject* parent = nullptr);

    [[nodiscard]] bool isOpen() const { return !levels_.empty(); }
    [[nodiscard]] const CaseFile& file() const { return file_; }
    /// In the order they were made; a level comes after the one it was made from.
    [[nodiscard]] const std::vector<CaseLevel>& levels() const { return levels_; }
    /// Null when there is no such level.
    [[nodiscard]] const CaseLevel* level(int id) const;
    [[nodiscard]] const CaseLevel* current() const { return level(current_); }
    /// From the finest level to this one; empty when there is no such level.
    [[nodiscard]] Branch branch(int id) const;
    /// The branch through the current level, followed to its end along the latest successors.
    [[nodiscard]] Branch currentBranch() const;
    [[nodiscard]] std::vector<int> successors(int id) const;
    /// Nodes of another level at the place of a node; none where it is missing there.
    [[nodiscard]] std::optional<NodeId> sameNode(int from, NodeId node, int to) const;
    /// The command that makes the levels of a branch, or why there is none.
    [[nodiscard]] QString commandLine(int id, int threads) const;
    /// Names of the patches, by number, of all patches there are.
    [[nodiscard]] std::map<int, std::string> patches() const;

public slots:
    /// Opens a mesh, or the folder of a hierarchy. What is open stays until that has succeeded.
    void open(const QString& path);
    /// Opens a mesh with levels that lie in folders of hierarchies; parents come before children.
    void openStored(const QString& mesh, const std::vector<ameco::gui::StoredLevel>& stored);
    void close();
    /// Makes up to `options.levels` coarser levels from one.
    void coarsen(int from, const ameco::HierarchyOptions& options);
    /// Deletes a level and all made from it; the finest stays.
    void remove(int id);
    void setCurrent(int id);
    /// Computes on which level each node disappears, along the current branch, for the views.
    void prepareRemovedAt();
    /// Writes the levels of a branch into a folder, as `ameco coarsen` does.
    void exportBranch(int id, const QString& folder);
    /// Writes a level as a mesh in the format of the suffix.
    void exportMesh(int id, const QString& path);

signals:
    /// A mesh that is being opened can be looked at; `opened` follows, unless that is cancelled.
    void sketched(std::shared_ptr<const ameco::gui::SceneData> scene);
    void opened();
    void closed();
    void levelAdded(int id);
    void levelRemoved(int id);
    void levelChanged(int id); ///< its picture has new data
    void currentChanged(int id);
    void exported(const QString& folder);

private:
    void take(CaseFile file, std::vector<CaseLevel> levels);
    void add(CaseLevel level);
    void finishCoarsening(const HierarchyEnd& end, int last);

    JobRunner& jobs_;
    CaseFile file_;
    std::vector<CaseLevel> levels_;
    int next_id_ = 0;
    int current_ = -1;
};

} // namespace ameco::gui
