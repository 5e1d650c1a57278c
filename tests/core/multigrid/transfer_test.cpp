// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/transfer.h"

#include "core/mesh/boundary_projection.h"
#include "core/mesh/locate.h"
#include "tests/core/multigrid/grids.h"

#include <QTest>

using namespace ameco;

namespace {

std::map<std::string, std::string> random_layer(int seed, const char* curvature) {
    return {{"nx", "6"},
            {"ny", "5"},
            {"nz", "12"},
            {"aspect-ratio", seed % 2 == 0 ? "1e2" : "1e6"},
            {"growth", seed % 3 == 0 ? "1" : "1.3"},
            {"seed", std::to_string(seed)},
            {"diagonals", "random"},
            {"curvature", curvature}};
}

/// Weight of a fine node at a coarse one.
double weight(const Transfer& t, NodeId fine, NodeId coarse) {
    return t.P.coeff(fine.value(), coarse.value());
}

} // namespace

class TransferTest : public QObject {
    Q_OBJECT
private slots:
    void every_operator_passes_its_checks_data();
    void every_operator_passes_its_checks();
    void kept_nodes_are_injected();
    void nodes_with_equal_coordinates_are_matched();
    void a_removed_node_of_a_column_depends_on_its_column_only();
    void boundary_nodes_depend_on_boundary_nodes_of_their_patches_only();
    void nodes_outside_the_coarse_domain_are_projected_and_flagged();
    void a_coarse_node_nobody_refers_to_is_found();
    void a_weight_out_of_place_is_found();
    void the_walk_finds_what_a_search_finds();
    void nothing_depends_on_the_numbering();
};

void TransferTest::every_operator_passes_its_checks_data() {
    QTest::addColumn<int>("seed");
    QTest::addColumn<QByteArray>("curvature");
    for (const int seed : {1, 2, 3, 4}) {
        for (const char* curvature : {"0", "2", "-2"}) {
            QTest::addRow("seed %d, curvature %s", seed, curvature)
                << seed << QByteArray(curvature);
        }
    }
}

void TransferTest::every_operator_passes_its_checks() {
    QFETCH(int, seed);
    QFETCH(QByteArray, curvature);
    const auto in_space =
        grids::coarsened(grids::layer<3>(random_layer(seed, curvature.constData())), 3);
    auto flat = random_layer(seed, curvature.constData());
    flat.erase("ny");
    const auto in_plane = grids::coarsened(grids::layer<2>(flat), 3);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto a = check(in_space.transfers[k], in_space.meshes[k], in_space.meshes[k + 1]);
        QVERIFY2(a.passed(), a.failures().c_str());
        const auto b = check(in_plane.transfers[k], in_plane.meshes[k], in_plane.meshes[k + 1]);
        QVERIFY2(b.passed(), b.failures().c_str());
        QCOMPARE(a.nested, static_cast<std::int64_t>(in_space.meshes[k + 1].points.size()));
    }
}

void TransferTest::kept_nodes_are_injected() {
    const auto g = grids::coarsened(grids::layer<3>(random_layer(1, "2")), 1);
    for (const NodeId c : g.parents[0].ids()) {
        const NodeId v = g.parents[0][c];
        QCOMPARE(weight(g.transfers[0], v, c), 1.0);
        QCOMPARE(g.transfers[0].P.row(v.value()).nonZeros(), Eigen::Index(1));
        QVERIFY(g.transfers[0].kind[v] == TransferKind::nested);
    }
}

void TransferTest::nodes_with_equal_coordinates_are_matched() {
    const auto g = grids::coarsened(grids::layer<3>(random_layer(2, "0")), 1);
    QVERIFY(match_nodes(g.meshes[0], g.meshes[1]) == g.parents[0]);
    const Transfer found = make_transfer(g.meshes[0], g.meshes[1]);
    QCOMPARE((found.P - g.transfers[0].P).norm(), 0.0);
}

void TransferTest::a_removed_node_of_a_column_depends_on_its_column_only() {
    // All of it is layers, so every removed node lies between two kept ones of its column.
    const auto g = grids::coarsened(
        grids::layer<3>(
            {{"nx", "5"}, {"ny", "5"}, {"nz", "8"}, {"aspect-ratio", "1e6"}, {"growth", "1"}}),
        1);
    const Transfer& t = g.transfers[0];
    for (const NodeId v : g.meshes[0].points.ids()) {
        for (SparseMatrix::InnerIterator it(t.P, v.value()); it; ++it) {
            const Vec<3> d = g.meshes[1].points[NodeId(static_cast<std::size_t>(it.col()))] -
                             g.meshes[0].points[v];
            QVERIFY(d.head<2>().norm() == 0);
            QVERIFY(it.value() == 1 || std::abs(it.value() - 0.5) < 1e-9);
        }
    }
}

void TransferTest::boundary_nodes_depend_on_boundary_nodes_of_their_patches_only() {
    for (const char* curvature : {"0", "1", "-1"}) {
        const auto g = grids::coarsened(grids::layer<3>(random_layer(4, curvature)), 2);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto fine = node_patches(g.meshes[k]);
            const auto coarse = node_patches(g.meshes[k + 1]);
            for (const NodeId v : g.meshes[k].points.ids()) {
                for (SparseMatrix::InnerIterator it(g.transfers[k].P, v.value()); it; ++it) {
                    const auto& own = coarse[NodeId(static_cast<std::size_t>(it.col()))];
                    QVERIFY(std::includes(own.begin(), own.end(), fine[v].begin(), fine[v].end()));
                }
            }
        }
    }
}

void TransferTest::nodes_outside_the_coarse_domain_are_projected_and_flagged() {
    // A triangle fan over a chord: the fine node on the arc has no coarse element.
    Mesh<2> fine;
    fine.points = IdVector<NodeId, Vec<2>>({{-1, 0}, {0, -0.25}, {1, 0}, {0, 1}});
    const auto n = [](int i) { return NodeId(i); };
    fine.elements = IdVector<ElementId, Simplex<2>>({{n(0), n(1), n(3)}, {n(1), n(2), n(3)}});
    fine.region.assign(2, 0);
    fine.faces =
        IdVector<FaceId, Facet<2>>({{n(0), n(1)}, {n(1), n(2)}, {n(2), n(3)}, {n(3), n(0)}});
    fine.patch = IdVector<FaceId, int>({1, 1, 2, 2});
    Mesh<2> coarse;
    coarse.points = IdVector<NodeId, Vec<2>>({{-1, 0}, {1, 0}, {0, 1}});
    coarse.elements = IdVector<ElementId, Simplex<2>>({{n(0), n(1), n(2)}});
    coarse.region.assign(1, 0);
    coarse.faces = IdVector<FaceId, Facet<2>>({{n(0), n(1)}, {n(1), n(2)}, {n(2), n(0)}});
    coarse.patch = IdVector<FaceId, int>({1, 2, 2});
    const Transfer t = make_transfer(fine, coarse);
    QVERIFY(t.kind[n(1)] == TransferKind::projected);
    QCOMPARE(t.largest_projection, 0.25);
    QCOMPARE(weight(t, n(1), n(0)), 0.5);
    QCOMPARE(weight(t, n(1), n(1)), 0.5);
    QVERIFY(check(t, fine, coarse).passed());
    QCOMPARE(check(t, fine, coarse).projected, std::int64_t(1));
}

void TransferTest::a_coarse_node_nobody_refers_to_is_found() {
    auto g = grids::coarsened(grids::layer<3>(random_layer(1, "0")), 1);
    Transfer& t = g.transfers[0];
    t.P.conservativeResize(t.P.rows(), t.P.cols() + 1);
    const auto result = check(t, g.meshes[0], g.meshes[1]);
    QCOMPARE(result.empty_columns, std::int64_t(1));
    QVERIFY(!result.passed());
}

void TransferTest::a_weight_out_of_place_is_found() {
    auto g = grids::coarsened(grids::layer<3>(random_layer(1, "0")), 1);
    Transfer& t = g.transfers[0];
    for (const NodeId v : g.meshes[0].points.ids()) {
        if (t.kind[v] == TransferKind::interpolated) {
            SparseMatrix::InnerIterator it(t.P, v.value());
            it.valueRef() += 1e-2;
            ++it;
            it.valueRef() -= 1e-2;
            break;
        }
    }
    const auto result = check(t, g.meshes[0], g.meshes[1]);
    QVERIFY(result.row_sum_error < 1e-12);
    QVERIFY(result.linear_error > 1e-10);
    QVERIFY(!result.passed());
}

void TransferTest::the_walk_finds_what_a_search_finds() {
    const Mesh<3> mesh = grids::layer<3>(random_layer(1, "0.8"));
    const Locator<3> locator(mesh);
    for (const ElementId e : mesh.elements.ids()) {
        Vec<3> p = Vec<3>::Zero();
        for (const NodeId v : mesh.elements[e]) {
            p += mesh.points[v] / 4;
        }
        if (e.value() % 7 == 0) {
            const auto found = locator.walk(p, NodeId(0));
            QVERIFY(!found || *found == e);
            QVERIFY(locator.contains(e, p));
            QVERIFY(locator.walk(p, mesh.elements[e][0]) == e);
        }
    }
}

void TransferTest::nothing_depends_on_the_numbering() {
    // The same two meshes, numbered in another way, give the same matrix up to the numbering.
    const auto g = grids::coarsened(grids::layer<3>(random_layer(2, "0")), 1);
    Mesh<3> turned = g.meshes[1];
    for (Simplex<3>& s : turned.elements) {
        std::rotate(s.begin(), s.begin() + 1, s.begin() + 3); // an even permutation
    }
    std::reverse(turned.elements.begin(), turned.elements.end());
    const Transfer t = make_transfer(g.meshes[0], turned, g.parents[0]);
    QVERIFY((t.P - g.transfers[0].P).norm() < 1e-9);
}

QTEST_APPLESS_MAIN(TransferTest)
#include "transfer_test.moc"
