// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/move_nodes.h"

#include "tests/core/adapt/adapt_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

namespace {

template <int D>
double inverse_sum(const UnitMesh<D>& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.edit.slot_count(); ++i) {
        const ElementId e(i);
        if (!mesh.edit.is_free(e) && !mesh.edit.is_ghost(e)) {
            sum += 1 / static_cast<double>(mesh.edit.element(e).measure);
        }
    }
    return sum;
}

} // namespace

class MoveNodesTest : public QObject {
    Q_OBJECT

    template <int D>
    void improves(int n) {
        for (int seed = 1; seed <= 20; ++seed) {
            Bench<D> bench(n, UniformMetric<D>(1.0 / n), seed);
            VerdictCounts verdicts;
            const double before = inverse_sum(bench.unit);
            const std::int64_t made = move_nodes(bench.unit, {}, 0, verdicts);
            QVERIFY(made > 0);
            QCOMPARE(verdicts[Verdict::accepted], made);
            QVERIFY(inverse_sum(bench.unit) < before);
            QVERIFY2(bench.complaint().empty(), bench.complaint().c_str());
        }
    }

private slots:
    void the_harmonic_mean_grows_and_the_mesh_stays_valid() {
        improves<2>(6);
        improves<3>(4);
    }

    void planes_and_lines_are_kept_to_the_bit() {
        Bench<3> bench(4, UniformMetric<3>(0.25), 7);
        VerdictCounts verdicts;
        (void)move_nodes(bench.unit, {}, 0, verdicts);
        std::size_t moved_on_boundary = 0;
        for (const NodeId v : bench.mesh.points.ids()) {
            const Vec<3>& old = bench.mesh.points[v];
            const Vec<3>& now = bench.unit.edit.point(v);
            for (int k = 0; k < 3; ++k) {
                if (old[k] == 0 || old[k] == 1) {
                    QCOMPARE(now[k], old[k]);
                    moved_on_boundary += now == old ? 0 : 1;
                }
            }
        }
        QVERIFY(moved_on_boundary > 0);
    }

    void the_metric_is_that_of_the_new_place() {
        const LayerMetric<3> source(0.05, 0.5, 0.4);
        Bench<3> bench(4, source, 2);
        VerdictCounts verdicts;
        (void)move_nodes(bench.unit, {}, 0, verdicts);
        for (const NodeId v : bench.unit.edit.nodes()) {
            NodeId near;
            QCOMPARE(bench.unit.short_size(v), source.at(bench.unit.edit.point(v), near).sizes[0]);
        }
    }
};

QTEST_APPLESS_MAIN(MoveNodesTest)
#include "move_nodes_test.moc"
