// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// When the elements at each node changed last, so that what failed is tried again only where
/// something is new.
#pragma once

#include "core/base/id.h"

#include <algorithm>
#include <span>
#include <vector>

namespace ameco {

/// Clocks, and the time of the last change at every node.
///
/// Threads that edit parts of a mesh have a lane, and so a clock, each: what they see of times is
/// then the same for any number of threads.
class ChangeTimes {
public:
    using Time = int; ///< 0: before everything

    explicit ChangeTimes(std::size_t nodes) : changed_(nodes, 0), clocks_(1) {}

    /// Starts so many clocks at the latest time that any has reached.
    void open_lanes(std::size_t count) {
        Clock latest;
        for (const Clock& clock : clocks_) {
            latest.now = std::max(latest.now, clock.now);
        }
        clocks_.assign(count, latest);
    }

    [[nodiscard]] Time now(std::size_t lane = 0) const { return clocks_[lane].now; }
    /// Starts a new time, and returns it.
    Time tick(std::size_t lane = 0) { return ++clocks_[lane].now; }

    /// Says that the elements at a node change now.
    void touch(NodeId v, std::size_t lane = 0) { changed_[v] = clocks_[lane].now; }
    [[nodiscard]] bool changed_since(NodeId v, Time time) const { return changed_[v] >= time; }
    /// The corners of an element that have changed, as bits. What shares an edge or a face with the
    /// element may have changed only if all ends of that have.
    [[nodiscard]] unsigned changed_corners(std::span<const NodeId> element, Time time) const {
        unsigned corners = 0;
        for (std::size_t i = 0; i < element.size(); ++i) {
            corners |= changed_since(element[i], time) ? 1U << i : 0U;
        }
        return corners;
    }
    /// Whether an edge may have, with the elements at it.
    [[nodiscard]] static bool has_edge(unsigned corners) { return (corners & (corners - 1)) != 0; }

    /// A node more, that changes now, or the last one fewer.
    void add_node() { changed_.push_back(now()); }
    void drop_last_node() { changed_.pop_back(); }

private:
    /// Apart from others in memory.
    struct alignas(64) Clock {
        Time now = 1;
    };
    IdVector<NodeId, Time> changed_;
    std::vector<Clock> clocks_;
};

} // namespace ameco
