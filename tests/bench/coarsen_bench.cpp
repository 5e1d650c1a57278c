// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the coarsener reaches, beside the ideal or the paper, and what it costs.
///
///     coarsen_bench box layers m6 means algorithms isotropic control scaling
///
/// takes the parts wanted, and without arguments box, layers and m6.
#include "core/base/parallel.h"
#include "core/cases/box.h"
#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "core/cases/onera_m6.h"
#include "core/coarsen/target_ratio.h"
#include "core/metric/aspect_ratio.h"

#include <sys/resource.h>

#include <cstdio>
#include <ctime>
#include <string>

using namespace ameco;

namespace {

double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double peak_gib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024 / 1024;
}

double ratio(const CoarsenReport& r) {
    return static_cast<double>(r.nodes_before) / static_cast<double>(r.nodes_after);
}

template <int D>
void box_row(double dz, Diagonals diagonals) {
    BoxOptions box;
    box.ratio = dz;
    box.diagonals = diagonals;
    CoarsenReport report;
    (void)coarsen(finest_level(make_box<D>(box), {}), {}, report);
    std::printf("%d-D  %8.0e  %-12s %3lld -> %lld\n", D, dz,
                diagonals == Diagonals::uniform ? "uniform" : "alternating",
                static_cast<long long>(report.nodes_before),
                static_cast<long long>(report.nodes_after));
}

void boxes() {
    std::printf("Box of section 5.1 (paper: 27 -> 18)\n      dz/dx     diagonals    nodes\n");
    for (const double dz : {1e-3, 1e-4, 1e-5, 1e-6}) {
        for (const Diagonals diagonals : {Diagonals::uniform, Diagonals::alternating}) {
            box_row<3>(dz, diagonals);
            box_row<2>(dz, diagonals);
        }
    }
}

/// Nodes of the same case with every 2^k-th layer: what an ideal semi-coarsening leaves.
template <int D>
std::size_t ideal_nodes(LayerOptions layer, int k) {
    layer.every = 1 << k;
    return make_layer<D>(layer).points.size();
}

template <int D>
void layer_rows(const LayerOptions& layer) {
    const int per_layer = (layer.nx + 1) * (D == 3 ? layer.ny + 1 : 1);
    Level<D> level = finest_level(make_layer<D>(layer), {});
    std::vector<NodeId> finest;
    for (const NodeId v : level.mesh.points.ids()) {
        finest.push_back(v);
    }
    for (int k = 1; k <= 5; ++k) {
        CoarsenReport report;
        level = coarsen(level, {}, report);
        std::vector<NodeId> ids;
        std::int64_t wrong = 0;
        for (const NodeId parent : level.parent) {
            ids.push_back(finest[parent.index()]);
            wrong += (ids.back().value() / per_layer) % (1 << k) != 0;
        }
        finest = std::move(ids);
        const double ideal = static_cast<double>(ideal_nodes<D>(layer, k - 1)) /
                             static_cast<double>(ideal_nodes<D>(layer, k));
        std::printf("%d-D  %7.0e  %6.2f   %5d  %8lld  %6.3f  %6.3f  %9.2f %%  %6.3f\n", D,
                    layer.aspect_ratio, layer.growth, k, static_cast<long long>(report.nodes_after),
                    ratio(report), ideal,
                    100 * static_cast<double>(wrong) / static_cast<double>(finest.size()),
                    static_cast<double>(report.nodes_after) / report.predicted_nodes);
    }
}

void layers() {
    std::printf("\nLayers of 24 x 24 x 32 cells (2-D: 96 x 32), columns displaced by 20 %%; ideal: "
                "every other layer\n"
                "          AR   growth   level     nodes   ratio   ideal  wrong layer  reached\n");
    for (const double aspect : {1e2, 1e4, 1e5, 1e6}) {
        for (const double growth : {1.0, 1.2}) {
            LayerOptions layer;
            layer.aspect_ratio = aspect;
            layer.growth = growth;
            layer_rows<3>(layer);
            layer.nx = 96;
            layer_rows<2>(layer);
        }
    }
}

void print_classes(const std::vector<AspectRatioClasses>& levels) {
    std::printf("\nPer cent of nodes by aspect ratio (figure 11)\n");
    for (std::size_t c = 0; c < levels[0].counts.size(); ++c) {
        std::printf("  %8.1f - %8.1f ", levels[0].lower(c), levels[0].upper(c));
        for (const AspectRatioClasses& level : levels) {
            std::int64_t total = 0;
            for (const std::int64_t n : level.counts) {
                total += n;
            }
            std::printf(" %6.2f",
                        100 * static_cast<double>(level.counts[c]) / static_cast<double>(total));
        }
        std::printf("\n");
    }
}

OneraM6Options preset(const std::string& name) {
    for (const OneraM6Preset& p : onera_m6_presets()) {
        if (p.name == name) {
            return p.options;
        }
    }
    return {};
}

void wing() {
    const double paper[4] = {2.19, 1.99, 1.77, 1.63};
    Level<3> level = finest_level(make_onera_m6(preset("m6-67k")), {});
    std::vector<AspectRatioClasses> classes{classify_aspect_ratios(level.natural)};
    std::printf("\nONERA M6, %zu nodes\n"
                "level    nodes   ratio  paper  reached  in band  own  worst Q  volume\n",
                level.mesh.points.size());
    for (int k = 1; k <= 4; ++k) {
        const double own = conformity(level.mesh, level.natural).in_band;
        CoarsenReport r;
        level = coarsen(level, {}, r);
        classes.push_back(classify_aspect_ratios(level.natural, classes[0].max));
        std::printf("%5d %8lld  %6.3f  %5.2f  %7.3f  %5.1f %%  %4.1f  %7.1e  %.3f\n", k,
                    static_cast<long long>(r.nodes_after), ratio(r), paper[k - 1],
                    static_cast<double>(r.nodes_after) / r.predicted_nodes,
                    100 * r.conformity.in_band, 100 * own, r.conformity.worst_quality,
                    r.check.volume);
    }
    print_classes(classes);
}

/// "nodes (ratio, share of predicted, in band)" of some levels in a row.
template <int D>
void print_levels(const std::string& what, Level<D> level, const CoarsenOptions& options,
                  int levels, double target_ratio = 0) {
    std::printf("%-34s", what.c_str());
    for (int k = 1; k <= levels; ++k) {
        CoarsenReport r;
        level = target_ratio > 0 ? coarsen_by_ratio(level, options, target_ratio, r)
                                 : coarsen(level, options, r);
        std::printf("  %6lld %.3f %.2f %4.1f %4.1f", static_cast<long long>(r.nodes_after),
                    ratio(r), static_cast<double>(r.nodes_after) / r.predicted_nodes,
                    100 * r.conformity.in_band, 100 * r.conformity.above_two);
        std::fflush(stdout);
    }
    std::printf("\n");
}

/// Table 1 with all our means.
void means() {
    std::printf(
        "\nTable 1: ONERA M6, nodes, ratio, share of the predicted nodes, edges in band and "
        "above 2 [%%]; four levels\n"
        "paper, interp (67866 nodes)         30961 2.19  15123 1.99  8507 1.77  5213 1.63\n"
        "paper, log                          39010 1.74  22264 1.75  13246 1.68  8323 1.59\n");
    const Mesh<3> mesh = make_onera_m6(preset("m6-67k"));
    for (const double slack : {1.0, 1.15}) {
        for (const Mean mean : all_means) {
            if (mean == Mean::geodesic_fixed_step) {
                continue;
            }
            CoarsenOptions options;
            options.mean = mean;
            options.target.slack = slack;
            options.target.isotropic_below = 1; // the paper's Algorithm 1
            char what[64];
            std::snprintf(what, sizeof what, "%s, slack %.2f", name(mean).data(), slack);
            print_levels(what, finest_level(mesh, options), options, 4);
        }
    }
}

/// Figures 4 and 5: a layer beside an isotropic zone.
void algorithms() {
    std::printf(
        "\nInterface: heights 1/16, 1/4, 1, 1, ... of the width; nodes, ratio, share of the "
        "predicted nodes, edges in band and above 2 [%%]; two levels. Graded layer: aspect ratio "
        "1e2, growth 1.2; M6, 67,455 nodes\n");
    LayerOptions layer;
    layer.aspect_ratio = 16;
    layer.growth = 4;
    const Mesh<3> mesh_3d = make_layer<3>(layer);
    layer.nx = 96;
    const Mesh<2> mesh_2d = make_layer<2>(layer);
    layer = {};
    layer.aspect_ratio = 1e2;
    layer.growth = 1.2;
    const Mesh<3> graded_layer = make_layer<3>(layer);
    const Mesh<3> wing_mesh = make_onera_m6(preset("m6-67k"));
    for (const TargetAlgorithm algorithm : all_target_algorithms) {
        for (const double beta : {1.2, 1.5}) {
            if (algorithm != TargetAlgorithm::graded && beta > 1.2) {
                continue;
            }
            CoarsenOptions options;
            options.target.algorithm = algorithm;
            options.target.gradation = beta;
            const std::string what =
                std::string(name(algorithm)) +
                (algorithm == TargetAlgorithm::graded ? beta > 1.2 ? ", 1.5" : ", 1.2" : "");
            print_levels("3-D, " + what, finest_level(mesh_3d, options), options, 2);
            print_levels("2-D, " + what, finest_level(mesh_2d, options), options, 2);
            print_levels("graded layer, " + what, finest_level(graded_layer, options), options, 3);
            print_levels("M6, " + what, finest_level(wing_mesh, options), options, 4);
        }
    }
}

/// Meshes without layers.
void isotropic() {
    std::printf("\nIsotropic meshes; nodes, ratio, share of the predicted nodes, edges in band and "
                "above 2 [%%]; three levels\n");
    for (const double below : {1.0, TargetOptions{}.isotropic_below}) {
        CoarsenOptions options;
        options.target.isotropic_below = below;
        char end[32];
        std::snprintf(end, sizeof end, ", below %.1f", below);
        for (const Diagonals diagonals : {Diagonals::uniform, Diagonals::random}) {
            CubeOptions cube;
            cube.n = 24;
            cube.diagonals = diagonals;
            const std::string what = diagonals == Diagonals::uniform ? "Kuhn" : "random diagonals";
            print_levels("cube, " + what + end, finest_level(make_cube<3>(cube), options), options,
                         3);
            cube.n = 100;
            print_levels("square, " + what + end, finest_level(make_cube<2>(cube), options),
                         options, 3);
        }
    }
}

void control() {
    std::printf("\nONERA M6 with other factors and with given ratios; nodes, ratio, share of the "
                "predicted nodes, edges in band and above 2 [%%]; four levels\n");
    const Mesh<3> mesh = make_onera_m6(preset("m6-67k"));
    for (const double factor : {1.5, 2.0, 4.0, 8.0}) {
        CoarsenOptions options;
        options.target.factor = factor;
        print_levels("factor " + std::to_string(factor).substr(0, 3), finest_level(mesh, options),
                     options, 4);
    }
    for (const double target : {1.7, 2.0, 2.2}) {
        print_levels("target ratio " + std::to_string(target).substr(0, 3), finest_level(mesh, {}),
                     {}, 4, target);
    }
}

void scaling() {
    std::printf(
        "\nCost of a level on one thread [s], and per node [us]\n"
        "mesh     level      nodes ->     after  ratio  metric  order  first  later   swap  "
        "check   total  us/node  first pass removed/s  peak GiB\n");
    for (const std::string name : {"m6-67k", "m6-500k", "m6-2m"}) {
        Level<3> level = finest_level(make_onera_m6(preset(name)), {});
        for (int k = 1; k <= 4; ++k) {
            CoarsenReport r;
            const double begin = cpu_seconds();
            level = coarsen(level, {}, r);
            const double cpu = cpu_seconds() - begin;
            const PhaseSeconds& t = r.seconds;
            std::printf("%-8s %5d %10lld -> %9lld  %5.3f  %6.2f %6.2f %6.2f %6.2f %6.2f  %5.2f  "
                        "%6.2f  %7.2f  %20.0f  %8.2f\n",
                        name.c_str(), k, static_cast<long long>(r.nodes_before),
                        static_cast<long long>(r.nodes_after), ratio(r), t.metric, t.order,
                        t.first_pass, t.remove, t.swap, t.check, cpu,
                        1e6 * cpu / static_cast<double>(r.nodes_before),
                        static_cast<double>(r.removed_in_first_pass) / t.first_pass, peak_gib());
            std::fflush(stdout);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    set_thread_count(1);
    const auto wanted = [&](const std::string& part) {
        for (int i = 1; i < argc; ++i) {
            if (part == argv[i]) {
                return true;
            }
        }
        return argc == 1 && (part == "box" || part == "layers" || part == "m6");
    };
    if (wanted("box")) {
        boxes();
    }
    if (wanted("layers")) {
        layers();
    }
    if (wanted("m6")) {
        wing();
    }
    if (wanted("means")) {
        means();
    }
    if (wanted("algorithms")) {
        algorithms();
    }
    if (wanted("isotropic")) {
        isotropic();
    }
    if (wanted("control")) {
        control();
    }
    if (wanted("scaling")) {
        scaling();
    }
    return 0;
}
