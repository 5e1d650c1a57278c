// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A wall pushed out along its columns: the way all of our boundary-layer meshes are made.
///
/// Every wall node is the foot of a column of nodes, one per layer. A wall facet and two
/// consecutive layers bound a prism (a quadrilateral in 2-D), which is split into D simplices.
/// Which diagonal a side of the prism gets depends only on the ranks of its two columns in that
/// layer, so both prisms beside it agree and the mesh conforms by itself; because the ranks are an
/// order, no prism gets the three cyclic diagonals that cannot be split. (Dompierre et al., How to
/// subdivide pyramids, prisms and hexahedra into tetrahedra, 1999.) Splitting hexahedra instead
/// would invert elements where their sides are warped.
#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace ameco {

/// How the diagonals of quadrilaterals are chosen.
enum class Diagonals {
    uniform,     ///< all in the same direction
    alternating, ///< neighbours in opposite directions
    columns,     ///< at random, the same in all layers
    random       ///< at random, different from layer to layer
};

/// The wall: facets whose corners are columns, seen counter-clockwise from the side the columns
/// lead to (D = 3), or with that side on the left (D = 2).
template <int D>
struct Wall {
    /// The border of the wall at one facet, from which a side of the domain grows.
    struct Side {
        std::size_t facet;
        int opposite; ///< the facet's corner that is not on the border
        int patch;
    };

    std::size_t columns = 0;
    std::vector<std::array<int, D>> facets;
    std::vector<Side> sides;
};

/// Order of the columns in a layer: a diagonal leads from the foot of the column of lower rank to
/// the top of the other. Equal ranks are ordered by column.
using ColumnRank = std::function<std::uint64_t(std::size_t column, std::size_t layer)>;

/// Ranks for the ways of `Diagonals`. For `alternating` the columns must be numbered so that
/// `parity` of neighbours differs; the others ignore it.
[[nodiscard]] ColumnRank column_rank(Diagonals diagonals, std::uint64_t seed,
                                     std::function<int(std::size_t column)> parity = {});

/// Fills the space between the wall and the last layer.
///
/// \param points      positions, layer by layer: column c of layer k is points[k * columns + c]
/// \param wall_patch  patch of the wall itself
/// \param top_patch   patch of the last layer
/// \return            one element region; nodes in the order of `points`
/// \throws UsageError if an element is not positive (exact signs): columns that lean too far over
/// the
///         wall, as where few cells go around a sharp curve
template <int D>
[[nodiscard]] Mesh<D> extrude(const Wall<D>& wall, std::vector<Vec<D>> points,
                              const ColumnRank& rank, int wall_patch, int top_patch);

/// The layers that remain when only every n-th of the layers 0 ... `layers` is kept: the wall and
/// the last one always do.
[[nodiscard]] std::vector<std::size_t> kept_layers(std::size_t layers, int every);

} // namespace ameco
