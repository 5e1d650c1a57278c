// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/coarsen.h"

#include "core/base/parallel.h"
#include "core/base/stop_check.h"
#include "core/base/stopwatch.h"
#include "core/coarsen/fit_level.h"
#include "core/coarsen/level_report.h"
#include "core/remesh/front_order.h"
#include "core/remesh/original_surface.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

namespace ameco {
namespace {

template <int D>
IdVector<NodeId, Mat<D>> length_factors(const MetricField<D>& field) {
    IdVector<NodeId, Mat<D>> factors(field.size(), Mat<D>::Zero());
    parallel_for(field.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            factors[NodeId(i)] = length_factor(field[NodeId(i)]);
        }
    });
    return factors;
}

/// Everything one level needs to know of the fine mesh, in the form the inner loops want.
template <int D>
struct LevelData {
    Couplings couplings;
    FrontOrder front;
    Lines lines;
    IdVector<NodeId, Mat<D>> natural, target;
    IdVector<NodeId, float> short_size;
    IdVector<NodeId, float> directions; ///< in how many the target coarsens
    std::vector<Partition> partitions;  ///< for threads
    SizeField<D> sizes;
    RootField<D> root;
};

template <int D>
void prepare_metrics(const Level<D>& fine, const MetricField<D>& target, LevelData<D>& data) {
    // Each of them takes new memory, which the operating system clears for one thread at a time.
    const std::array<std::function<void()>, 4> tasks{
        [&] { data.natural = length_factors(fine.natural); },
        [&] { data.target = length_factors(target); },
        [&] { data.sizes = make_size_field(target); },
        [&] { data.root = make_root_field(target); }};
    parallel_for(tasks.size(), 1, [&](std::size_t task, std::size_t) { tasks[task](); });
    data.short_size.resize(target.size());
    for (const NodeId v : fine.mesh.points.ids()) {
        data.short_size[v] = static_cast<float>(fine.natural[v].sizes[0]);
    }
}

/// Partitions for threads: the second one, of fewer parts, for what lies at the borders of the
/// first, the third for what lies at those of both. None where the mesh is small.
template <int D>
std::vector<Partition> make_partitions(const Mesh<D>& mesh, const NodeNodes& neighbours,
                                       const Lines& lines, std::size_t nodes_per_part) {
    std::vector<Partition> partitions;
    const std::size_t parts = part_count(mesh.points.size(), nodes_per_part);
    NodeMarks counts(mesh.points.size(), 1);
    for (std::size_t n = 0; parts > 1 && n < 3; ++n) {
        partitions.push_back(cut_in_parts<D>(mesh.points, neighbours, lines,
                                             std::max<std::size_t>(parts >> n, 2), counts));
        const NodeMarks border = border_nodes(neighbours, partitions.back());
        std::transform(counts.begin(), counts.end(), border.begin(), counts.begin(),
                       std::bit_and<std::uint8_t>());
    }
    return partitions;
}

/// Makes couplings, front order, lines and partitions.
/// \return  the mesh to edit
template <int D>
std::optional<EditMesh<D>> order_nodes(const Level<D>& fine, const CoarsenOptions& options,
                                       LevelData<D>& data) {
    const NodeElements ball = node_elements(fine.mesh);
    data.couplings.neighbours = node_neighbours(fine.mesh, ball);
    // Paths of least cost cannot be shared by threads; what needs no order is made beside them.
    std::optional<EditMesh<D>> mesh;
    LineLinks links;
    parallel_for(2, 1, [&](std::size_t task, std::size_t) {
        if (task == 0) {
            data.front = front_order(fine.mesh, fine.natural, data.couplings.neighbours);
        } else {
            measure_couplings(fine.mesh, ball, data.couplings);
            mesh.emplace(fine.mesh, fine.geometry);
            links = link_lines(fine.mesh, data.couplings, options.lines);
        }
    });
    data.lines = number_lines(fine.mesh, links, data.front.key);
    data.partitions =
        make_partitions(fine.mesh, data.couplings.neighbours, data.lines, options.nodes_per_part);
    return mesh;
}

/// Removal and swaps, in turns.
template <int D>
void edit(EditMesh<D>& mesh, LevelData<D>& data, const CoarsenOptions& options,
          CoarsenReport& report, Monitor& monitor) {
    Stopwatch watch;
    measure_size_quality(mesh, data.sizes);
    RemovedNodes<D> removed(
        data.couplings,
        interpolation_bounds<D>(data.couplings, data.directions, options.removal.interpolation),
        data.short_size);
    EditNotes notes(mesh);
    const RemovalInput<D> input{
        data.front.order, data.couplings,  data.sizes, data.natural, data.target,
        data.short_size,  data.directions, removed,    notes,        data.partitions};
    const SwapInput<D> swap_input{data.sizes, data.root, data.short_size, data.lines,
                                  removed,    notes,     data.partitions, options.least_stiffness};
    SwapOptions between = options.swaps;
    between.below = std::min(0.3, options.swaps.below);
    between.rounds = std::min(2, options.swaps.rounds);
    RemovalState state(data.lines);
    BoundaryDistance<D> surface;
    for (int pass = 0; pass < options.passes; ++pass) {
        const double begin = static_cast<double>(pass) / options.passes;
        MonitorPart part(monitor, begin, begin + 0.6 / options.passes);
        if (pass == 0) {
            remove_first_pass(mesh, data.lines, state, input, options.removal, report.removal,
                              part);
            report.seconds.first_pass += watch.lap();
            report.removed_in_first_pass = report.removal[Verdict::accepted];
        } else {
            remove_again(mesh, data.lines, state, input, options.removal, report.removal, part);
            report.seconds.remove += watch.lap();
        }
        stop_if_asked(monitor);
        const bool last = pass + 1 == options.passes;
        const double lengths_begin = begin + (last ? 0.9 : 1.0) / options.passes;
        MonitorPart rest(monitor, begin + 0.6 / options.passes, lengths_begin);
        swap_bad_elements(mesh, swap_input, last ? options.swaps : between, options.removal.surface,
                          report.swaps, rest);
        if (last) {
            MonitorPart lengths(monitor, lengths_begin, 1);
            swap_lengths(mesh, swap_input, data.target, options.lengths, options.removal.surface,
                         report.swaps, lengths);
        }
        surface.measure(mesh);
        report.seconds.swap += watch.lap();
        stop_if_asked(monitor);
    }
}

/// Measures and checks a level that is made, nested so far, after moving its nodes if that is
/// wanted.
///
/// \param target  at the nodes of `fine`, which the parents are nodes of
template <int D>
void finish_level(const Mesh<D>& fine, const MetricField<D>& target, const CoarsenOptions& options,
                  Level<D>& coarse, CoarsenReport& report, Monitor& monitor) {
    Stopwatch watch;
    if (options.nodes == CoarseNodes::moved) {
        MonitorPart fitting(monitor, 0, 0.6);
        fit_level(fine, target, options, coarse, report, fitting);
        report.seconds.fit += watch.lap();
    }
    report.nodes_after = static_cast<std::int64_t>(coarse.mesh.points.size());
    report.elements_after = static_cast<std::int64_t>(coarse.mesh.elements.size());
    monitor.progress(0.6, "checking");
    report.check = check(coarse.mesh);
    if (!report.check.valid()) {
        throw std::logic_error("the coarse mesh is not valid: " + report.check.summary());
    }
    measure_deviation(coarse.mesh, coarse.geometry, report);
    report.conformity = conformity(coarse.mesh, wanted_metric(fine, target, coarse));
    report.seconds.check += watch.lap();
    monitor.progress(0.8, "measuring the new mesh");
    coarse.natural = nodal_metric(coarse.mesh, options.mean);
    report.seconds.metric += watch.lap();
}

/// One step: lines across layers lose at most every other node.
template <int D>
Level<D> coarsen_once(const Level<D>& fine, const CoarsenOptions& options,
                      const MetricField<D>& target, CoarsenReport& report, Monitor& monitor) {
    report = {};
    Stopwatch watch;
    report.factor = options.target.factor;
    report.nodes_before = static_cast<std::int64_t>(fine.mesh.points.size());
    report.elements_before = static_cast<std::int64_t>(fine.mesh.elements.size());
    report.predicted_nodes = predicted_nodes(fine, target);
    LevelData<D> data;
    prepare_metrics(fine, target, data);
    data.directions = coarsened_directions(fine.natural, target);
    report.seconds.metric += watch.lap();
    stop_if_asked(monitor);

    monitor.progress(0.02, "ordering nodes");
    std::optional<EditMesh<D>> mesh = order_nodes(fine, options, data);
    report.lines = data.lines.count;
    report.line_nodes = data.lines.node_count;
    report.seconds.order += watch.lap();
    stop_if_asked(monitor);

    const bool moved = options.nodes == CoarseNodes::moved;
    MonitorPart editing(monitor, 0.1, moved ? 0.7 : 0.85);
    edit(*mesh, data, options, report, editing);

    auto compact = mesh->compact();
    Level<D> coarse{
        std::move(compact.mesh), std::move(compact.classes), {}, std::move(compact.parent)};
    MonitorPart finishing(monitor, moved ? 0.7 : 0.85, 1);
    finish_level(fine.mesh, target, options, coarse, report, finishing);
    return coarse;
}

/// What several steps have in common; the first one's `before`, the last one's `after`.
void add_step(CoarsenReport& all, const CoarsenReport& step) {
    all.nodes_after = step.nodes_after;
    all.elements_after = step.elements_after;
    for (std::size_t i = 0; i < verdict_count; ++i) {
        all.removal.counts[i] += step.removal.counts[i];
        all.swaps.counts[i] += step.swaps.counts[i];
        all.moves.counts[i] += step.moves.counts[i];
    }
    all.removed_in_first_pass += step.removed_in_first_pass;
    all.deviation = step.deviation;
    all.deviation_relative = step.deviation_relative;
    all.conformity = step.conformity;
    all.check = step.check;
    all.seconds.metric += step.seconds.metric;
    all.seconds.order += step.seconds.order;
    all.seconds.first_pass += step.seconds.first_pass;
    all.seconds.remove += step.seconds.remove;
    all.seconds.swap += step.seconds.swap;
    all.seconds.fit += step.seconds.fit;
    all.seconds.check += step.seconds.check;
}

} // namespace

std::string_view name(CoarseNodes nodes) {
    return nodes == CoarseNodes::nested ? "nested" : "moved";
}

std::optional<CoarseNodes> coarse_nodes_from_name(std::string_view text) {
    for (const CoarseNodes nodes : all_coarse_nodes) {
        if (name(nodes) == text) {
            return nodes;
        }
    }
    return {};
}

int coarsening_steps(double factor) {
    return std::max(1, static_cast<int>(std::lround(std::log2(factor))));
}

template <int D>
Level<D> finest_level(Mesh<D> mesh, const CoarsenOptions& options, Monitor& monitor) {
    Level<D> level;
    level.geometry = classify_geometry(mesh, options.features);
    level.natural = nodal_metric(mesh, options.mean, monitor);
    level.mesh = std::move(mesh);
    return level;
}

template <int D>
Level<D> coarsen(const Level<D>& fine, const CoarsenOptions& options, CoarsenReport& report,
                 Monitor& monitor) {
    const int steps = coarsening_steps(options.target.factor);
    const MetricField<D> target = target_metric(fine.mesh, fine.natural, options.target);
    if (steps == 1) {
        return coarsen_once(fine, options, target, report, monitor);
    }
    CoarsenOptions step_options = options;
    step_options.target.factor = std::pow(options.target.factor, 1.0 / steps);
    step_options.nodes = CoarseNodes::nested; // until the last one is there
    Level<D> level;
    for (int n = 0; n < steps; ++n) {
        MonitorPart part(monitor, static_cast<double>(n) / steps, (n + 1.0) / steps);
        const Level<D>& from = n == 0 ? fine : level;
        CoarsenReport made;
        Level<D> next =
            coarsen_once(from, step_options,
                         target_metric(from.mesh, from.natural, step_options.target), made, part);
        if (n == 0) {
            report = std::move(made);
        } else {
            add_step(report, made);
            for (NodeId& parent : next.parent) {
                parent = level.parent[parent];
            }
        }
        level = std::move(next);
    }
    report.factor = options.target.factor;
    report.predicted_nodes = predicted_nodes(fine, target);
    finish_level(fine.mesh, target, options, level, report, Monitor::silent());
    return level;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template Level<D> finest_level(Mesh<D>, const CoarsenOptions&, Monitor&);                      \
    template Level<D> coarsen(const Level<D>&, const CoarsenOptions&, CoarsenReport&, Monitor&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
