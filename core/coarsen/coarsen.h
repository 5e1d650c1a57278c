// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// One level: mesh and natural metric in, coarser mesh and report out.
#pragma once

#include "core/base/monitor.h"
#include "core/coarsen/removal.h"
#include "core/coarsen/target_metric.h"
#include "core/mesh/check.h"
#include "core/metric/conformity.h"
#include "core/metric/nodal_metric.h"
#include "core/remesh/geometry_classes.h"
#include "core/remesh/swap.h"
#include "core/remesh/swap_lengths.h"
#include "core/remesh/verdict.h"

namespace ameco {

/// Where the nodes of a coarse level are.
enum class CoarseNodes {
    nested, ///< where nodes of the fine one are
    moved   ///< where the target metric wants them; \see fit_level.h
};

inline constexpr std::array all_coarse_nodes{CoarseNodes::nested, CoarseNodes::moved};

[[nodiscard]] std::string_view name(CoarseNodes nodes);
[[nodiscard]] std::optional<CoarseNodes> coarse_nodes_from_name(std::string_view name);

/// How levels with moved nodes are brought nearer to their metric.
struct FitOptions {
    int passes = 2;         ///< of swaps and moves, >= 1
    double stretched = 8;   ///< nodes stay where the target metric has this aspect ratio or more,
                            ///< and elements among them as they are: lines across layers [-]
    double farthest = 0.35; ///< a node moves, in the metric: so near that its old place remains
                            ///< among its elements, and fine nodes take values from it [-]
    SwapOptions swaps{.below = 0.8, .gain = 1.01, .rounds = 2};
};

struct CoarsenOptions {
    Mean mean = Mean::blended;
    TargetOptions target;
    FeatureOptions features;
    LineOptions lines;
    RemovalOptions removal; ///< with the rules for the boundary, which the swaps obey too
    /// A third round would mend one element in a thousand.
    SwapOptions swaps{.rounds = 2, .below_again = 0.75};
    int passes = 6;               ///< removal passes, >= 1; swaps come after each
    LengthSwapOptions lengths;    ///< after the last of them
    double least_stiffness = 0.4; ///< no swap may bring a node's diagonal of the Laplacian below
                                  ///< this times that of the fine mesh [-]
    CoarseNodes nodes = CoarseNodes::nested;
    FitOptions fit;                     ///< for moved nodes
    std::size_t nodes_per_part = 32768; ///< for threads, see `part_count`; smaller parts have more
                                        ///< nodes at their borders, which wait for the others
};

/// Wall-clock seconds of one level, by phase.
struct PhaseSeconds {
    double metric = 0;     ///< target metric; natural metric of the coarse mesh
    double order = 0;      ///< couplings, front order, lines
    double first_pass = 0; ///< the first removal pass
    double remove = 0;     ///< the later ones
    double swap = 0;       ///< all swaps
    double fit = 0;        ///< moves of nodes, with their swaps
    double check = 0;      ///< check and conformity of the result
    [[nodiscard]] double total() const {
        return metric + order + first_pass + remove + swap + fit + check;
    }
};

struct CoarsenReport {
    std::int64_t nodes_before = 0, nodes_after = 0;
    std::int64_t elements_before = 0, elements_after = 0;
    double factor = 0; ///< coarse size over fine size that was asked for
    double predicted_nodes =
        0; ///< nodes_before times the quotient of expected_nodes, target over natural
    VerdictCounts removal, swaps, moves;
    std::int64_t removed_in_first_pass = 0;
    std::int64_t line_nodes = 0; ///< nodes on lines across layers, before
    std::int64_t lines = 0;
    double deviation = 0;          ///< bound of the boundary's distance to the finest one [L]
    double deviation_relative = 0; ///< largest bound of a face over its own mean edge [-]
    Conformity conformity;         ///< of the coarse mesh to the target metric
    PhaseSeconds seconds;
    CheckReport check; ///< of the coarse mesh: always made, always valid
};

/// A mesh of a hierarchy with what the next step needs.
template <int D>
struct Level {
    Mesh<D> mesh;
    GeometryClasses<D> geometry;
    MetricField<D> natural;          ///< natural metric at its nodes
    IdVector<NodeId, NodeId> parent; ///< [n] the node of the next finer level that it is
};

/// Makes level 0 from a valid mesh: geometry classes and natural metric.
template <int D>
[[nodiscard]] Level<D> finest_level(Mesh<D> mesh, const CoarsenOptions& options,
                                    Monitor& monitor = Monitor::silent());

/// Steps in which sizes grow by `factor`: each near 2, so that a removed node always has neighbours
/// that stay. The levels between them are forgotten.
[[nodiscard]] int coarsening_steps(double factor);

/// Makes the next coarser level. The nodes of the result are nodes of `fine`, in the same order,
/// moved if the options say so.
///
/// \throws Cancelled when asked to stop; nothing is left half done
/// \see docs/theory/coarsening.md
template <int D>
[[nodiscard]] Level<D> coarsen(const Level<D>& fine, const CoarsenOptions& options,
                               CoarsenReport& report, Monitor& monitor = Monitor::silent());

} // namespace ameco
