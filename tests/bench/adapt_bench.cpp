// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Adaptation of the unit cube to metrics by formula: conformity, quality, nodes, CPU seconds.
///
///     adapt_bench [--mmg PROGRAM] [--cycles N] [--back] [--verbose] [CASE...]
///
/// A cycle adapts to the metric given at the nodes of the mesh, as the peers do it; the formula is
/// evaluated again on the result. What is printed is measured in the formula at the nodes. With
/// --mmg the program mmg3d does the same cycles on the same start, through files; its time is that
/// of the child processes. With --back the result is coarsened to edges of 0.1 everywhere.
#include "core/adapt/adapt.h"
#include "core/cases/analytic_metric.h"
#include "core/cases/cube.h"
#include "core/io/io.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
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

void coarsen_back(const Mesh<3>& mesh, const Case& c) {
    const double begin = cpu_seconds();
    const MetricField<3> field(mesh.points.size(), {Vec<3>::Constant(0.1), Mat<3>::Identity()});
    AdaptReport report;
    const Mesh<3> back = adapt(mesh, BackgroundMetric<3>(mesh, field), {}, report).mesh;
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
        mesh = adapt(mesh, BackgroundMetric<3>(mesh, field), {}, report).mesh;
        seconds += cpu_seconds() - begin;
        print_row("ameco", c, n, mesh, seconds);
        if (wishes.verbose) {
            print_passes(report);
        }
    }
    if (wishes.back) {
        coarsen_back(mesh, c);
    }
}

double child_seconds() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

void run_mmg(const Case& c, const Wishes& wishes) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / "ameco_adapt_bench";
    fs::create_directories(folder);
    Mesh<3> mesh = make_cube<3>({.n = 20, .displace = 0});
    const double begin = child_seconds();
    for (int n = 1; n <= wishes.cycles; ++n) {
        write_mesh(folder / "in.mesh", mesh);
        write_metric(folder / "in.sol", evaluate(c, mesh));
        fs::remove(folder / "out.mesh");
        // Without -hgrad -1 layers become isotropic.
        const std::string command = "cd " + folder.string() + " && " + wishes.mmg +
                                    " -in in.mesh -sol in.sol -out out.mesh -hgrad -1 > out.txt";
        if (std::system(command.c_str()) != 0 || !fs::exists(folder / "out.mesh")) {
            std::printf("mmg      %-9s %d failed\n", c.name.c_str(), n);
            return;
        }
        mesh = std::get<Mesh<3>>(read_mesh(folder / "out.mesh").mesh);
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
        } else {
            wishes.names.push_back(word);
        }
    }
    std::printf("program  case    cycle   nodes    cpu s  unit%%  lengths      quality\n");
    for (const Case& c : cases) {
        const auto& names = wishes.names;
        if (!names.empty() && std::find(names.begin(), names.end(), c.name) == names.end()) {
            continue;
        }
        run(c, wishes);
        if (!wishes.mmg.empty()) {
            run_mmg(c, wishes);
        }
    }
    return 0;
}
