// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A sequence of meshes, finest first, and what was measured on each of them.
#pragma once

#include "core/coarsen/coarsen.h"
#include "core/mesh/boundary.h"
#include "core/metric/aspect_ratio.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ameco {

/// How the making of a hierarchy stands.
enum class HierarchyStatus {
    in_progress, ///< being made, or the program was killed while it was
    complete,    ///< has all the levels that were asked for
    exhausted,   ///< the last level cannot be coarsened further
    cancelled    ///< the user stopped it
};

[[nodiscard]] std::string_view name(HierarchyStatus status);

struct HierarchyOptions {
    CoarsenOptions coarsen;
    int levels = 4; ///< coarse levels to make, >= 1
    /// Factors of the levels 1, 2, ...; the last one is that of all further levels. Empty: that of
    /// `coarsen.target`.
    std::vector<double> factors;
    double target_ratio =
        0; ///< nodes of a level over those of the next, > 1; 0: as factors make it
    /// Ends the hierarchy at the first level with 95 % of its nodes below an aspect ratio of 5.
    bool until_isotropic = false;
    /// Levels are made by `rebuild_level` where that is possible; D = 3 only.
    bool rebuild = false;
    /// A level whose number of nodes falls by less than this ratio is not worth a level: it is
    /// thrown away and the hierarchy ends.
    double min_ratio = 1.05;
};

/// Share of nodes below an aspect ratio of 5 from which on a level counts as isotropic.
inline constexpr double isotropic_share = 0.95;

/// What was measured on one level. The same for every run and any number of threads.
struct LevelStatistics {
    int level = 0;
    std::int64_t nodes = 0;
    std::int64_t elements = 0;
    std::int64_t faces = 0;
    double factor = 1;          ///< coarse size over fine size that was asked for
    double ratio = 1;           ///< nodes of the finer level over nodes of this one
    double predicted_nodes = 0; ///< what the metric asked for; level 0: its own number
    double predicted_elements = 0;
    double volume = 0;     ///< [L^D]
    double complexity = 0; ///< of the natural metric [-]
    AspectRatioSummary aspect_ratio;
    AspectRatioClasses classes;    ///< on the class edges of level 0
    Conformity conformity;         ///< to the metric asked for; level 0: to its natural metric
    double deviation = 0;          ///< largest distance of the boundary from that of level 0 [L]
    double deviation_relative = 0; ///< the same over the local size of the surface mesh
    std::int64_t lines = 0;        ///< lines across layers, found on the finer level
    std::int64_t line_nodes = 0;   ///< nodes on them
    VerdictCounts removal, swaps;  ///< why nodes stayed, and what became of swaps
    VerdictCounts moves;           ///< what became of moves of nodes
    std::vector<Finding> warnings; ///< unusual, but workable
};

/// What making one level cost. Differs from run to run, so it is kept apart.
struct LevelTiming {
    int level = 0;
    PhaseSeconds phases;
    double statistics = 0;        ///< seconds to measure the level
    double write = 0;             ///< seconds to write its files
    double transfer = 0;          ///< seconds to make and write its transfer
    std::int64_t peak_memory = 0; ///< of the process so far [bytes]

    [[nodiscard]] double total() const { return phases.total() + statistics + write + transfer; }
};

/// A file and the hash of its bytes.
struct HashedFile {
    std::string name;       ///< relative to the folder of the hierarchy; "" for none
    std::uint64_t hash = 0; ///< content_hash.h

    friend bool operator==(const HashedFile&, const HashedFile&) = default;
};

/// The files of the transfer between a level and the next finer one, k and k - 1.
struct TransferFiles {
    HashedFile matrix;    ///< prolongation from level k to k - 1, all nodes, as MatrixMarket text
    HashedFile petsc;     ///< the same in PETSc's binary format
    HashedFile parent;    ///< fine node at the place of each coarse node
    HashedFile projected; ///< fine nodes that are not in the coarse domain
    std::int64_t nested = 0, interpolated = 0, projected_nodes = 0; ///< fine nodes by kind
    double largest_projection = 0; ///< distance of the farthest projected node [L]
};

struct HierarchyLevel {
    HashedFile mesh;   ///< level 0: the input's file
    HashedFile metric; ///< natural metric
    HashedFile state;  ///< what the next coarsening needs besides (level_state.h); level 0: none
    std::optional<TransferFiles> transfer; ///< to the next finer level, if it was asked for
    std::vector<HashedFile> exports; ///< the mesh in another format, and what belongs to that file
    LevelStatistics statistics;
};

/// Where level 0 came from.
struct HierarchyInput {
    HashedFile file;       ///< the user's file, or the copy of it in the folder
    bool copied = false;   ///< the folder holds a copy
    std::string format;    ///< "Medit binary, version 2"
    BoundaryRepair repair; ///< what was mended after reading; a reader of level 0 does the same
};

struct Hierarchy {
    std::string program; ///< "ameco 0.1.0"
    int dimension = 3;
    std::string mesh_suffix = ".meshb"; ///< of the level files: ".meshb" or ".mesh"
    std::string export_format; ///< each level is written in it too (io/format.h); "" for none
    std::string export_suffix; ///< of these files, ".su2"
    HierarchyStatus status = HierarchyStatus::in_progress;
    HierarchyOptions options;
    HierarchyInput input;
    std::vector<HierarchyLevel> levels; ///< levels[0] is the finest
};

/// Whether no level is wanted after this one, since it is isotropic.
[[nodiscard]] bool is_isotropic_end(const LevelStatistics& level, const HierarchyOptions& options);

/// Sum of the nodes of all levels over those of level 0 [-]: what a multigrid cycle stores.
[[nodiscard]] double grid_complexity(const Hierarchy& hierarchy);

/// Sum of the elements of all levels over those of level 0 [-].
[[nodiscard]] double element_complexity(const Hierarchy& hierarchy);

} // namespace ameco
