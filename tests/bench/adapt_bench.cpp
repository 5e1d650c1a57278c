// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Adaptation of the unit cube to metrics by formula, and of other meshes to coarser ones:
/// conformity, quality, nodes, CPU seconds.
///
///     adapt_bench [--engine fast|mtc] [--quality shape|original|modified] [--node-nested]
///                 [--mmg PROGRAM] [--cycles N] [--back] [--verbose] [CASE...]
///
/// A cycle adapts to the metric given at the nodes of the mesh, as the peers do it; the formula is
/// evaluated again on the result. What is printed is measured in the formula at the nodes. With
/// --mmg the program mmg3d does the same cycles on the same start, through files; its time is that
/// of the child processes. With --back the result is coarsened to edges of 0.1 everywhere.
///
/// The cases cube-8, layer-1e3, m6-8k and m6-67k take meshes to the metric of their next coarser
/// level, as do `coarsen` with nested and with moved nodes, and mmg3d; they print the ratio of
/// nodes, fine over coarse, and nodes removed per second. Conformity is measured in the metric at
/// the places of the nodes.
#include "core/adapt/adapt.h"
#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "core/cases/onera_m6.h"
#include "core/coarsen/coarsen.h"
#include "core/io/io.h"
#include "tests/bench/analytic_metric.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

using namespace ameco;

namespace {

struct Case {
    std::string name;
    AnalyticMetric kind;
    double first;
};

const std::vector<Case> cases{
    {"linear", AnalyticMetric::linear, 0},   {"polar-1", AnalyticMetric::polar_1, 0},
    {"polar-2", AnalyticMetric::polar_2, 0}, {"bl1e-3", AnalyticMetric::layer, 1e-3},
    {"bl1e-4", AnalyticMetric::layer, 1e-4}, {"bl1e-5", AnalyticMetric::layer, 1e-5},
    {"bl1e-6", AnalyticMetric::layer, 1e-6}, {"skew1e-3", AnalyticMetric::skew, 1e-3},
    {"skew1e-4", AnalyticMetric::skew, 1e-4}};

double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

MetricField<3> evaluate(const Case& c, const Mesh<3>& mesh) {
    MetricField<3> field(mesh.points.size());
    for (const NodeId v : mesh.points.ids()) {
        field[v] = analytic_metric(c.kind, c.first, mesh.points[v]);
    }
    return field;
}

void print(const char* what, const VerdictCounts& counts) {
    std::printf("    %s:", what);
    for (std::size_t i = 0; i < verdict_count; ++i) {
        if (counts.counts[i] > 0) {
            std::printf(" %s %lld,", std::string(name(static_cast<Verdict>(i))).c_str(),
                        static_cast<long long>(counts.counts[i]));
        }
    }
    std::printf("\n");
}

struct Wishes {
    std::string mmg;
    int cycles = 1;
    bool back = false, verbose = false;
    AdaptOptions options;
    std::vector<std::string> names;
};

void print_row(const std::string& who, const Case& c, int cycle, const Mesh<3>& mesh,
               double seconds) {
    const Conformity k = conformity(mesh, evaluate(c, mesh));
    std::printf("%-8s %-9s %d %7zu %8.2f %6.1f  %.2f %6.2f  %.1e/%.2f\n", who.c_str(),
                c.name.c_str(), cycle, mesh.points.size(), seconds, 100 * k.in_band, k.shortest,
                k.longest, k.worst_quality, k.mean_quality);
    std::fflush(stdout);
}

void print_passes(const AdaptReport& report) {
    for (const AdaptPass& p : report.passes) {
        std::printf("    %7lld nodes: %lld splits, %lld collapses, %lld swaps, %lld moves\n",
                    static_cast<long long>(p.nodes), static_cast<long long>(p.splits),
                    static_cast<long long>(p.collapses), static_cast<long long>(p.swaps),
                    static_cast<long long>(p.moves));
    }
    print("splits", report.splits);
    print("collapses", report.collapses);
    print("swaps", report.swaps);
    print("moves", report.moves);
}

/// A mesh, and the metric of its next coarser level.
struct Coarsening {
    Mesh<3> mesh;
    MetricField<3> target;
};

Coarsening make_coarsening(const std::string& name) {
    if (name == "cube-8") {
        Mesh<3> mesh = make_cube<3>({.n = 8});
        return {mesh, MetricField<3>(mesh.points.size(),
                                     {Vec<3>::Constant(2.0 / 8), Mat<3>::Identity()})};
    }
    Mesh<3> mesh;
    if (name == "layer-1e3") {
        LayerOptions layer;
        layer.aspect_ratio = 1e3;
        mesh = make_layer<3>(layer);
    } else {
        for (const OneraM6Preset& preset : onera_m6_presets()) {
            if (preset.name == name) {
                mesh = make_onera_m6(preset.options);
            }
        }
    }
    return {mesh, target_metric(mesh, nodal_metric(mesh, Mean::blended))};
}

double child_seconds() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// One run of mmg3d, through files. \return nothing if it failed
std::optional<Mesh<3>> adapt_by_mmg(const std::string& program, const Mesh<3>& mesh,
                                    const MetricField<3>& field) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / "ameco_adapt_bench";
    fs::create_directories(folder);
    write_mesh(folder / "in.mesh", mesh);
    write_metric(folder / "in.sol", field);
    fs::remove(folder / "out.mesh");
    // Without -hgrad -1 layers become isotropic.
    const std::string command = "cd " + folder.string() + " && " + program +
                                " -in in.mesh -sol in.sol -out out.mesh -hgrad -1 > out.txt";
    if (std::system(command.c_str()) != 0 || !fs::exists(folder / "out.mesh")) {
        return std::nullopt;
    }
    return std::get<Mesh<3>>(read_mesh(folder / "out.mesh").mesh);
}

void print_level(const char* who, const std::string& name, const Coarsening& c,
                 const Mesh<3>& coarse, double seconds) {
    const BackgroundMetric<3> source(c.mesh, c.target);
    MetricField<3> field(coarse.points.size());
    NodeId near(0);
    for (const NodeId v : coarse.points.ids()) {
        field[v] = source.at(coarse.points[v], near);
    }
    const Conformity k = conformity(coarse, field);
    const auto before = static_cast<double>(c.mesh.points.size());
    const auto after = static_cast<double>(coarse.points.size());
    std::printf("%-8s %-9s   %7zu %8.2f %6.1f  %.2f %6.2f  %.1e/%.2f  (ratio %.2f, %.0f removed "
                "nodes per second)\n",
                who, name.c_str(), coarse.points.size(), seconds, 100 * k.in_band, k.shortest,
                k.longest, k.worst_quality, k.mean_quality, before / after,
                (before - after) / seconds);
    std::fflush(stdout);
}

void run_coarsening(const std::string& name, const Wishes& wishes) {
    const Coarsening c = make_coarsening(name);
    for (const CoarseNodes nodes : all_coarse_nodes) {
        CoarsenOptions options;
        options.nodes = nodes;
        const double begin = cpu_seconds();
        CoarsenReport report;
        const Level<3> coarse = coarsen(finest_level(Mesh<3>(c.mesh), options), options, report);
        print_level(std::string(ameco::name(nodes)).c_str(), name, c, coarse.mesh,
                    cpu_seconds() - begin);
    }
    const double begin = cpu_seconds();
    AdaptReport report;
    const Mesh<3> adapted =
        adapt(c.mesh, BackgroundMetric<3>(c.mesh, c.target), wishes.options, report).mesh;
    print_level(std::string(ameco::name(wishes.options.engine)).c_str(), name, c, adapted,
                cpu_seconds() - begin);
    if (wishes.verbose) {
        print_passes(report);
    }
    if (!wishes.mmg.empty()) {
        const double before = child_seconds();
        const auto coarse = adapt_by_mmg(wishes.mmg, c.mesh, c.target);
        if (coarse) {
            print_level("mmg", name, c, *coarse, child_seconds() - before);
        } else {
            std::printf("mmg      %-9s failed\n", name.c_str());
        }
    }
}

void coarsen_back(const Mesh<3>& mesh, const Case& c, const AdaptOptions& options) {
    const double begin = cpu_seconds();
    const MetricField<3> field(mesh.points.size(), {Vec<3>::Constant(0.1), Mat<3>::Identity()});
    AdaptReport report;
    const Mesh<3> back = adapt(mesh, BackgroundMetric<3>(mesh, field), options, report).mesh;
    std::printf("%-8s %-9s   %7zu %8.2f %6.1f  %.2f %6.2f  %.1e/%.2f  (to 0.1 everywhere)\n",
                "ameco", c.name.c_str(), back.points.size(), cpu_seconds() - begin,
                100 * report.conformity.in_band, report.conformity.shortest,
                report.conformity.longest, report.conformity.worst_quality,
                report.conformity.mean_quality);
}

void run(const Case& c, const Wishes& wishes) {
    Mesh<3> mesh = make_cube<3>({.n = 20, .displace = 0});
    double seconds = 0;
    for (int n = 1; n <= wishes.cycles; ++n) {
        const MetricField<3> field = evaluate(c, mesh);
        const double begin = cpu_seconds();
        AdaptReport report;
        mesh = adapt(mesh, BackgroundMetric<3>(mesh, field), wishes.options, report).mesh;
        seconds += cpu_seconds() - begin;
        print_row("ameco", c, n, mesh, seconds);
        if (wishes.verbose) {
            print_passes(report);
        }
    }
    if (wishes.back) {
        coarsen_back(mesh, c, wishes.options);
    }
}

void run_mmg(const Case& c, const Wishes& wishes) {
    Mesh<3> mesh = make_cube<3>({.n = 20, .displace = 0});
    const double begin = child_seconds();
    for (int n = 1; n <= wishes.cycles; ++n) {
        auto adapted = adapt_by_mmg(wishes.mmg, mesh, evaluate(c, mesh));
        if (!adapted) {
            std::printf("mmg      %-9s %d failed\n", c.name.c_str(), n);
            return;
        }
        mesh = std::move(*adapted);
        print_row("mmg", c, n, mesh, child_seconds() - begin);
    }
}

} // namespace

int main(int argc, char** argv) {
    Wishes wishes;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--mmg" && i + 1 < argc) {
            wishes.mmg = argv[++i];
        } else if (word == "--cycles" && i + 1 < argc) {
            wishes.cycles = std::atoi(argv[++i]);
        } else if (word == "--back" || word == "--verbose") {
            (word == "--back" ? wishes.back : wishes.verbose) = true;
        } else if (word == "--engine" && i + 1 < argc) {
            wishes.options.engine = engine_from_name(argv[++i]).value();
        } else if (word == "--quality" && i + 1 < argc) {
            wishes.options.quality = quality_from_name(argv[++i]).value();
        } else if (word == "--node-nested") {
            wishes.options.node_nested = true;
        } else {
            wishes.names.push_back(word);
        }
    }
    std::printf("program  case    cycle   nodes    cpu s  unit%%  lengths      quality\n");
    const auto wanted = [&](const std::string& name) {
        const auto& names = wishes.names;
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const Case& c : cases) {
        if (!wanted(c.name)) {
            continue;
        }
        run(c, wishes);
        if (!wishes.mmg.empty()) {
            run_mmg(c, wishes);
        }
    }
    for (const std::string name : {"cube-8", "layer-1e3", "m6-8k", "m6-67k"}) {
        if (wanted(name)) {
            run_coarsening(name, wishes);
        }
    }
    return 0;
}
