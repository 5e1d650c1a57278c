// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/adjacency.h"

#include "core/base/parallel.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <set>
#include <tuple>

using namespace ameco;

namespace {

template <int D>
void compare_with_brute_force(const Mesh<D>& mesh) {
    std::vector<std::vector<ElementId>> elements(mesh.points.size());
    std::vector<std::set<NodeId>> neighbours(mesh.points.size());
    std::set<Edge> edges;
    for (const ElementId e : mesh.elements.ids()) {
        for (const NodeId v : mesh[e]) {
            elements[v.index()].push_back(e);
            for (const NodeId w : mesh[e]) {
                if (v != w) {
                    neighbours[v.index()].insert(w);
                    edges.insert(sorted(Edge{v, w}));
                }
            }
        }
    }
    const NodeElements ball = node_elements(mesh);
    const NodeNodes stencil = node_neighbours(mesh, ball);
    QCOMPARE(ball.rows(), mesh.points.size());
    QCOMPARE(stencil.rows(), mesh.points.size());
    for (const NodeId v : mesh.points.ids()) {
        QVERIFY(std::equal(ball[v].begin(), ball[v].end(), elements[v.index()].begin(),
                           elements[v.index()].end()));
        QVERIFY(std::equal(stencil[v].begin(), stencil[v].end(), neighbours[v.index()].begin(),
                           neighbours[v.index()].end()));
    }
    const std::vector<Edge> found = edges_of(node_neighbours(mesh));
    QVERIFY(std::equal(found.begin(), found.end(), edges.begin(), edges.end()));
}

} // namespace

class AdjacencyTest : public QObject {
    Q_OBJECT
private slots:
    void files_items_in_ascending_order();
    void agrees_with_brute_force();
    void gives_unused_nodes_empty_lists();
    void does_not_depend_on_the_number_of_threads();
};

void AdjacencyTest::files_items_in_ascending_order() {
    // Items 0 ... 5 under their number modulo 3 and, for even ones, also under row 3.
    const auto lists = file_under<NodeId, ElementId>(5, 6, [](ElementId e) {
        std::vector<NodeId> rows{NodeId(e.value() % 3)};
        if (e.value() % 2 == 0) {
            rows.emplace_back(3);
        }
        return rows;
    });
    const auto row = [&](int r) {
        std::vector<int> values;
        for (const ElementId e : lists[NodeId(r)]) {
            values.push_back(e.value());
        }
        return values;
    };
    QCOMPARE(row(0), (std::vector<int>{0, 3}));
    QCOMPARE(row(1), (std::vector<int>{1, 4}));
    QCOMPARE(row(2), (std::vector<int>{2, 5}));
    QCOMPARE(row(3), (std::vector<int>{0, 2, 4}));
    QCOMPARE(row(4), std::vector<int>{});
    QCOMPARE(lists.rows(), std::size_t{5});
}

void AdjacencyTest::agrees_with_brute_force() {
    compare_with_brute_force(shapes::single_triangle());
    compare_with_brute_force(shapes::two_tets());
    compare_with_brute_force(shapes::shuffled(shapes::square(8), 1));
    compare_with_brute_force(shapes::shuffled(shapes::cube(5), 2));
}

void AdjacencyTest::gives_unused_nodes_empty_lists() {
    Mesh<3> mesh = shapes::single_tet();
    mesh.points.push_back({1, 1, 1});
    QVERIFY(node_elements(mesh)[NodeId(4)].empty());
    QVERIFY(node_neighbours(mesh)[NodeId(4)].empty());
    QCOMPARE(node_elements(Mesh<2>()).rows(), std::size_t{0});
    QVERIFY(edges_of(node_neighbours(Mesh<2>())).empty());
}

void AdjacencyTest::does_not_depend_on_the_number_of_threads() {
    const Mesh<2> mesh = shapes::shuffled(shapes::square(320), 3);
    QVERIFY(mesh.elements.size() >= 3 * 65536); // as many blocks of elements, many pieces of nodes
    const auto lists = [&](int threads) {
        set_thread_count(threads);
        NodeElements ball = node_elements(mesh);
        NodeNodes neighbours = node_neighbours(mesh, ball);
        set_thread_count(0);
        return std::tuple(std::move(ball.start), std::move(ball.values),
                          std::move(neighbours.start), std::move(neighbours.values));
    };
    const auto one = lists(1);
    QVERIFY(one == lists(2));
    QVERIFY(one == lists(3));
}

QTEST_APPLESS_MAIN(AdjacencyTest)
#include "adjacency_test.moc"
