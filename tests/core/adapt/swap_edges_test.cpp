// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/swap_edges.h"

#include "core/adapt/move_nodes.h"
#include "tests/core/adapt/adapt_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

class SwapEdgesTest : public QObject {
    Q_OBJECT

    template <int D>
    void improves(int n, const Metric<D>& metric) {
        for (int seed = 1; seed <= 10; ++seed) {
            Bench<D> bench(n, UniformMetric<D>(metric), seed);
            VerdictCounts verdicts;
            const double before = bench.worst();
            const std::size_t nodes = bench.nodes();
            const SwapOptions options{.below = 0.9, .gain = 1.01, .rounds = 3};
            const std::int64_t made =
                swap_to_quality(bench.unit, options, plane_sides, 0, verdicts);
            QVERIFY(made > 0);
            QCOMPARE(bench.nodes(), nodes);
            QVERIFY(bench.worst() >= before);
            QVERIFY2(bench.complaint().empty(), bench.complaint().c_str());
        }
    }

private slots:
    void the_worst_quality_grows_and_the_mesh_stays_valid() {
        // Stretched across the diagonal of the cells: their diagonals are the wrong ones.
        Metric<2> flat;
        flat.sizes << 0.1, 0.4;
        flat.directions << 1, 1, -1, 1;
        flat.directions /= std::sqrt(2.0);
        improves<2>(5, flat);
        Metric<3> solid;
        solid.sizes << 0.1, 0.3, 0.3;
        solid.directions << 1, 1, 0, -1, 1, 0, 0, 0, std::sqrt(2.0);
        solid.directions /= std::sqrt(2.0);
        improves<3>(4, solid);
    }

    void elements_that_are_not_tried_again_have_no_swap() {
        for (int seed = 1; seed <= 10; ++seed) {
            Bench<3> bench(4, LayerMetric<3>(0.05, 0.4, 0.3), seed);
            const SwapOptions options{.below = 0.95, .gain = 1.01, .rounds = 1};
            VerdictCounts verdicts;
            std::int64_t tried = 0;
            std::int64_t made = 0;
            do { // moves between the swaps make them worth trying again, here and there
                for (std::size_t i = 0; i < 3; ++i) {
                    const auto v = NodeId((17 * static_cast<std::size_t>(tried) + 29 * i) %
                                          bench.mesh.points.size());
                    if (!bench.unit.edit.is_removed(v) && made > 3) {
                        (void)move_node(bench.unit, v, {.below = 1, .gain = 1.0001});
                    }
                }
                const std::int64_t before = verdicts[Verdict::no_improvement];
                made = swap_to_quality(bench.unit, options, plane_sides, 0, verdicts);
                tried += verdicts[Verdict::no_improvement] - before;
            } while (made > 0);
            verdicts = {};
            (void)swap_to_quality(bench.unit, options, plane_sides, 0, verdicts);
            QVERIFY(verdicts.counts == VerdictCounts{}.counts); // nothing is tried
            Fresh<3> fresh(bench.unit, *bench.source);
            QCOMPARE(swap_to_quality(fresh.unit, options, plane_sides, 0, verdicts),
                     std::int64_t{0});
            QVERIFY(verdicts[Verdict::no_improvement] > 0);
        }
    }

    void nothing_is_done_where_nothing_has_changed() {
        Bench<3> bench(4, UniformMetric<3>(0.2), 1);
        VerdictCounts verdicts;
        const int later = bench.unit.tick();
        QCOMPARE(swap_to_quality(bench.unit, {.below = 0.9}, plane_sides, later, verdicts),
                 std::int64_t{0});
    }
};

QTEST_APPLESS_MAIN(SwapEdgesTest)
#include "swap_edges_test.moc"
