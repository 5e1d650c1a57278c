// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Adaptation of the unit cube to metrics by formula, and of other meshes to coarser ones:
/// conformity, quality, nodes, CPU seconds.
///
///     adapt_bench [--engine fast|mtc] [--quality shape|original|modified] [--node-nested]
///                 [--mmg PROGRAM] [--refine PROGRAM] [--limit SECONDS] [--cycles N]
///                 [--back] [--verbose] [CASE...]
///
/// A cycle adapts to the metric given at the nodes of the mesh, as the peers do it; the formula is
/// evaluated again on the result. What is printed is measured in the formula at the nodes. With
/// --mmg the program mmg3d, with --refine NASA's `ref`, does the same cycles on the same start,
/// through files; its time is that of the child processes, and it is stopped when all cycles
/// together take more than --limit (300) seconds of CPU time. With --back the result is coarsened
/// to edges of 0.1 everywhere.
///
/// The cases cube-8, layer-1e3, m6-8k and m6-67k take meshes to the metric of their next coarser
/// level, as do `coarsen` with nested and with moved nodes, and the other programs; they print the
/// ratio of nodes, fine over coarse, and nodes removed per second. Conformity is measured in the
/// metric at the places of the nodes.
#include "core/adapt/adapt.h"
#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "core/cases/onera_m6.h"
#include "core/coarsen/coarsen.h"
#include "core/io/io.h"
#include "tests/bench/analytic_metric.h"
#include "tests/bench/peer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
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
    std::vector<Peer> peers;
    double limit = 300; ///< of a peer's CPU time, all cycles of a case [s]
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

void print_failure(const Peer& peer, const std::string& name, const PeerRun& run, double seconds) {
    std::printf("%-8s %-9s %s %.0f s\n", peer.name.c_str(), name.c_str(),
                run.stopped ? "no end after" : "failed after", seconds);
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
    for (const Peer& peer : wishes.peers) {
        const PeerRun made = run_peer(peer, c.mesh, c.target, wishes.limit);
        if (made.mesh) {
            print_level(peer.name.c_str(), name, c, *made.mesh, made.seconds);
        } else {
            print_failure(peer, name, made, made.seconds);
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

void run_peer_cycles(const Peer& peer, const Case& c, const Wishes& wishes) {
    Mesh<3> mesh = make_cube<3>({.n = 20, .displace = 0});
    double seconds = 0;
    for (int n = 1; n <= wishes.cycles; ++n) {
        PeerRun made = run_peer(peer, mesh, evaluate(c, mesh), wishes.limit - seconds);
        seconds += made.seconds;
        if (!made.mesh) {
            print_failure(peer, c.name, made, seconds);
            return;
        }
        mesh = std::move(*made.mesh);
        print_row(peer.name, c, n, mesh, seconds);
    }
}

} // namespace

int main(int argc, char** argv) {
    Wishes wishes;
    std::vector<Peer> peers = known_peers();
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto peer = std::find_if(peers.begin(), peers.end(),
                                       [&](const Peer& p) { return p.option == word; });
        if (peer != peers.end() && i + 1 < argc) {
            peer->program = argv[++i];
            wishes.peers.push_back(*peer);
        } else if (word == "--limit" && i + 1 < argc) {
            wishes.limit = std::atof(argv[++i]);
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
        for (const Peer& peer : wishes.peers) {
            run_peer_cycles(peer, c, wishes);
        }
    }
    for (const std::string name : {"cube-8", "layer-1e3", "m6-8k", "m6-67k"}) {
        if (wanted(name)) {
            run_coarsening(name, wishes);
        }
    }
    return 0;
}
