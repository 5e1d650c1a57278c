// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/target_metric.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace ameco;

Q_DECLARE_METATYPE(Vec<3>)

namespace {

constexpr TargetOptions paper{.factor = 2, .slack = 1};

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
    MetricField<3> natural(3);
    natural[NodeId(1)].sizes = Vec<3>(1e-4, 1, 1);
    natural[NodeId(1)].directions << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    const MetricField<3> target = target_metric<3>(natural, paper);
    QCOMPARE(target.size(), natural.size());
    for (const NodeId i : natural.ids()) {
        QVERIFY(target[i].directions == natural[i].directions);
        QVERIFY((target[i].sizes == coarsened_sizes<3>(natural[i].sizes, paper)));
    }
}

QTEST_APPLESS_MAIN(TargetMetricTest)
#include "target_metric_test.moc"
