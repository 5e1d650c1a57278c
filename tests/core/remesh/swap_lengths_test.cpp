// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/swap_lengths.h"

#include "core/cases/layer.h"
#include "core/metric/edge_length.h"
#include "core/metric/length_excess.h"
#include "core/remesh/coarsening_rules.h"
#include "tests/core/remesh/swap_support.h"

#include <QTest>

#include <numeric>

using namespace ameco;
using namespace ameco::remesh_test;
using shapes::nodes;

namespace {

template <int D>
IdVector<NodeId, Mat<D>> factors_of(const MetricField<D>& field) {
    IdVector<NodeId, Mat<D>> factors;
    for (const Metric<D>& metric : field) {
        factors.push_back(length_factor(metric));
    }
    return factors;
}

template <int D>
struct Look {
    double excess = 0;  ///< sum over the edges
    double quality = 1; ///< worst of all elements
    int lineless = 0;
};

template <int D>
Look<D> look_at(const Workbench<D>& bench, const Lines& lines) {
    Look<D> look;
    const auto factor = factors_of<D>(bench.metric);
    std::set<Edge> edges;
    for (std::size_t i = 0; i < bench.edit.slot_count(); ++i) {
        const ElementId e(i);
        if (bench.edit.is_free(e) || bench.edit.is_ghost(e)) {
            continue;
        }
        const Simplex<D>& s = bench.edit.nodes(e);
        look.quality = std::min(look.quality, metric_quality(bench.edit, bench.root, s));
        look.lineless += is_lineless<D>(lines, s);
        for (const auto& [j, k] : SimplexNumbering<D>::edges) {
            edges.insert(sorted(Edge{s[j], s[k]}));
        }
    }
    for (const auto& [a, b] : edges) {
        const Vec<D> e = bench.edit.point(b) - bench.edit.point(a);
        look.excess += length_excess(edge_length((factor[a] * e).norm(), (factor[b] * e).norm()));
    }
    return look;
}

/// What the elements of a mesh under edit add to the diagonal of the stiffness matrix.
template <int D>
IdVector<NodeId, double> stiffness_diagonal(const EditMesh<D>& mesh) {
    IdVector<NodeId, double> diagonal(mesh.node_count(), 0);
    for (std::size_t i = 0; i < mesh.slot_count(); ++i) {
        const ElementId e(i);
        if (mesh.is_free(e) || mesh.is_ghost(e)) {
            continue;
        }
        const Simplex<D>& s = mesh.nodes(e);
        const double volume = volume_of(mesh, s);
        for (int k = 0; k <= D; ++k) {
            const Facet<D> f = facet_of<D>(s, k);
            if constexpr (D == 2) {
                diagonal[s[k]] += (mesh.point(f[1]) - mesh.point(f[0])).squaredNorm() / volume / 4;
            } else {
                const Vec<3> a = mesh.point(f[0]);
                diagonal[s[k]] +=
                    (mesh.point(f[1]) - a).cross(mesh.point(f[2]) - a).squaredNorm() / volume / 36;
            }
        }
    }
    return diagonal;
}

/// Swaps, and verifies what must not change. Returns how many swaps were made.
template <int D>
std::int64_t swap_and_verify(Workbench<D>& bench, const Lines& lines,
                             const LengthSwapOptions& options = {}) {
    const Extent extent_before = extent(bench.edit.compact().mesh);
    const Look<D> before = look_at(bench, lines);
    VerdictCounts verdicts;
    swap_lengths<D>(bench.edit,
                    {bench.sizes, bench.root, bench.short_size, lines, bench.removed, bench.notes},
                    factors_of<D>(bench.metric), options, plane_sides, verdicts);
    const Look<D> after = look_at(bench, lines);
    const auto compact = bench.edit.compact();
    const CheckReport report = check(compact.mesh);
    const double changed = difference(extent_before, extent(compact.mesh));
    const std::int64_t made = verdicts[Verdict::accepted];
    if (!report.valid() || !(changed <= 1e-11)) {
        qWarning("after swaps: %s, extent changed by %g", report.summary().c_str(), changed);
        return -1;
    }
    const double lowest = std::min(before.quality, options.quality_floor) * (1 - 1e-6);
    const double most = before.excess - static_cast<double>(made) * least_excess_fall;
    if (after.excess > most + 1e-9 || after.quality < lowest || after.lineless > before.lineless) {
        qWarning("%lld swaps: excess %g to %g, worst quality %g to %g, lineless elements %d to %d",
                 static_cast<long long>(made), before.excess, after.excess, before.quality,
                 after.quality, before.lineless, after.lineless);
        return -1;
    }
    return made;
}

/// By how much nodes got stiffer [-].
struct Growth {
    std::int64_t swaps = 0;
    double largest = 0, largest_on_lines = 0;
};

Growth swap_and_compare(Workbench<3>& bench, const Lines& lines, const LengthSwapOptions& options) {
    Growth growth;
    const auto before = stiffness_diagonal(bench.edit);
    growth.swaps = swap_and_verify(bench, lines, options);
    const auto after = stiffness_diagonal(bench.edit);
    for (const NodeId v : bench.edit.nodes()) {
        if (!bench.edit.is_removed(v)) {
            double& largest = lines.on_line(v) ? growth.largest_on_lines : growth.largest;
            largest = std::max(largest, after[v] / before[v]);
        }
    }
    return growth;
}

template <int D>
void bring_displaced_cubes_into_band(int n, unsigned seed) {
    const Mesh<D> mesh = displaced_cube<D>(n, seed);
    Workbench<D> bench(mesh, isotropic<D>(mesh.points.size(), 2.0 / n));
    thin_out(bench, 400, seed);
    const Lines lines = no_lines(mesh.points.size());
    QCOMPARE_GT(swap_and_verify(bench, lines), 5);
}

template <int D>
void keep_lines(double aspect_ratio, unsigned seed) {
    const Mesh<D> mesh = make_layer<D>({.nx = D == 2 ? 16 : 5,
                                        .ny = 5,
                                        .nz = 10,
                                        .aspect_ratio = aspect_ratio,
                                        .jitter = 0.2,
                                        .diagonals = Diagonals::random,
                                        .seed = static_cast<int>(seed)});
    Workbench<D> bench(mesh);
    const Lines lines = lines_of(bench);
    thin_out(bench, 400, seed);
    QCOMPARE_GE(swap_and_verify(bench, lines), 1);
}

/// A kite whose edge 0 1 is too long and whose other diagonal is 1, in a metric of unit squares.
Mesh<2> kite(double half_length) {
    return shapes::from_literals<2>({{-half_length, 0}, {half_length, 0}, {0, 0.5}, {0, -0.5}},
                                    {nodes(0, 1, 2), nodes(1, 0, 3)});
}

bool has_edge(const EditMesh<2>& mesh, int a, int b) {
    const auto around = neighbours(mesh, NodeId(a));
    return std::find(around.begin(), around.end(), NodeId(b)) != around.end();
}

} // namespace

class SwapLengthsTest : public QObject {
    Q_OBJECT
private slots:
    void a_long_edge_gives_way_to_one_in_band();
    void edges_in_band_stay_whatever_the_quality();
    void no_element_falls_below_the_floor();
    void no_node_gets_stiffer_than_allowed();
    void nodes_of_lines_have_a_bound_of_their_own();
    void excess_falls_in_displaced_boxes_and_all_else_holds_data();
    void excess_falls_in_displaced_boxes_and_all_else_holds();
    void no_elements_off_the_lines_of_a_layer_appear();
    void the_boundary_and_required_elements_stay();
    void no_rounds_change_nothing();
};

void SwapLengthsTest::a_long_edge_gives_way_to_one_in_band() {
    Workbench<2> bench(kite(0.8), isotropic<2>(4, 1));
    QCOMPARE(swap_and_verify(bench, no_lines(4)), 1);
    QVERIFY(!has_edge(bench.edit, 0, 1));
    QVERIFY(has_edge(bench.edit, 2, 3));
}

void SwapLengthsTest::edges_in_band_stay_whatever_the_quality() {
    Workbench<2> bench(kite(0.7), isotropic<2>(4, 1)); // 1.4 long; the other diagonal is better
    QCOMPARE(swap_and_verify(bench, no_lines(4)), 0);
    QVERIFY(has_edge(bench.edit, 0, 1));
}

void SwapLengthsTest::no_element_falls_below_the_floor() {
    // The other diagonal cuts off a triangle at its left end that is as good as flat.
    const Mesh<2> mesh = shapes::from_literals<2>({{-0.02, 0}, {2, 0}, {0, 0.5}, {0, -0.5}},
                                                  {nodes(0, 1, 2), nodes(1, 0, 3)});
    Workbench<2> strict(mesh, isotropic<2>(4, 1));
    QCOMPARE(swap_and_verify(strict, no_lines(4), {.stiffening = 1e9, .size_floor = 0}), 0);
    Workbench<2> lax(mesh, isotropic<2>(4, 1));
    QCOMPARE(swap_and_verify(lax, no_lines(4),
                             {.quality_floor = 1e-6, .stiffening = 1e9, .size_floor = 0}),
             1);
}

void SwapLengthsTest::no_node_gets_stiffer_than_allowed() {
    const Mesh<3> mesh = displaced_cube<3>(6, 3);
    const Lines lines = no_lines(mesh.points.size());
    const auto swapped = [&](double stiffening) {
        Workbench<3> bench(mesh, isotropic<3>(mesh.points.size(), 2.0 / 6));
        thin_out(bench, 400, 3);
        return swap_and_compare(bench, lines, {.stiffening = stiffening, .rounds = 1});
    };
    const Growth strict = swapped(1), lax = swapped(1e9);
    // What swaps do not let grow in their cavities does not grow at all.
    QVERIFY(strict.largest <= 1 + 1e-9);
    QVERIFY(lax.largest > 1.5);
    QCOMPARE_GT(strict.swaps, 0);
    QCOMPARE_GT(lax.swaps, strict.swaps);
}

void SwapLengthsTest::nodes_of_lines_have_a_bound_of_their_own() {
    const Mesh<3> mesh = make_layer<3>({.nx = 6,
                                        .ny = 6,
                                        .nz = 8,
                                        .aspect_ratio = 4,
                                        .growth = 1,
                                        .jitter = 0.2,
                                        .diagonals = Diagonals::random,
                                        .seed = 3});
    const auto swapped = [&](double stiffening, double line_stiffening) {
        Workbench<3> bench(mesh);
        const Lines lines = lines_of(bench);
        thin_out(bench, 400, 3);
        return swap_and_compare(
            bench, lines,
            {.stiffening = stiffening, .line_stiffening = line_stiffening, .rounds = 1});
    };
    const Growth strict = swapped(1e9, 1), lax = swapped(1, 1e9);
    QVERIFY(strict.largest_on_lines <= 1 + 1e-9);
    QCOMPARE_GT(strict.swaps, 0);
    QVERIFY(lax.largest_on_lines > 1.2);
}

void SwapLengthsTest::excess_falls_in_displaced_boxes_and_all_else_holds_data() {
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 4; ++seed) {
        QTest::addRow("seed %u", seed) << seed;
    }
}

void SwapLengthsTest::excess_falls_in_displaced_boxes_and_all_else_holds() {
    QFETCH(unsigned, seed);
    bring_displaced_cubes_into_band<2>(14, seed);
    bring_displaced_cubes_into_band<3>(6, seed);
}

void SwapLengthsTest::no_elements_off_the_lines_of_a_layer_appear() {
    for (const double ratio : {1e2, 1e6}) {
        keep_lines<2>(ratio, 1);
        keep_lines<3>(ratio, 1);
    }
}

void SwapLengthsTest::the_boundary_and_required_elements_stay() {
    Mesh<3> mesh = displaced_cube<3>(5, 7);
    mesh.features.required_elements = {11, 50, 200};
    const auto required = [](const Mesh<3>& m) {
        std::set<std::vector<std::array<double, 3>>> found;
        for (const int e : m.features.required_elements) {
            found.insert(place_of<3>(m, m.elements[ElementId(e)]));
        }
        return found;
    };
    const auto boundary = [](const Mesh<3>& m) {
        std::vector<int> all(m.faces.size());
        std::iota(all.begin(), all.end(), 0);
        return places(m, all);
    };
    Workbench<3> bench(mesh, isotropic<3>(mesh.points.size(), 0.2));
    QCOMPARE_GT(swap_and_verify(bench, no_lines(mesh.points.size())), 5);
    const Mesh<3> after = bench.edit.compact().mesh;
    QVERIFY(required(after) == required(mesh));
    QVERIFY(boundary(after) == boundary(mesh));
}

void SwapLengthsTest::no_rounds_change_nothing() {
    Workbench<2> bench(kite(0.8), isotropic<2>(4, 1));
    QCOMPARE(swap_and_verify(bench, no_lines(4), {.rounds = 0}), 0);
}

QTEST_GUILESS_MAIN(SwapLengthsTest)
#include "swap_lengths_test.moc"
