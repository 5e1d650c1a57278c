// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Prolongation from a coarse mesh to a fine one, as a sparse matrix; restriction is its transpose.
#pragma once

#include "core/base/monitor.h"
#include "core/mesh/mesh.h"
#include "core/multigrid/sparse.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ameco {

/// How a fine node gets its value from the coarse mesh.
enum class TransferKind : std::uint8_t {
    nested,       ///< it is a coarse node: injected, one weight of 1
    interpolated, ///< linear interpolation in the coarse element, or boundary face, that holds it
    projected ///< it is not in the coarse domain, or not on the coarse boundary as it should be:
              ///< interpolation at the nearest point of the coarse boundary of its patch
};

/// Linear interpolation from a coarse mesh (n_c nodes) to a fine one (n_f nodes):
///
///     u_f = P u_c,    r_c = P^T r_f
///
/// Rows hold the barycentric weights, in [0, 1], of the fine node in its coarse element.
struct Transfer {
    SparseMatrix P;                      ///< [n_f, n_c]
    IdVector<NodeId, TransferKind> kind; ///< [n_f]
    IdVector<NodeId, NodeId> parent;     ///< [n_c] fine node at the same place, or none
    double largest_projection = 0;       ///< distance of the farthest projected node [L]
};

/// Locates every fine node in the coarse mesh.
///
/// Nodes of the fine boundary are located on the coarse boundary of their own patches, and between
/// patches on the lines between them, so that boundary values depend on boundary values only.
/// Inner nodes are located by a walk with exact orientation tests from the nearest coarse node.
///
/// \param parent  [n_c] fine node that each coarse one is, as `coarsen` returns it; those at
/// another
///                place are not used. Empty: nodes with equal coordinates are matched
/// \throws Cancelled when asked to stop
/// \see docs/theory/transfer.md
template <int D>
[[nodiscard]] Transfer make_transfer(const Mesh<D>& fine, const Mesh<D>& coarse,
                                     const IdVector<NodeId, NodeId>& parent = {},
                                     Monitor& monitor = Monitor::silent());

/// For each coarse node the fine node with the same coordinates, or none.
template <int D>
[[nodiscard]] IdVector<NodeId, NodeId> match_nodes(const Mesh<D>& fine, const Mesh<D>& coarse);

/// What must hold of every transfer, measured.
struct TransferCheck {
    std::int64_t nested = 0, interpolated = 0, projected = 0;
    double row_sum_error = 0; ///< largest |sum of a row - 1|; at most 1e-12
    double linear_error = 0;  ///< largest error of the coordinates, away from projected nodes, over
                              ///< the domain's diagonal; at most 1e-10
    double smallest_weight = 0, largest_weight = 0; ///< in [0, 1]
    std::int64_t empty_columns = 0; ///< coarse nodes nobody refers to: make P^T A P singular
    double sum_error = 0;           ///< |sum of P^T r - sum of r| / sum of |r|; at most 1e-12
    double largest_projection = 0;  ///< [L]

    [[nodiscard]] bool passed() const;
    /// One line: what does not hold; empty if all holds.
    [[nodiscard]] std::string failures() const;
};

template <int D>
[[nodiscard]] TransferCheck check(const Transfer& transfer, const Mesh<D>& fine,
                                  const Mesh<D>& coarse);

} // namespace ameco
