// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Curved walls, layers inside the domain and between walls, and a sphere down to isotropy: what
/// the coarsener reaches there, and how well it keeps the boundary; a sphere and a cylinder, also
/// of one patch, adapted to a metric, with and without moves of the nodes on them.
///
///     curved_bench walls inside adapt deep [frequency]
///
/// takes the parts wanted, and without arguments walls and inside.
#include "core/adapt/adapt.h"
#include "core/base/parallel.h"
#include "core/cases/layer.h"
#include "core/cases/shell.h"
#include "core/geometry/distance.h"
#include "core/metric/aspect_ratio.h"
#include "tests/support/boundary_fit.h"
#include "tests/support/layered_cases.h"

#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

using namespace ameco;

namespace {

constexpr int wall = 1; ///< patch of the wall, in all cases

double percent(double share) {
    return 100 * share;
}

/// Beyond the wall, the patch that has moved farthest over its h_1.
double farthest_other(const std::map<int, boundary_fit::Fit>& fits) {
    double largest = 0;
    for (const auto& [patch, fit] : fits) {
        largest = patch == wall ? largest : std::max(largest, fit.over_short);
    }
    return largest;
}

/// \param own  share of the fine mesh's edges in band, in its own natural metric: the yardstick
void print_level(const char* what, double aspect, int k, double own, const CoarsenReport& r,
                 const Level<3>& coarse, const Mesh<3>& finest, double volume) {
    const auto fits = boundary_fit::measure(coarse, finest);
    std::printf("%-14s %6.0e %5d %8lld  %6.3f  %6.3f  %8.1e  %8.1e  %8.1e  %8.1e  %9.1e  %9.1e  "
                "%5.1f %5.1f\n",
                what, aspect, k, static_cast<long long>(r.nodes_after),
                static_cast<double>(r.nodes_before) / static_cast<double>(r.nodes_after),
                static_cast<double>(r.nodes_after) / r.predicted_nodes, fits.at(wall).over_edge,
                fits.at(wall).over_short, farthest_other(fits), r.deviation_relative,
                r.check.volume / volume - 1, boundary_fit::area_change(coarse.mesh, finest),
                percent(r.conformity.in_band), percent(own));
    std::fflush(stdout);
}

void print_head() {
    std::printf("case               AR level    nodes   ratio reached  wall/edge   wall/h1  "
                "other/h1  bound/edge    volume       area  in band, own [%%]\n");
}

void print_levels(const char* what, double aspect, Mesh<3> mesh, int levels) {
    Level<3> level = finest_level(std::move(mesh), {});
    const Mesh<3> finest = level.mesh;
    const double volume = check(finest).volume;
    for (int k = 1; k <= levels; ++k) {
        const double own = conformity(level.mesh, level.natural).in_band;
        CoarsenReport r;
        level = coarsen(level, {}, r);
        print_level(what, aspect, k, own, r, level, finest, volume);
    }
}

void walls() {
    std::printf(
        "\nCurved walls. d: measured distance to the finest boundary, over the mean edge of "
        "the coarse face and over the coarse h1; bound: that of the report; volume and "
        "area: relative change, of the patch that changes most\n");
    print_head();
    for (const double aspect : {1e4, 1e5, 1e6}) {
        LayerOptions layer;
        layer.aspect_ratio = aspect;
        layer.curvature = 1;
        print_levels("convex plate", aspect, make_layer<3>(layer), 5);
        layer.curvature = -1;
        print_levels("concave plate", aspect, make_layer<3>(layer), 5);
        const double step = 2 * std::numbers::pi / 48;
        print_levels("cylinder", aspect,
                     layered_cases::cylinder(48, 12, growing_layers(step / aspect, 1.2, step, 48)),
                     5);
        ShellOptions shell;
        shell.frequency = 8;
        shell.aspect_ratio = aspect;
        print_levels("sphere", aspect, make_shell(shell), 5);
        shell.a = 3;
        shell.b = 2;
        print_levels("ellipsoid", aspect, make_shell(shell), 5);
    }
}

void inside() {
    std::printf("\nLayers inside the domain and between walls, 12 x 12 columns, 2 x 32 layers\n");
    print_head();
    constexpr int n = 12;
    for (const double aspect : {1e4, 1e5, 1e6}) {
        const double dx = 1.0 / n, first = dx / aspect;
        print_levels("shear layer", aspect,
                     layered_cases::box(n, layered_cases::about_plane(first, 1.2, dx, 32)), 4);
        print_levels("thin gap", aspect,
                     layered_cases::box(n, layered_cases::between_walls(first, 1.2, dx, 32)), 4);
        Mesh<3> wake = layered_cases::box(n, layered_cases::about_plane(first, 1.2, dx, 32));
        layered_cases::add_sheet(wake, n);
        print_levels("wake sheet", aspect, std::move(wake), 4);
    }
}

/// Sizes by the distance from the unit sphere or cylinder, in layers along it.
class WallMetric : public MetricSource<3> {
public:
    WallMetric(bool cylinder, double first, double size)
        : cylinder_(cylinder), first_(first), size_(size) {}
    [[nodiscard]] Metric<3> at(const Vec<3>& p, NodeId& /*near*/) const override {
        const Vec<3> out(p[0], cylinder_ ? 0 : p[1], p[2]);
        const double radius = out.norm();
        Metric<3> m;
        m.sizes.setConstant(size_);
        m.sizes[0] = std::min(first_ + 0.2 * std::abs(radius - 1), size_);
        m.directions.col(0) = out / radius;
        m.directions.col(1) = m.directions.col(0).unitOrthogonal();
        m.directions.col(2) = m.directions.col(0).cross(m.directions.col(1));
        return m;
    }

private:
    bool cylinder_;
    double first_, size_;
};

/// Share of edges that are in band; 1 of none.
double in_band(const std::set<Edge>& edges, const Mesh<3>& mesh, const MetricField<3>& field) {
    const auto count = std::count_if(edges.begin(), edges.end(), [&](const Edge& edge) {
        const auto [a, b] = edge;
        const Vec<3> e = mesh.points[b] - mesh.points[a];
        const double length =
            edge_length((length_factor(field[a]) * e).norm(), (length_factor(field[b]) * e).norm());
        return length > 1 / std::numbers::sqrt2 && length < std::numbers::sqrt2;
    });
    return edges.empty() ? 1 : static_cast<double>(count) / static_cast<double>(edges.size());
}

/// Those of boundary faces.
std::set<Edge> surface_edges(const Mesh<3>& mesh) {
    std::set<Edge> edges;
    for (const Facet<3>& f : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            edges.insert(sorted(Edge{f[i], f[(i + 1) % 3]}));
        }
    }
    return edges;
}

std::set<Edge> ridge_edges(const Mesh<3>& mesh) {
    std::set<Edge> edges;
    for (const RidgeEdge& r : classify_geometry(mesh).ridges) {
        edges.insert(r.nodes);
    }
    return edges;
}

/// Share of the nodes of edges that lie on others, to rounding; 1 of none.
double on_edges_of(const std::set<Edge>& edges, const Mesh<3>& mesh,
                   const std::set<Edge>& given_edges, const Mesh<3>& given) {
    std::set<NodeId> nodes;
    for (const Edge& e : edges) {
        nodes.insert(e.begin(), e.end());
    }
    const auto on = std::count_if(nodes.begin(), nodes.end(), [&](NodeId v) {
        return std::any_of(given_edges.begin(), given_edges.end(), [&](const Edge& e) {
            const Vec<3>&a = given.points[e[0]], &b = given.points[e[1]];
            return distance(mesh.points[v], {a, b, b}) <= 1e-12;
        });
    });
    return nodes.empty() ? 1 : static_cast<double>(on) / static_cast<double>(nodes.size());
}

/// Share of the nodes of the boundary that lie on that of another mesh, to rounding.
double on_boundary_of(const Mesh<3>& mesh, const Mesh<3>& original) {
    const BoundaryProjection<3> projection(original);
    const auto patches = node_patches(mesh);
    double on = 0, all = 0;
    for (const NodeId v : mesh.points.ids()) {
        if (!patches[v].empty()) {
            ++all;
            on += projection.project(mesh.points[v], patches[v]).distance <= 1e-12 ? 1 : 0;
        }
    }
    return on / all;
}

void adapt_one(const char* what, const Mesh<3>& mesh, const WallMetric& metric) {
    for (const bool moves : {false, true}) {
        AdaptOptions options;
        options.move_curved = moves;
        AdaptReport r;
        const Adapted<3> made = adapt(mesh, metric, options, r);
        const Level<3> level{made.mesh, {}, made.metric, {}};
        double distance = 0;
        for (const auto& [patch, fit] : boundary_fit::measure(level, mesh)) {
            distance = std::max(distance, fit.over_edge);
        }
        const std::set<Edge> ridges = ridge_edges(made.mesh);
        std::printf(
            "%-22s %-5s %7lld %6.1f %6.1f %6.1f %6.1f  %5.2f %5.2f  %.3f / %.3f  %7.4f  %9.1e  "
            "%9.1e %8lld %6.1f %6.1f\n",
            what, moves ? "move" : "stay", static_cast<long long>(r.nodes_after), r.seconds,
            percent(r.conformity.in_band),
            percent(in_band(surface_edges(made.mesh), made.mesh, made.metric)),
            percent(in_band(ridges, made.mesh, made.metric)), r.conformity.shortest,
            r.conformity.longest, r.conformity.worst_quality, r.conformity.mean_quality, distance,
            r.check.volume / check(mesh).volume - 1, boundary_fit::area_change(made.mesh, mesh),
            static_cast<long long>(r.moves[Verdict::accepted]),
            percent(on_boundary_of(made.mesh, mesh)),
            percent(on_edges_of(ridges, made.mesh, ridge_edges(mesh), mesh)));
        std::fflush(stdout);
    }
}

void adapt_curved() {
    std::printf(
        "\nAdaptation on curved walls; nodes of the walls stay or move. In band: all edges, "
        "those of the boundary, of its ridges [%%]; distance: largest to the boundary given, over "
        "the edge; volume and area: relative change; on: nodes of the boundary, of its ridges, "
        "that lie on those given [%%]\n"
        "case                   nodes     after      s    all  bound. ridges     lengths      "
        "quality       distance    volume       area    moves     on  ridges\n");
    ShellOptions shell;
    shell.frequency = 8;
    shell.aspect_ratio = 10;
    shell.growth = 1.5;
    shell.far_field = 2;
    const Mesh<3> sphere = make_shell(shell);
    const Mesh<3> cylinder = layered_cases::cylinder(48, 12, growing_layers(0.02, 1.5, 0.3, 6));
    adapt_one("sphere", sphere, WallMetric(false, 0.2, 0.2));
    adapt_one("sphere, layer", sphere, WallMetric(false, 0.02, 0.15));
    adapt_one("cylinder", cylinder, WallMetric(true, 0.2, 0.2));
    adapt_one("cylinder, layer", cylinder, WallMetric(true, 0.02, 0.15));
    Mesh<3> one_patch = cylinder;
    layered_cases::join_patches(one_patch);
    adapt_one("one patch", one_patch, WallMetric(true, 0.2, 0.2));
    adapt_one("one patch, layer", one_patch, WallMetric(true, 0.02, 0.15));
    Mesh<3> coarse = layered_cases::cylinder(16, 4, growing_layers(0.1, 1.5, 0.4, 4));
    layered_cases::join_patches(coarse);
    adapt_one("one patch, finer", coarse, WallMetric(true, 0.15, 0.15));
}

/// Ratio of the meshes that keep every 2^(k-1)-th and every 2^k-th layer.
double ideal_ratio(ShellOptions shell, int k) {
    shell.every = 1 << (k - 1);
    const auto fine = static_cast<double>(make_shell(shell).points.size());
    shell.every = 1 << k;
    return fine / static_cast<double>(make_shell(shell).points.size());
}

/// What was said about the nodes that were looked at, the most frequent first.
std::string words_of(const VerdictCounts& counts, std::int64_t nodes) {
    std::vector<std::pair<std::int64_t, std::size_t>> order;
    for (std::size_t i = 0; i < verdict_count; ++i) {
        if (counts.counts[i] > 0 && static_cast<Verdict>(i) != Verdict::accepted) {
            order.emplace_back(-counts.counts[i], i);
        }
    }
    std::sort(order.begin(), order.end());
    std::string text;
    for (std::size_t k = 0; k < std::min<std::size_t>(order.size(), 5); ++k) {
        char part[64];
        std::snprintf(part, sizeof part, "  %s %.2f",
                      name(static_cast<Verdict>(order[k].second)).data(),
                      static_cast<double>(-order[k].first) / static_cast<double>(nodes));
        text += part;
    }
    return text;
}

void deep(int frequency) {
    ShellOptions shell;
    shell.frequency = frequency;
    shell.aspect_ratio = 1e5;
    Level<3> level = finest_level(make_shell(shell), {});
    const Mesh<3> finest = level.mesh;
    const double volume = check(finest).volume;
    std::printf(
        "\nSphere of %zu nodes, AR 1e5, down to isotropy. Ideal: every other layer; AR: "
        "largest, after; boundary: share of the nodes on it; then refusals in the removal "
        "passes per node of the fine mesh\n"
        "level    nodes   ratio   ideal reached    max AR  boundary  wall/edge wall/h1    volume  "
        "in band  worst Q  refusals\n",
        finest.points.size());
    for (int k = 1; k <= 24; ++k) {
        CoarsenReport r;
        Level<3> next = coarsen(level, {}, r);
        if (static_cast<double>(r.nodes_after) > 0.95 * static_cast<double>(r.nodes_before)) {
            std::printf("%5d %8lld: the end;%s\n", k, static_cast<long long>(r.nodes_after),
                        words_of(r.removal, r.nodes_before).c_str());
            break;
        }
        level = std::move(next);
        const auto fit = boundary_fit::measure(level, finest).at(wall);
        const auto patches = node_patches(level.mesh);
        const auto outer = std::count_if(patches.begin(), patches.end(),
                                         [](const auto& list) { return !list.empty(); });
        const AspectRatioSummary aspect = summarise_aspect_ratios(level.natural);
        std::printf(
            "%5d %8lld  %6.3f  %6.3f  %6.3f  %8.1f  %6.1f %%  %6.3f  %6.3f  %8.1e  %5.1f %%  "
            "%7.1e%s\n",
            k, static_cast<long long>(r.nodes_after),
            static_cast<double>(r.nodes_before) / static_cast<double>(r.nodes_after),
            ideal_ratio(shell, k), static_cast<double>(r.nodes_after) / r.predicted_nodes,
            aspect.max, percent(static_cast<double>(outer) / static_cast<double>(r.nodes_after)),
            fit.over_edge, fit.over_short, r.check.volume / volume - 1,
            percent(r.conformity.in_band), r.conformity.worst_quality,
            words_of(r.removal, r.nodes_before).c_str());
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    set_thread_count(1);
    const auto wanted = [&](const std::string& part) {
        return std::find(argv + 1, argv + argc, part) != argv + argc;
    };
    if (argc == 1 || wanted("walls")) {
        walls();
    }
    if (argc == 1 || wanted("inside")) {
        inside();
    }
    if (wanted("adapt")) {
        adapt_curved();
    }
    if (wanted("deep")) {
        const int frequency = std::atoi(argv[argc - 1]);
        deep(frequency > 0 ? frequency : 8);
    }
    return 0;
}
