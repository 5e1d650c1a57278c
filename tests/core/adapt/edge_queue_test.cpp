// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/edge_queue.h"

#include "tests/core/adapt/adapt_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

class EdgeQueueTest : public QObject {
    Q_OBJECT
private slots:
    void every_edge_is_there_once_the_shortest_first() {
        const Bench<3> bench(3, UniformMetric<3>(0.3), 1);
        const auto queue = edges_by_length(bench.unit, 0, all_lengths);
        std::set<Edge> seen;
        for (std::size_t i = 0; i < queue.size(); ++i) {
            QVERIFY(seen.insert(queue[i].nodes).second);
            QVERIFY(i == 0 || queue[i - 1].length <= queue[i].length);
        }
        const auto edges = edges_of(node_neighbours(bench.mesh));
        QCOMPARE(seen, std::set<Edge>(edges.begin(), edges.end()));
    }

    void only_edges_beside_a_change_are_wanted_again() {
        Bench<2> bench(4, UniformMetric<2>(0.3), 1);
        const int now = bench.unit.tick();
        bench.unit.touch(NodeId(7));
        const auto queue = edges_by_length(bench.unit, now, all_lengths);
        QCOMPARE(queue.size(), remesh_test::neighbours(bench.unit.edit, NodeId(7)).size());
        for (const LongEdge& e : queue) {
            QVERIFY(e.nodes[0] == NodeId(7) || e.nodes[1] == NodeId(7));
        }
    }
};

QTEST_APPLESS_MAIN(EdgeQueueTest)
#include "edge_queue_test.moc"
