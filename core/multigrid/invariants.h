// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What two successive levels must have in common for multigrid to converge, counted.
#pragma once

#include "core/mesh/mesh.h"
#include "core/multigrid/transfer.h"
#include "core/remesh/couplings.h"
#include "core/remesh/lines.h"
#include "core/remesh/removed_nodes.h"

namespace ameco {

/// A number per pair of levels, and the place where it is worst.
template <int D>
struct WorstPlace {
    double value = 0;
    NodeId node;                   ///< fine node unless said otherwise; none if nothing is wrong
    Vec<D> point = Vec<D>::Zero(); ///< [L]
};

/// Properties of one step of coarsening. The fine nodes without coarse node at their place are the
/// *removed* ones; couplings c_vw = -a_vw are those of the fine mesh's Laplacian.
template <int D>
struct PairInvariants {
    std::int64_t line_nodes = 0; ///< fine nodes on lines
    std::int64_t coarse_line_nodes = 0;
    std::int64_t gaps = 0;         ///< places on fine lines where two or more in a row were removed
    std::int64_t gaps_at_ends = 0; ///< those among them that reach an end of their line
    WorstPlace<D> longest_gap;     ///< number removed in a row; at most 1 is good
    std::int64_t stuck = 0;        ///< three or more in a row on a fine line that were all kept

    /// Coarse elements whose nodes all are on lines but which have no edge that is part of a line.
    std::int64_t lineless_elements = 0;
    double lineless_share = 0; ///< of all coarse elements; at most 0.0005
    WorstPlace<D> lineless;    ///< one of them: value 1; its first node, of the coarse mesh

    /// max over removed v of sum c_vw over removed w, over a_vv: how far a removed node hangs on
    /// others that were removed. 0 in layers, at most 0.9 elsewhere.
    WorstPlace<D> ff;
    std::int64_t ff_exceeded = 0; ///< removed nodes above 0.9

    /// max of `interpolation_constant` over the removed nodes inside the domain.
    WorstPlace<D> interpolation;
    std::int64_t interpolation_exceeded = 0; ///< removed nodes above 5

    /// max of (P^T A P)_ii / (A_c)_ii over the coarse unknowns: how much stiffer the fine mesh sees
    /// a coarse basis function than the coarse mesh does. At most 1.5 is good; above 2 a
    /// stand-alone V(1,1) may diverge. The place is a coarse node.
    WorstPlace<D> galerkin_ratio;
    std::int64_t galerkin_exceeded = 0; ///< coarse unknowns above 2
};

/// A level's couplings and lines; the parts of the diagnosis that are costly.
struct LevelStructure {
    Couplings couplings;
    Lines lines;
};

template <int D>
[[nodiscard]] LevelStructure level_structure(const Mesh<D>& mesh, const LineOptions& options = {});

/// How well a removed node is held by what it is interpolated from: the sum of c_vw over those
/// coarse nodes, over a_vv. Near 1 in layers; 0 means that
/// it is interpolated from nodes it is not coupled with at all. 1 for nodes that were kept.
[[nodiscard]] double interpolated_coupling(const Couplings& couplings, const Transfer& transfer,
                                           NodeId v);

/// `interpolation_constant` of a removed node in the final mesh; 0 for nodes that were kept, and
/// for those whose coarse element has nodes that were moved.
[[nodiscard]] double interpolation_constant(const Couplings& couplings, const Transfer& transfer,
                                            NodeId v);

/// Sum of c_vw over removed neighbours w, over a_vv.
[[nodiscard]] double removed_coupling(const Couplings& couplings,
                                      const IdVector<NodeId, NodeId>& coarse_of, NodeId v);

/// The coarse node at the place of each fine one, or none.
[[nodiscard]] IdVector<NodeId, NodeId> coarse_of(const Transfer& transfer);

/// Number of consecutive removed nodes of a line around (and with) `v`; 0 if `v` was kept or is off
/// the lines.
[[nodiscard]] int gap_at(const Lines& lines, const IdVector<NodeId, NodeId>& coarse_of, NodeId v);

/// (P^T A P)_ii / (A_c)_ii of the coarse unknowns.
[[nodiscard]] Vector galerkin_ratios(const SparseMatrix& A, const SparseMatrix& P,
                                     const SparseMatrix& coarse_A);

/// \param ratios  `galerkin_ratios`, one per entry of `unknowns`
/// \param unknowns  coarse nodes without Dirichlet condition
template <int D>
[[nodiscard]] PairInvariants<D>
pair_invariants(const Mesh<D>& fine, const LevelStructure& fine_structure, const Mesh<D>& coarse,
                const LevelStructure& coarse_structure, const Transfer& transfer,
                const Vector& ratios, const std::vector<NodeId>& unknowns);

} // namespace ameco
