// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The ONERA M6 wing with viscous layers, by formula.
#pragma once

#include "core/cases/extrusion.h"
#include "core/cases/onera_d.h"

#include <string>
#include <string_view>
#include <vector>

namespace ameco {

/// Half a wing (symmetry plane y = 0) in a far field of about ten mean chords.
///
/// The wall is an O-grid of planar sections from the root to the tip, which half a body of
/// revolution closes. Every column leaves its wall node on a confocal hyperbola of its section's
/// plane, and the sections spread apart with the distance from the wing. Heights along a column:
/// `growth_layers` layers that grow by `growth` from `first_height`, then one ratio for the rest,
/// so that the last layer meets the far field.
///
/// Planform: root chord 0.8059 m, half span 1.1963 m, leading edge swept by 30, trailing edge by
/// 15.8 degrees, no twist, ONERA D section. Patches: 1 wing, 2 symmetry, 3 farfield.
///
/// Nodes: (2 chord_cells (span_cells + 1) + (cap_cells - 1)(chord_cells - 1)) (layers + 1).
/// The defaults are the preset "m6-67k".
struct OneraM6Options {
    int chord_cells = 32;       ///< from the leading to the trailing edge, on each side, >= 4
    int span_cells = 20;        ///< from root to tip, >= 2
    int cap_cells = 6;          ///< around the tip, from the upper to the lower side, >= 3
    int layers = 44;            ///< > growth_layers
    int growth_layers = 16;     ///< layers that grow by `growth`, >= 1
    double first_height = 4e-4; ///< of the layer at the wall [m], > 0
    double growth = 1.22;       ///< of heights near the wall [-], >= 1
    double far_field = 6.46;    ///< half axis of the far ellipses [m], >= 2
    double spread = 4;          ///< distance of sections, far field over wing [-], >= 1

    /// Spacing along the section [chords]; only their ratios count, the number of cells scales
    /// them.
    double leading_size = 0.002;
    double trailing_size = 0.00034;
    double largest_size = 0.04;

    /// Columns around the middle of the upper side may start with thinner layers, which double
    /// until they are as high as the others: r cells away, first_height is multiplied by min(1,
    /// thin_ratio (1 + r / thin_reach)^thin_power).
    double thin_ratio = 1; ///< in (0, 1]; 1 for none
    double thin_reach = 1; ///< [cells], > 0
    double thin_power = 1; ///< > 0

    TrailingEdge trailing_edge = TrailingEdge::rounded;
    Diagonals diagonals = Diagonals::columns;
    int seed = 1;    ///< of random diagonals
    int every = 1;   ///< keep every n-th layer, >= 1
    int shuffle = 0; ///< seed of a random numbering; 0 keeps layer by layer
};

/// A set of options under a name.
struct OneraM6Preset {
    std::string name;
    OneraM6Options options;
};

/// m6-8k for demonstrations, m6-67k and m6-2m as in the paper's tables 2 and 3, m6-500k between.
[[nodiscard]] const std::vector<OneraM6Preset>& onera_m6_presets();

/// \throws UsageError if the growing layers alone reach the far field, leave no layer for the rest,
/// or
///         are too few for thinned columns to catch up with the others
[[nodiscard]] Mesh<3> make_onera_m6(const OneraM6Options& options = {});

} // namespace ameco
