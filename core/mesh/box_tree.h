// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A tree of axis-parallel boxes: which boxes hold a point, which is nearest to it.
#pragma once

#include "core/base/vec.h"

#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Geometry>

namespace ameco {

template <int D>
using Box = Eigen::AlignedBox<double, D>;

/// A binary tree over n boxes, split at the median of the boxes' centres along the longest axis.
/// Reading it from several threads is safe.
template <int D>
class BoxTree {
public:
    explicit BoxTree(const std::vector<Box<D>>& boxes);

    /// Calls `visit(item)` for every box that holds `p`, its border included, until one returns
    /// true; returns that item, or -1.
    [[nodiscard]] std::int32_t find(const Vec<D>& p,
                                    const std::function<bool(std::int32_t)>& visit) const;

    /// Calls `visit(item)` for every item of the tree nodes whose box passes `enters`, a test that
    /// a box passes if one inside it does. In no order that means anything; boxes of single items
    /// are not tested.
    void visit(const std::function<bool(const Box<D>&)>& enters,
               const std::function<void(std::int32_t)>& visit) const;

    /// The item at the smallest distance, or -1 for an empty tree. Of items at equal distance the
    /// one with the smallest number.
    /// \param distance  distance from `p` to what is in the box, >= distance to the box
    /// \param guess     an item that may be near, which spares a part of the search; -1: none
    [[nodiscard]] std::int32_t nearest(const Vec<D>& p,
                                       const std::function<double(std::int32_t)>& distance,
                                       std::int32_t guess = -1) const;

private:
    struct TreeNode {
        Box<D> box;
        std::int32_t right = -1;         ///< the left child follows at once; -1 at a leaf
        std::int32_t begin = 0, end = 0; ///< of a leaf, in items_
    };
    std::int32_t build(const std::vector<Box<D>>& boxes, std::int32_t begin, std::int32_t end);
    [[nodiscard]] std::int32_t first(const std::function<bool(const Box<D>&)>& enters,
                                     const std::function<bool(std::int32_t)>& takes) const;

    std::vector<TreeNode> nodes_;
    std::vector<std::int32_t> items_;
};

} // namespace ameco
