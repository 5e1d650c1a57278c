// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One level of the open case, as data.
#pragma once

#include "core/coarsen/coarsen.h"
#include "core/hierarchy/hierarchy.h"
#include "gui/scene/scene_data.h"

#include <memory>
#include <variant>
#include <vector>

namespace ameco::gui {

using AnyLevel = std::variant<Level<3>, Level<2>>;

/// One level in the tree. What is large is shared and never changes.
struct CaseLevel {
    int id = 0;      ///< never used again after the level is deleted
    int parent = -1; ///< id of the level it was made from; -1: the finest
    int number = 0;  ///< steps from the finest

    HierarchyOptions options; ///< with which it was made; the factor is the one that was used
    LevelStatistics statistics;
    LevelTiming timing;
    std::shared_ptr<const AnyLevel> level;
    std::shared_ptr<const SceneData> scene;
    ConformityClasses conformity; ///< to the metric asked for; of the finest to its natural metric
};

/// A level on disk, as a session or a hierarchy's folder lists it.
struct StoredLevel {
    int key = 0;         ///< names it among the stored ones
    int parent_key = -1; ///< -1: the finest
    int number = 0;      ///< of the level in the folder
    std::string folder;  ///< of a hierarchy
    HierarchyOptions options;
};

/// The case's file.
struct CaseFile {
    std::string path;   ///< as it was opened, absolute
    std::string format; ///< "Medit binary, version 2"
    int dimension = 3;
    BoundaryRepair repair;
};

} // namespace ameco::gui
