// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// `coarsen --transfer`: the transfer between each level and the next finer one.
#pragma once

#include "core/hierarchy/hierarchy_folder.h"

namespace ameco::cli {

/// Writes the transfers of a hierarchy while it is made.
template <int D>
class LevelTransfers {
public:
    /// Writes those of levels that are there already and lack theirs. Refers to both.
    LevelTransfers(HierarchyFolder& folder, Monitor& monitor);

    /// For a level the folder has just received: levels must come in order.
    void add(const Level<D>& level, int number);

private:
    void write(int number, const Mesh<D>& coarse, const IdVector<NodeId, NodeId>& parent);

    HierarchyFolder& folder_;
    Monitor& monitor_;
    Mesh<D> finer_; ///< the level before the next one
};

} // namespace ameco::cli
