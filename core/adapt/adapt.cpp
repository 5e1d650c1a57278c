// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/adapt.h"

#include "core/adapt/limited_metric.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/stop_check.h"
#include "core/base/stopwatch.h"
#include "core/base/text.h"
#include "core/metric/expected_nodes.h"
#include "core/metric/nodal_metric.h"
#include "core/remesh/original_surface.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ameco {
namespace {

/// Nodes and elements are numbered by 32 bits; there are 6 or 7 elements per node.
void require_countable(double nodes) {
    constexpr double most = 3e8;
    if (!(nodes <= most)) {
        throw InputError("the metric asks for about " + number_text(nodes, 2) +
                         " nodes, but no more than " + number_text(most, 2) +
                         " can be numbered: make its sizes larger");
    }
}

template <int D>
std::int64_t count_nodes(const EditMesh<D>& mesh) {
    std::int64_t count = 0;
    for (const NodeId v : mesh.nodes()) {
        count += mesh.is_removed(v) ? 0 : 1;
    }
    return count;
}

template <int D>
AdaptPass run_sweep(UnitMesh<D>& mesh, const AdaptOptions& options, int since, AdaptReport& report,
                    const Monitor& monitor) {
    const auto made = [&] {
        return std::array{report.splits[Verdict::accepted], report.collapses[Verdict::accepted],
                          report.swaps[Verdict::accepted], report.moves[Verdict::accepted]};
    };
    MtcOptions mtc = options.mtc;
    mtc.new_places = mtc.new_places && !options.node_nested;
    const auto before = made();
    (void)mtc_sweep(mesh, mtc, options.surface, since,
                    {report.collapses, report.moves, report.swaps, report.splits}, monitor);
    const auto after = made();
    return {count_nodes(mesh.edit), after[0] - before[0], after[1] - before[1],
            after[2] - before[2], after[3] - before[3]};
}

template <int D>
AdaptPass run_pass(UnitMesh<D>& mesh, const AdaptOptions& options, int since, AdaptReport& report,
                   const Monitor& monitor) {
    AdaptPass pass;
    pass.collapses = collapse_short_edges(mesh, options.collapse, options.surface, since,
                                          report.collapses, monitor);
    pass.swaps +=
        swap_to_quality(mesh, options.swap, options.surface, since, report.swaps, monitor);
    if (!options.node_nested) {
        pass.splits = split_long_edges(mesh, options.split, since, report.splits, monitor);
        pass.swaps +=
            swap_to_quality(mesh, options.swap, options.surface, since, report.swaps, monitor);
    }
    pass.nodes = count_nodes(mesh.edit);
    if (!options.node_nested) {
        MoveOptions move = options.move;
        if (options.move_curved) {
            move.curved = options.surface;
        }
        pass.moves = move_nodes(mesh, move, since, report.moves, monitor);
    }
    return pass;
}

/// A mesh on its way, and where its nodes lie in the background mesh.
template <int D>
struct Stage {
    Mesh<D> mesh;
    GeometryClasses<D> geometry;
    IdVector<NodeId, NodeId> near; ///< see MetricSource::at
    MetricField<D> target;         ///< the metric wanted at its nodes
};

template <int D>
void set_targets(Stage<D>& stage, const MetricSource<D>& source) {
    stage.target.resize(stage.mesh.points.size());
    parallel_for(stage.mesh.points.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const NodeId v(i);
            stage.target[v] = source.at(stage.mesh.points[v], stage.near[v]);
        }
    });
}

template <int D>
Stage<D> first_stage(const Mesh<D>& mesh, const MetricSource<D>& source,
                     const FeatureOptions& features) {
    Stage<D> stage{mesh, classify_geometry(mesh, features), {}, {}};
    for (const NodeId v : mesh.points.ids()) {
        stage.near.push_back(v);
    }
    set_targets(stage, source);
    return stage;
}

/// Has splits and collapses lower the sum of the excesses of lengths, and moves keep it or lower
/// it: what one of them mends no other undoes.
void judge_by_excess(AdaptOptions& options) {
    options.split.by_excess = true;
    options.collapse.by_excess = true;
    options.move.by_excess = true;
}

/// Passes over a stage until little changes; sweeps of the paper's engine until nothing does.
template <int D>
void run_passes(UnitMesh<D>& mesh, const AdaptOptions& options, int most, AdaptReport& report,
                Monitor& monitor) {
    int since = 0;
    BoundaryDistance<D> surface;
    AdaptOptions now_options = options;
    for (int n = 0; n < most; ++n) {
        monitor.progress(static_cast<double>(n) / most, "adapting");
        stop_if_asked(monitor);
        const int now = mesh.tick();
        const bool mtc = options.engine == Engine::mtc;
        report.passes.push_back(mtc ? run_sweep(mesh, options, since, report, monitor)
                                    : run_pass(mesh, now_options, since, report, monitor));
        stop_if_asked(monitor); // what was done last may have been cut short
        surface.measure(mesh.edit);
        const AdaptPass& pass = report.passes.back();
        since = now;
        const auto changes = pass.splits + pass.collapses + pass.swaps + pass.moves;
        if (!mtc && !now_options.move.by_excess &&
            static_cast<double>(pass.splits + pass.collapses) <
                options.settled * static_cast<double>(pass.nodes)) {
            judge_by_excess(now_options);
            for (const NodeId v : mesh.edit.nodes()) {
                mesh.touch(v); // what was tried in vain before need not be in vain now
            }
            continue;
        }
        const double fewest = mtc ? 0 : options.fewest * static_cast<double>(pass.nodes);
        if (changes == 0 || static_cast<double>(changes) < fewest) {
            break;
        }
    }
}

/// Adapts a stage to `source`, whose background is the stage's own mesh or what `near` refers to.
template <int D>
Stage<D> next_stage(const Stage<D>& stage, const MetricSource<D>& source,
                    const AdaptOptions& options, int passes, bool own_background,
                    AdaptReport& report, Monitor& monitor) {
    IdVector<NodeId, NodeId> near = stage.near;
    if (own_background) {
        for (const NodeId v : near.ids()) {
            near[v] = v;
        }
    }
    UnitMesh<D> unit(stage.mesh, stage.geometry, source, near, quality_of(options));
    run_passes(unit, options, passes, report, monitor);
    auto compact = unit.edit.compact();
    Stage<D> next{std::move(compact.mesh), std::move(compact.classes), {}, {}};
    for (const NodeId v : compact.parent) {
        const NodeId at = unit.near(v);
        next.near.push_back(own_background ? stage.near[at] : at);
    }
    return next;
}

/// Sizes halve or double from stage to stage, until the metric is within reach: a mesh that is
/// nearly unit at every step never gets elements that no swap could mend.
template <int D>
void approach(Stage<D>& stage, const MetricSource<D>& source, const AdaptOptions& options,
              AdaptReport& report, Monitor& monitor) {
    AdaptOptions on_stages = options;
    on_stages.swap.below = options.stage_swap_below;
    on_stages.settled = 0; // what is wanted there is a way, not lengths
    double left_before = std::numeric_limits<double>::infinity();
    for (int n = 0; n < options.stages; ++n) {
        const MetricField<D> natural = nodal_metric(stage.mesh, Mean::blended);
        MetricField<D> limited(natural.size());
        double left = 0;
        std::size_t beyond = 0;
        for (const NodeId v : natural.ids()) {
            double excess = 1;
            limited[v] = limited_metric(natural[v], stage.target[v], options.stage_factor, excess);
            left += std::log(excess);
            beyond += excess > 1 ? 1 : 0;
        }
        // In curved layers the directions of a mesh never agree with those wanted as well as their
        // sizes would need it: then it comes no nearer.
        if (static_cast<double>(beyond) <=
                options.left_beyond * static_cast<double>(natural.size()) ||
            left > 0.95 * left_before) {
            return;
        }
        left_before = left;
        const BackgroundMetric<D> on_the_way(stage.mesh, limited);
        // How many stages will follow is not known: each takes a fifth of what is left of the bar.
        MonitorPart part(monitor, 1 - std::pow(0.8, n), 1 - std::pow(0.8, n + 1));
        stage = next_stage(stage, on_the_way, on_stages, options.stage_passes, true, report, part);
        set_targets(stage, source);
        ++report.stages;
    }
}

} // namespace

std::string_view name(Engine engine) {
    return engine == Engine::fast ? "fast" : "mtc";
}

std::optional<Engine> engine_from_name(std::string_view text) {
    for (const Engine engine : all_engines) {
        if (name(engine) == text) {
            return engine;
        }
    }
    return {};
}

Quality quality_of(const AdaptOptions& options) {
    return options.quality.value_or(options.engine == Engine::fast ? Quality::shape
                                                                   : Quality::modified);
}

template <int D>
Adapted<D> adapt(const Mesh<D>& mesh, const MetricSource<D>& source, const AdaptOptions& options,
                 AdaptReport& report, Monitor& monitor) {
    const bool mtc = options.engine == Engine::mtc;
    if (mtc && quality_of(options) == Quality::shape) {
        throw UsageError("the engine mtc needs the quality original or modified: the shape alone "
                         "knows no sizes");
    }
    Stopwatch watch;
    report = {};
    report.nodes_before = static_cast<std::int64_t>(mesh.points.size());
    report.elements_before = static_cast<std::int64_t>(mesh.elements.size());
    Stage<D> stage = first_stage(mesh, source, options.features);
    require_countable(expected_nodes(mesh, stage.target));
    report.conformity_before = conformity(mesh, stage.target);
    if (!mtc) {
        MonitorPart part(monitor, 0, 0.4);
        approach(stage, source, options, report, part);
    }
    MonitorPart part(monitor, 0.4, 0.95);
    stage = next_stage(stage, source, options, mtc ? options.mtc.sweeps : options.passes, false,
                       report, part);
    set_targets(stage, source);

    monitor.progress(0.97, "checking");
    report.check = check(stage.mesh);
    if (!report.check.valid()) {
        throw std::logic_error("the adapted mesh is not valid: " + report.check.summary());
    }
    report.predicted_nodes = expected_nodes(stage.mesh, stage.target);
    report.conformity = conformity(stage.mesh, stage.target);
    report.nodes_after = static_cast<std::int64_t>(stage.mesh.points.size());
    report.elements_after = static_cast<std::int64_t>(stage.mesh.elements.size());
    report.seconds = watch.lap();
    return {std::move(stage.mesh), std::move(stage.target)};
}

template Adapted<2> adapt(const Mesh<2>&, const MetricSource<2>&, const AdaptOptions&, AdaptReport&,
                          Monitor&);
template Adapted<3> adapt(const Mesh<3>&, const MetricSource<3>&, const AdaptOptions&, AdaptReport&,
                          Monitor&);

} // namespace ameco
