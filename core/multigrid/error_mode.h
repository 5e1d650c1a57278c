// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Where multigrid is slow: the error that stays, the nodes that carry it, and what is wrong there.
#pragma once

#include "core/multigrid/invariants.h"

#include <string>
#include <vector>

namespace ameco {

/// One of the nodes that carry the slowest error.
template <int D>
struct SlowNode {
    NodeId node;                   ///< of the fine mesh
    Vec<D> point = Vec<D>::Zero(); ///< [L]
    double share = 0;              ///< of the error's sum a_vv e_v^2
    bool kept = false;             ///< has a coarse node at its place
    bool on_line = false;
    int gap = 0;                      ///< nodes removed in a row on its line, with it
    double removed_coupling = 0;      ///< to removed neighbours, over a_vv
    double interpolated_coupling = 1; ///< to the nodes it is interpolated from, over a_vv
    double interpolation = 0;         ///< interpolation constant, 0 of kept nodes
    double largest_weight = 1;        ///< in its row of P
    double galerkin_ratio = 0;        ///< largest of the coarse nodes it is interpolated from
    bool projected = false;
    std::string findings; ///< what is wrong, in words; "nothing conspicuous" if nothing is
};

template <int D>
struct ErrorMode {
    IdVector<NodeId, double> field; ///< the error at all fine nodes, largest modulus 1
    std::int64_t carriers = 0;      ///< nodes that carry 90 % of it
    std::vector<SlowNode<D>> worst; ///< five nodes, far enough apart not to be neighbours
};

/// Looks at the slowest error of a two-grid cycle between two levels.
///
/// \param error     at the unknowns of the fine level
/// \param diagonal  a_vv of the fine unknowns
/// \param unknowns  fine nodes without Dirichlet condition
/// \param ratios    (P^T A P)_ii / (A_c)_ii at all coarse nodes, 0 where there is no unknown
template <int D>
[[nodiscard]] ErrorMode<D>
examine_error(const Mesh<D>& fine, const LevelStructure& structure, const Transfer& transfer,
              const Vector& error, const Vector& diagonal, const std::vector<NodeId>& unknowns,
              const IdVector<NodeId, double>& ratios, int count = 5);

} // namespace ameco
