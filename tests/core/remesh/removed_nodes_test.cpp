// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/removed_nodes.h"

#include "core/cases/cube.h"
#include "core/coarsen/coarsen.h"
#include "core/multigrid/invariants.h"
#include "core/remesh/collapse.h"
#include "tests/core/multigrid/grids.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

/// A node in the middle of a plate of 8 x 16 cells, aspect ratio 100, with its neighbours.
struct Middle {
    Middle() {
        node = NodeId(mesh.points.size() / 2);
        while (bench.edit.on_boundary(node)) {
            node = NodeId(node.index() + 1);
        }
        gather_ball(bench.edit, node, ball);
        for (const NodeId w : couplings.neighbours[node]) {
            if (make_star(bench.edit, ball, w, star) != Verdict::accepted) {
                continue;
            }
            const float c = couplings.between(node, w);
            strong = !strong.valid() || c > couplings.between(node, strong) ? w : strong;
            weak = !weak.valid() || c < couplings.between(node, weak) ? w : weak;
        }
    }

    /// Whether the node stays well interpolated when it leaves onto w.
    bool may_leave(NodeId w, float bound) {
        RemovedNodes<2> removed(couplings, IdVector<NodeId, float>(mesh.points.size(), bound));
        return make_star(bench.edit, ball, w, star) == Verdict::accepted &&
               removed.interpolated_well(bench.edit, ball, star, {node});
    }

    const Mesh<2> mesh = grids::layer<2>(
        {{"nx", "8"}, {"ny", "16"}, {"aspect-ratio", "100"}, {"growth", "1"}, {"displace", "0"}});
    const Couplings couplings = make_couplings(mesh);
    Workbench<2> bench{mesh};
    NodeId node;
    Cavity<2> ball;
    Star<2> star;
    NodeId strong, weak; ///< neighbours the node can leave onto
};

} // namespace

class RemovedNodesTest : public QObject {
    Q_OBJECT
private slots:
    void the_middle_of_a_line_has_constant_one();
    void a_node_leaves_along_a_strong_edge_and_not_along_a_weak_one();
    void a_node_does_not_leave_along_a_needle();
    void every_removed_node_stays_well_interpolated_data();
    void every_removed_node_stays_well_interpolated();
    void the_bound_grows_with_the_directions_that_are_coarsened();
    void the_bound_is_lower_where_one_neighbour_holds_a_node();
};

void RemovedNodesTest::the_middle_of_a_line_has_constant_one() {
    const Middle m;
    const auto values = m.couplings.at(m.node);
    std::vector<NodeId> ends;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] > 0.4f * m.couplings.diagonal[m.node]) {
            ends.push_back(m.couplings.neighbours[m.node][i]);
        }
    }
    QCOMPARE(ends.size(), std::size_t{2});
    const std::array half{0.5, 0.5};
    const double K = interpolation_constant(m.couplings, m.node, ends, half);
    QVERIFY2(std::abs(K - 1) < 0.01, qPrintable(QString::number(K)));
    // From a node it is not coupled with at all: the constant of the longest ways.
    const std::array far{NodeId(0)};
    const std::array one{1.0};
    QCOMPARE(interpolation_constant(m.couplings, m.node, far, one), 50.0);
}

void RemovedNodesTest::a_node_leaves_along_a_strong_edge_and_not_along_a_weak_one() {
    Middle m;
    QVERIFY(m.strong.valid() && m.strong != m.weak);
    QVERIFY(m.may_leave(m.strong, 5));
    QVERIFY(!m.may_leave(m.weak, 5));
    QVERIFY(m.may_leave(m.weak, 1e6f));
}

void RemovedNodesTest::a_node_does_not_leave_along_a_needle() {
    const Mesh<3> rod = make_rod(7);
    const Couplings couplings = make_couplings(rod);
    Workbench<3> bench{rod};
    const NodeId middle(3 * (rod_corners + 1)), above(4 * (rod_corners + 1));
    Cavity<3> ball;
    Star<3> star;
    gather_ball(bench.edit, middle, ball);
    QVERIFY(make_star(bench.edit, ball, above, star) == Verdict::accepted);
    const IdVector<NodeId, float> bounds(rod.points.size(), 5);
    RemovedNodes<3> by_couplings(couplings, bounds);
    QVERIFY(by_couplings.interpolated_well(bench.edit, ball, star, {middle}));
    RemovedNodes<3> by_sizes(couplings, bounds, bench.short_size);
    QVERIFY(!by_sizes.interpolated_well(bench.edit, ball, star, {middle}));
}

void RemovedNodesTest::every_removed_node_stays_well_interpolated_data() {
    QTest::addColumn<QByteArray>("aspect_ratio");
    QTest::newRow("layers") << QByteArray("1e4");
    QTest::newRow("layers that become isotropic") << QByteArray("20");
}

void RemovedNodesTest::every_removed_node_stays_well_interpolated() {
    QFETCH(QByteArray, aspect_ratio);
    const CoarsenOptions options;
    const Level<3> fine = finest_level(grids::layer<3>({{"nx", "8"},
                                                        {"ny", "8"},
                                                        {"nz", "16"},
                                                        {"aspect-ratio", aspect_ratio.constData()},
                                                        {"growth", "1.2"},
                                                        {"displace", "0.2"}}),
                                       options);
    CoarsenReport report;
    const Level<3> coarse = coarsen(fine, options, report);
    const Transfer transfer = make_transfer(fine.mesh, coarse.mesh, coarse.parent);
    const LevelStructure structure = level_structure(fine.mesh);
    const auto bounds = interpolation_bounds<3>(
        structure.couplings,
        coarsened_directions(fine.natural, target_metric(fine.mesh, fine.natural, options.target)),
        options.removal.interpolation);
    int looked_at = 0;
    for (const NodeId v : fine.mesh.points.ids()) {
        if (transfer.kind[v] == TransferKind::nested ||
            fine.geometry.node[v] != NodeClass::interior) {
            continue;
        }
        ++looked_at;
        // On a side between elements both are right; their weights differ by roundings.
        const double K = interpolation_constant(structure.couplings, transfer, v);
        QVERIFY2(K <= 1.001 * static_cast<double>(bounds[v]),
                 qPrintable(QString("node %1: %2").arg(v.value()).arg(K)));
    }
    QVERIFY(looked_at > 100);
}

void RemovedNodesTest::the_bound_grows_with_the_directions_that_are_coarsened() {
    const Couplings couplings = make_couplings(make_cube<3>({.n = 2}));
    const NodeId middle(13);
    MetricField<3> natural(27), target(27);
    natural[middle].sizes = {1, 1, 1};
    const auto bound = [&](double a, double b, double c) {
        target[middle].sizes = {a, b, c};
        return interpolation_bounds<3>(couplings, coarsened_directions(natural, target),
                                       {5, 6, 20})[middle];
    };
    QCOMPARE(bound(1, 1, 1), 5.0f);
    QCOMPARE(bound(2, 1, 1), 5.0f);
    QCOMPARE(bound(2, 2, 1), 16.0f);
    QCOMPARE(bound(2, 2, 2), 37.0f);
}

void RemovedNodesTest::the_bound_is_lower_where_one_neighbour_holds_a_node() {
    const auto bound_in_the_middle = [](double aspect_ratio) {
        const Mesh<3> mesh = grids::layer<3>({{"nx", "2"},
                                              {"ny", "2"},
                                              {"nz", "2"},
                                              {"aspect-ratio", std::to_string(aspect_ratio)}});
        const IdVector<NodeId, float> directions(mesh.points.size(), 1.0f);
        return interpolation_bounds<3>(make_couplings(mesh), directions,
                                       {.layer = 2, .held = 0.5})[NodeId(13)];
    };
    QCOMPARE(bound_in_the_middle(1), 2.0f);
    QCOMPARE(bound_in_the_middle(100), 1.5f);
}

QTEST_APPLESS_MAIN(RemovedNodesTest)
#include "removed_nodes_test.moc"
