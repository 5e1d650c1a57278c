// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A mesh is rebuilt until it is unit in a given metric, finer or coarser.
#pragma once

#include "core/adapt/collapse_edges.h"
#include "core/adapt/move_nodes.h"
#include "core/adapt/mtc.h"
#include "core/adapt/split_edges.h"
#include "core/adapt/swap_edges.h"
#include "core/base/monitor.h"
#include "core/mesh/check.h"
#include "core/metric/conformity.h"

namespace ameco {

/// How a mesh is brought nearer to its metric.
enum class Engine {
    fast, ///< operators in turn, each on the edges and elements that want it; in stages
    mtc   ///< the paper's iteration (section 4.3) until stagnation, see mtc.h; at once
};

inline constexpr std::array all_engines{Engine::fast, Engine::mtc};

[[nodiscard]] std::string_view name(Engine engine);
[[nodiscard]] std::optional<Engine> engine_from_name(std::string_view name);

struct AdaptOptions {
    Engine engine = Engine::fast;
    std::optional<Quality> quality; ///< none: \see quality_of
    MtcOptions mtc;
    FeatureOptions features;
    SurfaceRules surface;
    SplitOptions split;
    CollapseOptions collapse;
    SwapOptions swap{.below = 0.7, .gain = 1.01, .rounds = 2};
    MoveOptions move{.halvings = 2};
    bool move_curved = true; ///< nodes of curved patches and ridges are put and move on the
                             ///< boundary of the given mesh
    bool node_nested =
        false; ///< no new nodes, and none is moved: what is left are nodes of the mesh
    double stage_factor = 2;       ///< sizes change at most by this from stage to stage [-], > 1
    double stage_swap_below = 0.5; ///< elements below this quality are swapped on the way [-]
    int stage_passes = 2;          ///< over each stage but the last
    int stages = 40;               ///< at most, before the last one, which comes ...
    double left_beyond = 0.05;     ///< ... when no more than this share of nodes is out of reach
    double settled = 0.15; ///< once a pass over the last one makes fewer splits and collapses
                           ///< per node than this, lengths go by their excess; 0: never
    int passes = 20;       ///< over the last one, at most; it ends earlier ...
    double fewest = 0.1;   ///< ... when a pass makes fewer changes than this per node
};

/// The quality of elements that options ask for. Where they leave it open, `fast` takes the shape,
/// because it knows lengths itself, and `mtc`, which knows nothing else, the modified quality.
[[nodiscard]] Quality quality_of(const AdaptOptions& options);

/// What one pass, or sweep, did.
struct AdaptPass {
    std::int64_t nodes = 0, splits = 0, collapses = 0, swaps = 0, moves = 0;
};

struct AdaptReport {
    std::int64_t nodes_before = 0, nodes_after = 0;
    std::int64_t elements_before = 0, elements_after = 0;
    double predicted_nodes = 0; ///< of a unit mesh in the metric
    VerdictCounts splits, collapses, swaps, moves;
    int stages = 0; ///< before the last one
    std::vector<AdaptPass> passes;
    Conformity conformity_before, conformity; ///< to the metric, before and after
    CheckReport check;                        ///< of the result: always made, always valid
    double seconds = 0;                       ///< wall clock
};

/// A mesh with the metric at its nodes.
template <int D>
struct Adapted {
    Mesh<D> mesh;
    MetricField<D> metric;
};

/// Makes `mesh` unit in the metric `source` by splits, collapses, swaps and moves of nodes.
/// \param mesh  valid, with its boundary faces
/// \throws UsageError when the engine is `mtc` and the quality the shape, which knows no sizes
/// \throws Cancelled when asked to stop; nothing is left half done
/// \throws InputError when the metric asks for more nodes than can be numbered
/// \see docs/theory/adaptation.md
template <int D>
[[nodiscard]] Adapted<D> adapt(const Mesh<D>& mesh, const MetricSource<D>& source,
                               const AdaptOptions& options, AdaptReport& report,
                               Monitor& monitor = Monitor::silent());

} // namespace ameco
