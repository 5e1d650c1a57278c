// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Why an operation was done or refused, as an enum we can count.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ameco {

enum class Verdict : std::uint8_t {
    accepted,
    geometry_class,   ///< a corner, a required or an interface node, or off its ridge or patch
    gap,              ///< a gap of the line beside the node already lost a node
    line_order,       ///< not an odd node of its line, or not a neighbour on the line
    weak_coupling,    ///< a removed node would hang on nodes it is weakly coupled with
    coupling_bound,   ///< too much of the node's stencil is removed already
    inverts_element,  ///< a new element would have no positive volume
    low_quality,      ///< the worst new element is below the floor
    no_improvement,   ///< a swap that does not raise the worst quality enough
    link_condition,   ///< the boundary would touch itself
    surface_normal,   ///< the boundary would turn too far
    surface_distance, ///< the boundary would move too far
    breaks_line,      ///< layer elements without an edge across the layer would appear
    cavity_too_large, ///< more elements around the edge than a re-star is tried on
    region_border,    ///< elements of several regions, or a face inside the domain
    short_edge,       ///< a split would leave an edge that is too short
    long_edge,        ///< a collapse would leave an edge that is too long
    stiff_element,    ///< a swap would leave the coarse matrix stiff at a node
    soft_element      ///< a swap would leave the coarse matrix soft at a node
};

inline constexpr std::size_t verdict_count = 19;

[[nodiscard]] std::string_view name(Verdict verdict);

/// How often each verdict was given.
struct VerdictCounts {
    std::array<std::int64_t, verdict_count> counts{};

    void add(Verdict v) { ++counts[static_cast<std::size_t>(v)]; }
    void add(const VerdictCounts& more) {
        for (std::size_t i = 0; i < verdict_count; ++i) {
            counts[i] += more.counts[i];
        }
    }
    [[nodiscard]] std::int64_t operator[](Verdict v) const {
        return counts[static_cast<std::size_t>(v)];
    }
};

} // namespace ameco
