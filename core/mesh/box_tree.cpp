// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/box_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace ameco {

template <int D>
BoxTree<D>::BoxTree(const std::vector<Box<D>>& boxes) : items_(boxes.size()) {
    std::iota(items_.begin(), items_.end(), 0);
    if (!boxes.empty()) {
        nodes_.reserve(boxes.size());
        build(boxes, 0, static_cast<std::int32_t>(boxes.size()));
    }
}

template <int D>
std::int32_t BoxTree<D>::build(const std::vector<Box<D>>& boxes, std::int32_t begin,
                               std::int32_t end) {
    constexpr std::int32_t leaf_size = 4;
    const auto self = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({{}, -1, begin, end});
    Box<D> box, centres;
    for (std::int32_t i = begin; i < end; ++i) {
        const Box<D>& b = boxes[static_cast<std::size_t>(items_[static_cast<std::size_t>(i)])];
        box.extend(b);
        centres.extend(b.center());
    }
    nodes_[static_cast<std::size_t>(self)].box = box;
    if (end - begin <= leaf_size) {
        return self;
    }
    int axis = 0;
    centres.sizes().maxCoeff(&axis);
    const std::int32_t middle = begin + (end - begin) / 2;
    const auto centre = [&](std::int32_t item) {
        const Box<D>& b = boxes[static_cast<std::size_t>(item)];
        return b.min()[axis] + b.max()[axis];
    };
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](std::int32_t a, std::int32_t b) {
                         return std::pair(centre(a), a) < std::pair(centre(b), b);
                     });
    build(boxes, begin, middle);
    const std::int32_t right = build(boxes, middle, end);
    nodes_[static_cast<std::size_t>(self)].right = right;
    return self;
}

template <int D>
std::int32_t BoxTree<D>::find(const Vec<D>& p,
                              const std::function<bool(std::int32_t)>& visit) const {
    return first([&](const Box<D>& box) { return box.contains(p); }, visit);
}

template <int D>
void BoxTree<D>::visit(const std::function<bool(const Box<D>&)>& enters,
                       const std::function<void(std::int32_t)>& visit) const {
    (void)first(enters, [&](std::int32_t item) {
        visit(item);
        return false;
    });
}

template <int D>
std::int32_t BoxTree<D>::first(const std::function<bool(const Box<D>&)>& enters,
                               const std::function<bool(std::int32_t)>& takes) const {
    std::vector<std::int32_t> stack;
    if (!nodes_.empty()) {
        stack.push_back(0);
    }
    while (!stack.empty()) {
        const std::int32_t at = stack.back();
        stack.pop_back();
        const TreeNode& node = nodes_[static_cast<std::size_t>(at)];
        if (!enters(node.box)) {
            continue;
        }
        if (node.right >= 0) {
            stack.push_back(node.right);
            stack.push_back(at + 1);
            continue;
        }
        for (std::int32_t i = node.begin; i < node.end; ++i) {
            if (takes(items_[static_cast<std::size_t>(i)])) {
                return items_[static_cast<std::size_t>(i)];
            }
        }
    }
    return -1;
}

template <int D>
std::int32_t BoxTree<D>::nearest(const Vec<D>& p,
                                 const std::function<double(std::int32_t)>& distance,
                                 std::int32_t guess) const {
    std::int32_t best = guess;
    double best_distance = guess < 0 ? std::numeric_limits<double>::infinity() : distance(guess);
    std::vector<std::pair<double, std::int32_t>> stack;
    if (!nodes_.empty()) {
        stack.emplace_back(0.0, 0);
    }
    while (!stack.empty()) {
        const auto [bound, at] = stack.back();
        stack.pop_back();
        if (bound > best_distance) {
            continue;
        }
        const TreeNode& node = nodes_[static_cast<std::size_t>(at)];
        if (node.right >= 0) {
            const auto d = [&](std::int32_t child) {
                return nodes_[static_cast<std::size_t>(child)].box.exteriorDistance(p);
            };
            std::pair near{d(at + 1), at + 1}, far{d(node.right), node.right};
            if (far.first < near.first) {
                std::swap(near, far);
            }
            stack.push_back(far);
            stack.push_back(near);
            continue;
        }
        for (std::int32_t i = node.begin; i < node.end; ++i) {
            const std::int32_t item = items_[static_cast<std::size_t>(i)];
            const double d = distance(item);
            if (std::pair(d, item) < std::pair(best_distance, best) || best < 0) {
                best_distance = d;
                best = item;
            }
        }
    }
    return best;
}

template class BoxTree<2>;
template class BoxTree<3>;

} // namespace ameco
