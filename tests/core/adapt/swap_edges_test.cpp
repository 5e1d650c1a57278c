// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/swap_edges.h"

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
