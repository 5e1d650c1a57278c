// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the document has its worker threads do. Nothing here knows a widget or a signal.
#pragma once

#include "core/hierarchy/build_hierarchy.h"
#include "gui/model/case_level.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ameco::gui {

/// A case that has been read: its finest level first.
struct LoadedCase {
    CaseFile file;
    std::vector<CaseLevel> levels; ///< with ids from 0 on
};

/// Takes a picture's data of a mesh that has been read and found valid, but not measured yet.
using Sketch = std::function<void(std::shared_ptr<const SceneData>)>;

/// Reads a mesh and measures it. A surface without elements is taken too: it can be looked at.
/// \param sketch  called as soon as there is something to see
/// \throws Error
[[nodiscard]] LoadedCase read_case(const std::filesystem::path& path, const Sketch& sketch,
                                   Monitor& monitor);

/// Reads the folder of a hierarchy (or its hierarchy.json): all levels whose files are whole.
/// \throws Error
[[nodiscard]] LoadedCase read_hierarchy_case(const std::filesystem::path& path, Monitor& monitor);

/// Reads a mesh, and levels made from it. One that cannot be read is told to the monitor and left
/// out, and those made from it.
/// \param stored  parents before children; keys become the levels' ids, 0 is the finest
/// \throws Error
[[nodiscard]] LoadedCase read_stored_case(const std::filesystem::path& mesh,
                                          const std::vector<StoredLevel>& stored, Monitor& monitor);

/// Makes levels from `from`, one by one.
/// \param max_aspect_ratio  upper edge of the aspect-ratio classes: that of the finest level
/// \param sink              gets each level when it is finished; its id and parent are not set
HierarchyEnd make_case_levels(const CaseLevel& from, double max_aspect_ratio,
                              const HierarchyOptions& options,
                              const std::function<void(CaseLevel)>& sink, Monitor& monitor);

/// The same level with the number of the level where each node is missing first.
[[nodiscard]] std::shared_ptr<const SceneData> with_removed_at(const CaseLevel& level,
                                                               std::vector<int> removed_at);

/// For each node of `branch[k]` the number of the first level of the branch without it; 0 for nodes
/// that are on all of them.
[[nodiscard]] std::vector<int> removal_levels_of(const std::vector<CaseLevel>& branch,
                                                 std::size_t k);

/// Writes a branch into a folder, with the files that `ameco coarsen` writes.
/// \throws Error
void write_branch(const CaseFile& file, const std::vector<CaseLevel>& branch,
                  const std::filesystem::path& folder, Monitor& monitor);

} // namespace ameco::gui
