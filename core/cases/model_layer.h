// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The paper's 2-D model of a boundary layer.
#pragma once

#include "core/cases/extrusion.h"

namespace ameco {

/// A strip of stretched triangles over a wall that turns by `angle_deg` at its middle node, as in
/// section 2.3.5 and figure 1: there, metrics of elements that point in different directions meet.
///
/// The wall has `cells` edges of length 1 (h_max) on each side of the turn; `layers` layers of
/// height h_min = 1 / stretching follow both halves in parallel, and the middle column lies on the
/// bisector. The node in the middle of that column is the central node of the figure.
struct ModelLayerOptions {
    double angle_deg = 20;    ///< the wall's turn [deg], -90 ... 90: > 0 convex, < 0 concave
    double stretching = 1000; ///< h_max / h_min [-], >= 1
    int cells = 2;            ///< on each side of the turn, >= 1
    int layers = 4;           ///< >= 1
    Diagonals diagonals = Diagonals::uniform;
    int seed = 1;    ///< of random diagonals
    int every = 1;   ///< keep every n-th layer, >= 1
    int shuffle = 0; ///< seed of a random numbering; 0 keeps layer by layer
};

/// \throws UsageError if the layers over a concave turn are thicker than its edges are long
[[nodiscard]] Mesh<2> make_model_layer(const ModelLayerOptions& options = {});

} // namespace ameco
