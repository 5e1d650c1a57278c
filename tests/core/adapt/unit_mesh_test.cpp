// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/unit_mesh.h"

#include "tests/core/adapt/adapt_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

class UnitMeshTest : public QObject {
    Q_OBJECT
private slots:
    void lengths_are_those_of_the_metric() {
        const LayerMetric<3> source(0.01, 0.2, 0.3);
        const Bench<3> bench(3, source);
        for (const Edge& e : edges_of(node_neighbours(bench.mesh))) {
            const Vec<3>& a = bench.mesh.points[e[0]];
            const Vec<3>& b = bench.mesh.points[e[1]];
            NodeId near;
            const double expected = edge_length(length(source.at(a, near), Vec<3>(b - a)),
                                                length(source.at(b, near), Vec<3>(b - a)));
            QVERIFY(std::abs(bench.unit.length(e[0], e[1]) / expected - 1) < 1e-12);
        }
    }

    void the_way_to_the_unit_space_and_back_is_the_identity() {
        const Bench<3> bench(2, LayerMetric<3>(1e-6, 0.2, 0.5));
        const Vec<3> e(0.3, -0.2, 1e-5);
        for (const NodeId v : bench.mesh.points.ids()) {
            const Vec<3> back = bench.unit.from_unit(v, bench.unit.to_unit(v, e));
            QVERIFY((back - e).norm() < 1e-12);
            QVERIFY(std::abs(bench.unit.to_unit(v, e).norm() - bench.unit.length_at(v, e)) <
                    1e-9 * bench.unit.length_at(v, e));
        }
    }

    void a_node_that_is_dropped_leaves_nothing() {
        Bench<2> bench(2, UniformMetric<2>(0.3));
        const std::size_t before = bench.unit.edit.node_count();
        const NodeId v = bench.unit.add_node({0.4, 0.4}, NodeId(0), NodeClass::interior, false);
        QCOMPARE(bench.unit.short_size(v), 0.3);
        bench.unit.drop_last_node();
        QCOMPARE(bench.unit.edit.node_count(), before);
        QVERIFY2(bench.complaint().empty(), bench.complaint().c_str());
    }

    void a_move_can_be_taken_back() {
        Bench<3> bench(3, LayerMetric<3>(0.05, 0.3, 0.4));
        const NodeId v(21);
        const auto old = bench.unit.state(v);
        bench.unit.move_node(v, old.point + Vec<3>(0.01, 0.02, 0.03));
        QVERIFY(bench.unit.short_size(v) != old.short_size);
        bench.unit.restore(v, old);
        QCOMPARE(bench.unit.short_size(v), old.short_size);
        QVERIFY2(bench.complaint().empty(), bench.complaint().c_str());
    }

    void changes_are_known_since_a_time() {
        Bench<2> bench(2, UniformMetric<2>(0.3));
        const int now = bench.unit.tick();
        QVERIFY(bench.unit.changed_since(NodeId(1), 0));
        QVERIFY(!bench.unit.changed_since(NodeId(1), now));
        bench.unit.touch(NodeId(1));
        QVERIFY(bench.unit.changed_since(NodeId(1), now));
        QVERIFY(!bench.unit.changed_since(NodeId(2), now));
    }
};

QTEST_APPLESS_MAIN(UnitMeshTest)
#include "unit_mesh_test.moc"
