// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/build_hierarchy.h"

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/coarsen/rebuild.h"
#include "core/coarsen/target_ratio.h"
#include "core/metric/complexity.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <sys/resource.h>

namespace ameco {
namespace {

/// Puts the name of the level before each step.
class LevelMonitor : public MonitorPart {
public:
    LevelMonitor(Monitor& parent, double begin, double end, int level)
        : MonitorPart(parent, begin, end), prefix_("level " + std::to_string(level) + ": ") {}

    void message(Severity severity, std::string_view text) override {
        MonitorPart::message(severity, prefix_ + std::string(text));
    }
    void progress(double fraction, std::string_view step) override {
        MonitorPart::progress(fraction, prefix_ + std::string(step));
    }

private:
    std::string prefix_;
};

/// Share of the work that is done before level `k` is begun. The work of a level goes with the
/// nodes of the finer one, which about halve each time; level 0 (its metric and statistics) counts
/// as a quarter of a coarsening.
double share_before(int k, int first, int last) {
    const auto work = [](int level) { return level == 0 ? 0.25 : std::pow(0.5, level - 1); };
    double before = 0;
    double total = 0;
    for (int level = first; level <= last; ++level) {
        total += work(level);
        before += level < k ? work(level) : 0;
    }
    return total > 0 ? before / total : 1;
}

/// What can be measured on any level, whatever made it.
template <int D>
LevelStatistics measure(const Level<D>& level, int number, double max_aspect_ratio) {
    LevelStatistics s;
    s.level = number;
    s.nodes = static_cast<std::int64_t>(level.mesh.points.size());
    s.elements = static_cast<std::int64_t>(level.mesh.elements.size());
    s.faces = static_cast<std::int64_t>(level.mesh.faces.size());
    s.complexity = complexity(level.mesh, level.natural);
    s.aspect_ratio = summarise_aspect_ratios(level.natural);
    s.classes = classify_aspect_ratios(level.natural, max_aspect_ratio);
    return s;
}

template <int D>
LevelStatistics measure_finest(const Level<D>& level) {
    LevelStatistics s = measure(level, 0, 0);
    s.predicted_nodes = static_cast<double>(s.nodes);
    s.predicted_elements = static_cast<double>(s.elements);
    s.conformity = conformity(level.mesh, level.natural);
    const CheckReport checked = check(level.mesh);
    s.volume = checked.volume;
    s.warnings = checked.warnings;
    return s;
}

template <int D>
LevelStatistics measure_coarse(const Level<D>& level, int number, double max_aspect_ratio,
                               const CoarsenReport& report) {
    LevelStatistics s = measure(level, number, max_aspect_ratio);
    s.ratio = static_cast<double>(report.nodes_before) / static_cast<double>(report.nodes_after);
    s.factor = report.factor;
    s.predicted_nodes = report.predicted_nodes;
    // Elements per node hardly change between levels, so they are predicted to fall alike.
    s.predicted_elements = static_cast<double>(report.elements_before) * report.predicted_nodes /
                           static_cast<double>(report.nodes_before);
    s.volume = report.check.volume;
    s.conformity = report.conformity;
    s.deviation = report.deviation;
    s.deviation_relative = report.deviation_relative;
    s.lines = report.lines;
    s.line_nodes = report.line_nodes;
    s.removal = report.removal;
    s.swaps = report.swaps;
    s.moves = report.moves;
    s.warnings = report.check.warnings;
    return s;
}

void say_that_rebuilding_failed(const Error& error, Monitor& monitor) {
    monitor.message(Severity::warning, std::string("not rebuilt: ") + error.what());
}

/// \throws UsageError  levels are to be rebuilt, and cannot be
template <int D>
void require_fitting_options(const HierarchyOptions& options) {
    if (!options.rebuild) {
        return;
    }
    if (D != 3) {
        throw UsageError("--rebuild: only meshes in three dimensions can be rebuilt");
    }
    if (options.target_ratio > 0) {
        throw UsageError("--rebuild: cannot aim at a ratio; leave --target-ratio out");
    }
    std::vector<double> factors = options.factors;
    factors.push_back(options.coarsen.target.factor);
    if (std::any_of(factors.begin(), factors.end(),
                    [](double factor) { return coarsening_steps(factor) > 1; })) {
        throw UsageError("--rebuild: a level is made in one step, with a --factor near 2");
    }
}

template <int D>
Level<D> next_level(const Level<D>& fine, int number, const HierarchyOptions& options,
                    CoarsenReport& report, Monitor& monitor) {
    if (options.target_ratio > 0) {
        return coarsen_by_ratio(fine, options.coarsen, options.target_ratio, report, monitor);
    }
    CoarsenOptions coarsening = options.coarsen;
    if (!options.factors.empty()) {
        const auto level = static_cast<std::size_t>(number) - 1;
        coarsening.target.factor = options.factors[std::min(level, options.factors.size() - 1)];
    }
    if constexpr (D == 3) {
        if (options.rebuild) {
            try {
                return rebuild_level(fine, coarsening, report, monitor);
            } catch (const InputError& error) { // of TetGen
                say_that_rebuilding_failed(error, monitor);
            } catch (const CheckFailed& error) {
                say_that_rebuilding_failed(error, monitor);
            }
        }
    }
    return coarsen(fine, coarsening, report, monitor);
}

template <int D>
HierarchyEnd extend(Level<D> last, int number, double max_aspect_ratio, int first,
                    const HierarchyOptions& options, const LevelSink<D>& sink, Monitor& monitor) {
    for (int k = number + 1; k <= options.levels; ++k) {
        LevelMonitor part(monitor, share_before(k, first, options.levels),
                          share_before(k + 1, first, options.levels), k);
        CoarsenReport report;
        Level<D> coarse = next_level(last, k, options, report, part);
        if (static_cast<double>(report.nodes_before) <
            options.min_ratio * static_cast<double>(report.nodes_after)) {
            return {HierarchyStatus::exhausted, std::move(report)};
        }
        const Stopwatch watch;
        const LevelStatistics statistics = measure_coarse(coarse, k, max_aspect_ratio, report);
        LevelTiming timing;
        timing.level = k;
        timing.phases = report.seconds;
        timing.statistics = watch.seconds();
        timing.peak_memory = peak_memory();
        sink(coarse, statistics, timing);
        if (is_isotropic_end(statistics, options)) {
            break;
        }
        last = std::move(coarse);
    }
    return {};
}

} // namespace

template <int D>
void require_possible(const Mesh<D>& mesh, const HierarchyOptions& options) {
    require_fitting_options<D>(options);
    if constexpr (D == 3) {
        if (options.rebuild) {
            require_rebuildable(mesh);
        }
    }
}

template <int D>
HierarchyEnd build_hierarchy(Mesh<D> mesh, const HierarchyOptions& options,
                             const LevelSink<D>& sink, Monitor& monitor) {
    require_fitting_options<D>(options);
    try {
        LevelMonitor part(monitor, 0, share_before(1, 0, options.levels), 0);
        LevelTiming timing;
        const Stopwatch metric_watch;
        Level<D> finest = finest_level(std::move(mesh), options.coarsen, part);
        timing.phases.metric = metric_watch.seconds();
        const Stopwatch watch;
        const LevelStatistics statistics = measure_finest(finest);
        timing.statistics = watch.seconds();
        timing.peak_memory = peak_memory();
        sink(finest, statistics, timing);
        if (is_isotropic_end(statistics, options)) {
            return {};
        }
        return extend(std::move(finest), 0, statistics.classes.max, 0, options, sink, monitor);
    } catch (const Cancelled&) {
        return {HierarchyStatus::cancelled, std::nullopt};
    }
}

template <int D>
HierarchyEnd extend_hierarchy(Level<D> last, int number, double max_aspect_ratio,
                              const HierarchyOptions& options, const LevelSink<D>& sink,
                              Monitor& monitor) {
    require_fitting_options<D>(options);
    try {
        return extend(std::move(last), number, max_aspect_ratio, number + 1, options, sink,
                      monitor);
    } catch (const Cancelled&) {
        return {HierarchyStatus::cancelled, std::nullopt};
    }
}

std::int64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::int64_t>(usage.ru_maxrss) * 1024; // Linux counts in KiB
}

template void require_possible(const Mesh<2>&, const HierarchyOptions&);
template void require_possible(const Mesh<3>&, const HierarchyOptions&);
template HierarchyEnd build_hierarchy(Mesh<2>, const HierarchyOptions&, const LevelSink<2>&,
                                      Monitor&);
template HierarchyEnd build_hierarchy(Mesh<3>, const HierarchyOptions&, const LevelSink<3>&,
                                      Monitor&);
template HierarchyEnd extend_hierarchy(Level<2>, int, double, const HierarchyOptions&,
                                       const LevelSink<2>&, Monitor&);
template HierarchyEnd extend_hierarchy(Level<3>, int, double, const HierarchyOptions&,
                                       const LevelSink<3>&, Monitor&);

} // namespace ameco
