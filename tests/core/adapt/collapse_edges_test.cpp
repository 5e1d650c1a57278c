// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/collapse_edges.h"

#include "core/adapt/edge_queue.h"
#include "tests/core/adapt/adapt_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

class CollapseEdgesTest : public QObject {
    Q_OBJECT

    template <int D>
    void coarsens(int n, double h) {
        for (int seed = 1; seed <= 20; ++seed) {
            Bench<D> bench(n, UniformMetric<D>(h), seed);
            const std::string wrong = complaint_of_run(bench, -1, [](auto& unit, auto& verdicts) {
                return collapse_short_edges(unit, {}, plane_sides, 0, verdicts);
            });
            QVERIFY2(wrong.empty(), wrong.c_str());
        }
    }

private slots:
    void short_edges_go_and_the_mesh_stays_valid() {
        coarsens<2>(8, 0.25);
        coarsens<3>(5, 0.4);
    }

    void no_edge_becomes_longer_than_allowed() {
        Bench<3> bench(5, UniformMetric<3>(0.4), 3);
        VerdictCounts verdicts;
        (void)collapse_short_edges(bench.unit, {.longest = 1.3}, plane_sides, 0, verdicts);
        const auto edges = edges_by_length(bench.unit, 0, all_lengths);
        QVERIFY(edges.back().length <= 1.3);
        QVERIFY(verdicts[Verdict::long_edge] > 0);
    }

    void by_excess_the_sum_over_the_mesh_falls_with_each() {
        for (int seed = 1; seed <= 20; ++seed) {
            Bench<3> bench(5, LayerMetric<3>(0.2, 0.3, 0.4), seed);
            const std::string wrong =
                complaint_of_excess(bench, -1, [](auto& unit, auto& verdicts) {
                    return collapse_short_edges(unit, {.by_excess = true}, plane_sides, 0,
                                                verdicts);
                });
            QVERIFY2(wrong.empty(), wrong.c_str());
        }
    }

    void good_elements_are_not_made_bad() {
        Bench<3> bench(5, UniformMetric<3>(0.4), 5);
        const double before = bench.worst();
        VerdictCounts verdicts;
        (void)collapse_short_edges(bench.unit, {.quality_floor = 0.15}, plane_sides, 0, verdicts);
        QVERIFY(bench.worst() >= std::min(before, 0.15));
    }

    void corners_stay() {
        Bench<3> bench(2, UniformMetric<3>(10), 1);
        VerdictCounts verdicts;
        (void)collapse_short_edges(bench.unit, {}, plane_sides, 0, verdicts);
        const Mesh<3> now = bench.unit.edit.compact().mesh;
        QVERIFY(check(now).valid());
        QVERIFY(now.points.size() >= 8);
        QVERIFY2(bench.complaint().empty(), bench.complaint().c_str());
    }
};

QTEST_APPLESS_MAIN(CollapseEdgesTest)
#include "collapse_edges_test.moc"
