// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Lines of strongly coupled nodes across the layers of a mesh.
#pragma once

#include "core/mesh/mesh.h"
#include "core/remesh/couplings.h"

#include <array>
#include <cstdint>

namespace ameco {

/// Chains of nodes that are coupled to their two neighbours on the chain much more strongly than to
/// any other node: the lines along which a boundary layer is coarsened. One node too many that
/// leaves a single line makes the two-grid factor jump from 1/9 to above 0.9, and no statistic of
/// the mesh shows it; so lines are explicit, and kept whole.
struct Lines {
    IdVector<NodeId, NodeId> previous, next; ///< none at an end of a line and off the lines
    IdVector<NodeId, std::int32_t> position; ///< 0, 1, ... from the wall end; -1 off the lines
    /// Whether the gap between a node and `next` lost a node already; then neither end may go.
    IdVector<NodeId, std::uint8_t> gap_used;
    std::int64_t count = 0;      ///< number of lines
    std::int64_t node_count = 0; ///< number of nodes on them

    [[nodiscard]] bool on_line(NodeId v) const { return position[v] >= 0; }
    /// Whether a and b follow each other on a line.
    [[nodiscard]] bool linked(NodeId a, NodeId b) const {
        return a.valid() && b.valid() && (next[a] == b || next[b] == a);
    }
    /// Whether a gap beside `v` lost a node already.
    [[nodiscard]] bool beside_used_gap(NodeId v) const {
        return gap_used[v] != 0 || (previous[v].valid() && gap_used[previous[v]] != 0);
    }
    /// Takes `v` off its line: the two gaps beside it become one, marked as used. Where `v` was an
    /// end, the new end is marked.
    void remove(NodeId v);
};

struct LineOptions {
    double dominance = 2;         ///< strong coupling over the next weaker one [-], >= 1
    double continuation = 1.4;    ///< the same beyond an end of a line found so [-], >= 1
    double largest_cosine = -0.3; ///< of the angle between the two strong edges at a node
};

/// The nodes before and after each node on a chain, in any order; none where there is no such.
using LineLinks = IdVector<NodeId, std::array<NodeId, 2>>;

/// Finds the lines of a mesh, without a direction. A node is inside a line if its two strongest
/// couplings point in opposite directions and exceed the third `dominance` times, an end if only
/// its strongest exceeds the second; links must be mutual. Where a third neighbour is much nearer
/// than the strongest one there is no line: lines follow the short edges.
///
/// From its ends a line goes on along weaker couplings, `continuation` instead of `dominance`, and
/// may join another one: where layers are bent or oblique, columns side by side would end in
/// different layers, and then lose the nodes of different ones.
template <int D>
[[nodiscard]] LineLinks link_lines(const Mesh<D>& mesh, const Couplings& couplings,
                                   const LineOptions& options = {});

/// Numbers the nodes of lines.
/// \param key  distance from the walls [-]: each line is numbered from the end where it is smaller;
///             lines between two walls from the lower end along the axis they follow most
template <int D>
[[nodiscard]] Lines number_lines(const Mesh<D>& mesh, const LineLinks& links,
                                 const IdVector<NodeId, double>& key);

/// Finds the lines of a mesh and numbers their nodes: `link_lines`, `number_lines`.
template <int D>
[[nodiscard]] Lines find_lines(const Mesh<D>& mesh, const Couplings& couplings,
                               const IdVector<NodeId, double>& key,
                               const LineOptions& options = {});

} // namespace ameco
