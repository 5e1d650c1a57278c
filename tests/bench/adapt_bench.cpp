// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Adaptation of the unit cube to metrics by formula: conformity, quality, nodes, CPU seconds.
///
///     adapt_bench [CYCLES] [CASE...]
///
/// A cycle adapts to the metric given at the nodes of the mesh, as the peers do it; the formula is
/// evaluated again on the result. What is printed is measured in the formula at the nodes.
#include "core/adapt/adapt.h"
#include "core/cases/analytic_metric.h"
#include "core/cases/cube.h"

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

const std::vector<Case> cases{{"linear", AnalyticMetric::linear, 0},
                              {"polar-1", AnalyticMetric::polar_1, 0},
                              {"polar-2", AnalyticMetric::polar_2, 0},
                              {"bl1e-3", AnalyticMetric::layer, 1e-3},
                              {"bl1e-4", AnalyticMetric::layer, 1e-4},
                              {"bl1e-5", AnalyticMetric::layer, 1e-5},
                              {"bl1e-6", AnalyticMetric::layer, 1e-6},
                              {"skew1e-3", AnalyticMetric::skew, 1e-3},
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

void run(const Case& c, int cycles, bool verbose) {
    Mesh<3> mesh = make_cube<3>({.n = 20, .displace = 0});
    const double begin = cpu_seconds();
    for (int n = 1; n <= cycles; ++n) {
        const MetricField<3> field = evaluate(c, mesh);
        const BackgroundMetric<3> source(mesh, field);
        AdaptReport report;
        mesh = adapt(mesh, source, {}, report).mesh;
        const Conformity k = conformity(mesh, evaluate(c, mesh));
        std::printf("%-9s %d %7zu %7.2f %6.1f  %.2f %.2f  %.1e/%.2f\n", c.name.c_str(), n,
                    mesh.points.size(), cpu_seconds() - begin, 100 * k.in_band, k.shortest,
                    k.longest, k.worst_quality, k.mean_quality);
        if (verbose) {
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
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    const int cycles = argc > 1 ? std::atoi(argv[1]) : 3;
    std::printf("case    cycle   nodes   cpu s  unit%%  lengths    quality\n");
    for (const Case& c : cases) {
        bool wanted = argc <= 2;
        for (int i = 2; i < argc; ++i) {
            wanted = wanted || c.name == argv[i];
        }
        if (wanted) {
            run(c, cycles, std::getenv("ADAPT_BENCH_PASSES") != nullptr);
        }
    }
    return 0;
}
