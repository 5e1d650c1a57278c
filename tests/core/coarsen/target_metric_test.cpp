// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/target_metric.h"

#include "core/mesh/adjacency.h"
#include "core/metric/edge_length.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace ameco;

Q_DECLARE_METATYPE(Vec<3>)

namespace {

constexpr TargetOptions paper{.factor = 2, .slack = 1, .isotropic_below = 1};

/// Nodes 0 to 3 in the triangles 0 1 2 and 1 3 2.
Mesh<2> two_triangles() {
    Mesh<2> mesh;
    for (const Vec<2>& x : {Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(0, 1), Vec<2>(1, 1)}) {
        mesh.points.push_back(x);
    }
    mesh.elements.push_back({NodeId(0), NodeId(1), NodeId(2)});
    mesh.elements.push_back({NodeId(1), NodeId(3), NodeId(2)});
    return mesh;
}

/// 3 x n unit squares cut in two.
Mesh<2> strip(int n) {
    std::vector<double> heights;
    for (int j = 0; j <= n; ++j) {
        heights.push_back(j);
    }
    return shapes::rectangle({0, 1, 2, 3}, heights);
}

} // namespace

class TargetMetricTest : public QObject {
    Q_OBJECT
private slots:
    void follows_algorithm_1_data();
    void follows_algorithm_1();
    void keeps_sizes_sorted_and_never_shrinks_them();
    void scales_with_the_sizes();
    void works_in_two_dimensions();
    void keeps_the_directions();
    void isotropic_regions_double_whatever_their_nodes_look_like();
    void the_slack_of_a_region_falls_from_the_factor_to_what_was_asked_for();
    void algorithms_have_names();
    void maca_keeps_isotropic_nodes_beside_a_layer();
    void maca_to_the_letter_needs_equal_sizes_and_a_smaller_number();
    void graded_goes_over_from_growth_to_none_by_beta();
    void graded_leaves_alone_what_grows_alike();
    void graded_keeps_the_length_of_turned_layers();
};

void TargetMetricTest::follows_algorithm_1_data() {
    QTest::addColumn<Vec<3>>("sizes");
    QTest::addColumn<double>("factor");
    QTest::addColumn<double>("slack");
    QTest::addColumn<Vec<3>>("expected");
    const auto row = [](const char* name, Vec<3> sizes, double factor, double slack,
                        Vec<3> expected) {
        QTest::newRow(name) << sizes << factor << slack << expected;
    };
    row("isotropic: all by C", {1, 1, 1}, 2, 1, {2, 2, 2});
    row("isotropic, another C", {3, 3, 3}, 1.5, 1, {4.5, 4.5, 4.5});
    row("ratio C: only the smallest", {1, 2, 2}, 2, 1, {2, 2, 2});
    row("slab: only the smallest", {1e-6, 1, 1}, 2, 1, {2e-6, 1, 1});
    row("layers of wide triangles: only the smallest", {1e-6, 1, 1.5}, 2, 1, {2e-6, 1, 1.5});
    row("needle: the two small ones", {1e-6, 1e-6, 1}, 2, 1, {2e-6, 2e-6, 1});
    row("between: up to the one before", {1, 1.5, 1.75}, 2, 1, {2, 2, 2});
    row("between, one far", {1, 1.5, 5}, 2, 1, {2, 2, 5});
    row("slack: nearly isotropic by C", {1, 1.2, 1.4}, 2, 1.42, {2, 2.4, 2.8});
    row("slack: the bound is the updated size", {1, 1.5, 2.5}, 2, 1.25, {2, 2.5, 3.125});
    row("slack does not help the smallest", {1e-6, 1e-3, 1}, 2, 1.42, {2e-6, 1e-3, 1});
    row("slack: no growth beside a size that stays", {1e-6, 1, 1}, 2, 1.42, {2e-6, 1, 1});
    row("slack: little growth beside one that grows little", {1, 1.9, 1.9}, 2, 1.05,
        {2, 2.1, 2.205});
    row("C = 1 changes nothing", {1, 2, 3}, 1, 1, {1, 2, 3});
}

void TargetMetricTest::follows_algorithm_1() {
    QFETCH(const Vec<3>, sizes);
    QFETCH(const double, factor);
    QFETCH(const double, slack);
    QFETCH(const Vec<3>, expected);
    const Vec<3> found = coarsened_sizes<3>(sizes, {.factor = factor, .slack = slack});
    for (int k = 0; k < 3; ++k) {
        QCOMPARE_LE(std::abs(found[k] / expected[k] - 1), 1e-15);
    }
}

void TargetMetricTest::keeps_sizes_sorted_and_never_shrinks_them() {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-3, 0);
    for (int n = 0; n < 1000; ++n) {
        Vec<3> h(std::pow(10, exponent(random)), std::pow(10, exponent(random)),
                 std::pow(10, exponent(random)));
        std::sort(h.begin(), h.end());
        for (const double slack : {1.0, 1.42, 3.0}) {
            const Vec<3> coarse = coarsened_sizes<3>(h, {.factor = 2, .slack = slack});
            QVERIFY(std::is_sorted(coarse.begin(), coarse.end()));
            QVERIFY((coarse.array() >= h.array()).all());
            QVERIFY((coarse.array() <= 2 * h.array()).all());
            QCOMPARE(coarse[0], 2 * h[0]);
        }
    }
}

void TargetMetricTest::scales_with_the_sizes() {
    const Vec<3> h(1, 1.3, 7);
    const Vec<3> small = coarsened_sizes<3>(Vec<3>(h * 0x1p-30), {});
    QVERIFY(small == Vec<3>(coarsened_sizes<3>(h, {}) * 0x1p-30));
}

void TargetMetricTest::works_in_two_dimensions() {
    QVERIFY((coarsened_sizes<2>({1, 1}, paper) == Vec<2>(2, 2)));
    QVERIFY((coarsened_sizes<2>({1, 1.5}, paper) == Vec<2>(2, 2)));
    QVERIFY((coarsened_sizes<2>({1e-6, 1}, paper) == Vec<2>(2e-6, 1)));
    QVERIFY((coarsened_sizes<2>({1, 1.5}, {.factor = 2, .slack = 1.42}) == Vec<2>(2, 2.84)));
}

void TargetMetricTest::keeps_the_directions() {
    MetricField<3> natural(4);
    natural[NodeId(1)].sizes = Vec<3>(1e-4, 1, 1);
    natural[NodeId(1)].directions << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    const MetricField<3> target = target_metric<3>(shapes::single_tet(), natural, paper);
    QCOMPARE(target.size(), natural.size());
    for (const NodeId i : natural.ids()) {
        QVERIFY(target[i].directions == natural[i].directions);
        QVERIFY((target[i].sizes == coarsened_sizes<3>(natural[i].sizes, paper)));
    }
}

void TargetMetricTest::isotropic_regions_double_whatever_their_nodes_look_like() {
    // Sizes 1 and 1.5, the long one across that of the neighbours: a round region.
    const Mesh<2> mesh = strip(12);
    MetricField<2> natural(mesh.points.size());
    for (const NodeId i : natural.ids()) {
        natural[i].sizes = Vec<2>(1, 1.5);
        if (i.index() % 2 == 1) {
            natural[i].directions << 0, -1, 1, 0;
        }
    }
    const NodeId inside(static_cast<std::size_t>(4 * 6 + 1));
    const MetricField<2> target = target_metric<2>(mesh, natural, {});
    QCOMPARE_GE(target[inside].sizes[1], 2.9);
    const MetricField<2> by_the_paper = target_metric<2>(mesh, natural, paper);
    QVERIFY(by_the_paper[inside].sizes == Vec<2>(2, 2));
    // All the same way round it is stretched on purpose.
    for (const NodeId i : natural.ids()) {
        natural[i].directions.setIdentity();
    }
    const MetricField<2> stretched =
        target_metric<2>(mesh, natural, {.factor = 2, .slack = 1, .isotropic_below = 1.4});
    QVERIFY(stretched[inside].sizes == Vec<2>(2, 2));
}

void TargetMetricTest::the_slack_of_a_region_falls_from_the_factor_to_what_was_asked_for() {
    const TargetOptions options{.factor = 2, .slack = 1.1, .isotropic_below = 1.6};
    QCOMPARE(slack_in_region(1, options), 2.0);
    QCOMPARE(slack_in_region(std::sqrt(1.6), options), std::sqrt(2.0)); // half the way: half of w
    QCOMPARE(slack_in_region(1.6, options), 1.1);
    QCOMPARE(slack_in_region(1e6, options), 1.1);
    QCOMPARE(slack_in_region(1, paper), 1.0);
    double before = 2;
    for (double r = 1; r < 2; r += 0.01) {
        const double slack = slack_in_region(r, options);
        QVERIFY(slack <= before);
        before = slack;
    }
}

void TargetMetricTest::algorithms_have_names() {
    for (const TargetAlgorithm algorithm : all_target_algorithms) {
        QVERIFY(target_algorithm_from_name(name(algorithm)) == algorithm);
    }
    QVERIFY(!target_algorithm_from_name("quick"));
}

void TargetMetricTest::maca_keeps_isotropic_nodes_beside_a_layer() {
    // Two triangles: 0 and 3 are not neighbours. Node 3 is in a layer, the others are isotropic,
    // 0 a little coarser than 1 and 2.
    MetricField<2> natural(4);
    natural[NodeId(0)].sizes = Vec<2>(1.01, 1.01);
    natural[NodeId(3)].sizes = Vec<2>(0.25, 1);
    TargetOptions options = paper;
    options.algorithm = TargetAlgorithm::maca;
    const MetricField<2> target = target_metric<2>(two_triangles(), natural, options);
    QVERIFY(target[NodeId(0)].sizes == Vec<2>(2.02, 2.02)); // its finer neighbours coarsen, too
    QVERIFY(target[NodeId(1)].sizes == Vec<2>(1, 1));
    QVERIFY(target[NodeId(2)].sizes == Vec<2>(1, 1));
    QVERIFY(target[NodeId(3)].sizes == Vec<2>(0.5, 1));
}

void TargetMetricTest::maca_to_the_letter_needs_equal_sizes_and_a_smaller_number() {
    MetricField<2> natural(4);
    natural[NodeId(0)].sizes = Vec<2>(0.25, 1);
    natural[NodeId(2)].sizes = Vec<2>(1, 1 + 1e-15);
    natural[NodeId(3)].sizes = Vec<2>(1.01, 1.01);
    TargetOptions options = paper;
    options.algorithm = TargetAlgorithm::maca_literal;
    const MetricField<2> target = target_metric<2>(two_triangles(), natural, options);
    QVERIFY(target[NodeId(0)].sizes == Vec<2>(0.5, 1));
    QVERIFY(target[NodeId(1)].sizes == Vec<2>(1, 1));       // finer neighbour 0
    QVERIFY(target[NodeId(2)].sizes == Vec<2>(2, 2));       // rounding: not equal
    QVERIFY(target[NodeId(3)].sizes == Vec<2>(1.01, 1.01)); // 1 is marginally finer
}

void TargetMetricTest::graded_goes_over_from_growth_to_none_by_beta() {
    // Figures 4 and 5: cells of 1 x 1 over a layer of 1 x 1/4.
    const Mesh<2> mesh = shapes::rectangle(
        {0, 1, 2, 3}, {0, 0.25, 0.5, 0.75, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13});
    const auto in_layer = [&](NodeId i) { return mesh.points[i][1] < 0.9; };
    MetricField<2> natural(mesh.points.size());
    for (const NodeId i : natural.ids()) {
        natural[i].directions << 0, -1, 1, 0; // h_1 upwards
        natural[i].sizes = in_layer(i) ? Vec<2>(0.25, 1) : Vec<2>(1, 1);
    }
    TargetOptions options = paper;
    const auto width = [&](const MetricField<2>& field, NodeId i) {
        return 1 / length<2>(field[i], Vec<2>(1, 0));
    };
    const auto steepest = [&](const MetricField<2>& field) {
        double worst = 1;
        const NodeNodes neighbours = node_neighbours(mesh);
        for (const NodeId i : field.ids()) {
            for (const NodeId j : neighbours[i]) {
                const Vec<2> e = mesh.points[i] - mesh.points[j];
                const double l = edge_length(length<2>(natural[i], e), length<2>(natural[j], e));
                worst = std::max(worst, std::pow(width(field, i) / width(field, j), 1 / l));
            }
        }
        return worst;
    };
    QCOMPARE_GT(steepest(target_metric<2>(mesh, natural, options)), 1.99);
    options.algorithm = TargetAlgorithm::graded;
    for (const double beta : {1.1, 1.3, 1.6}) {
        options.gradation = beta;
        const MetricField<2> target = target_metric<2>(mesh, natural, options);
        QCOMPARE_LE(steepest(target), beta * (1 + 1e-5));
        for (const NodeId i : target.ids()) {
            QVERIFY(std::is_sorted(target[i].sizes.begin(), target[i].sizes.end()));
            const double height = 1 / length<2>(target[i], Vec<2>(0, 1));
            QCOMPARE(height, in_layer(i) ? 0.5 : 2.0); // upwards all of it grows
            QCOMPARE_GE(width(target, i), 1.0);
            QVERIFY(mesh.points[i][1] < 9.5 || width(target, i) == 2.0);
        }
    }
}

void TargetMetricTest::graded_leaves_alone_what_grows_alike() {
    // Heights that grow by 3 from layer to layer: steeper than beta, but the mesh is so.
    const Mesh<2> mesh = strip(6);
    MetricField<2> natural(mesh.points.size());
    for (const NodeId i : natural.ids()) {
        natural[i].directions << 0, -1, 1, 0;
        natural[i].sizes = Vec<2>(1e-6 * std::pow(3, mesh.points[i][1]), 1);
    }
    TargetOptions options = paper;
    const MetricField<2> basic = target_metric<2>(mesh, natural, options);
    options.algorithm = TargetAlgorithm::graded;
    options.gradation = 1.2;
    QVERIFY((target_metric<2>(mesh, natural, options).raw() == basic.raw()));
}

void TargetMetricTest::graded_keeps_the_length_of_turned_layers() {
    // Directions that turn by 0.3 from column to column, at aspect ratio 1e5.
    const Mesh<2> mesh = strip(4);
    MetricField<2> natural(mesh.points.size());
    for (const NodeId i : natural.ids()) {
        const double a = 0.3 * mesh.points[i][0];
        natural[i].directions << -std::sin(a), -std::cos(a), std::cos(a), -std::sin(a);
        natural[i].sizes = Vec<2>(1e-5, 1);
    }
    TargetOptions options = paper;
    options.algorithm = TargetAlgorithm::graded;
    options.gradation = 1.2;
    for (const Metric<2>& metric : target_metric<2>(mesh, natural, options)) {
        QVERIFY(metric.sizes == Vec<2>(2e-5, 1));
    }
}

QTEST_APPLESS_MAIN(TargetMetricTest)
#include "target_metric_test.moc"
