// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/adjacency.h"

#include "core/base/parallel.h"
#include "core/mesh/facets.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <map>
#include <random>
#include <set>

using namespace ameco;

namespace {

/// The mesh with its nodes and elements in random order.
template <int D>
Mesh<D> shuffled(const Mesh<D>& mesh, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::size_t> order(mesh.points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::shuffle(order.begin(), order.end(), random);
    Mesh<D> result = mesh;
    for (std::size_t i = 0; i < order.size(); ++i) {
        result.points[NodeId(order[i])] = mesh.points[NodeId(i)];
    }
    const auto renumber = [&](auto& tuples) {
        for (auto& tuple : tuples) {
            for (NodeId& v : tuple) {
                v = NodeId(order[v.index()]);
            }
        }
    };
    renumber(result.elements);
    renumber(result.faces);
    std::shuffle(result.elements.begin(), result.elements.end(), random);
    return result;
}

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

/// Facet -> (elements, faces) on it.
template <int D>
using FacetMap =
    std::map<Facet<D>, std::pair<std::vector<std::pair<ElementId, int>>, std::vector<FaceId>>>;

template <int D>
void compare_facets_with_brute_force(const Mesh<D>& mesh) {
    FacetMap<D> expected;
    for (const ElementId e : mesh.elements.ids()) {
        for (int i = 0; i <= D; ++i) {
            expected[sorted(facet_of<D>(mesh[e], i))].first.emplace_back(e, i);
        }
    }
    for (const FaceId f : mesh.faces.ids()) {
        expected[sorted(mesh.faces[f])].second.push_back(f);
    }
    FacetMap<D> found;
    std::vector<Facet<D>> order;
    const FacetTable<D> table(mesh);
    table.visit(0, mesh.points.size(), [&](const FacetUses<D>& uses) {
        auto& entry = found[uses.nodes];
        for (const ElementSide& side : uses.sides) {
            entry.first.emplace_back(side.element, side.opposite);
        }
        entry.second.assign(uses.faces.begin(), uses.faces.end());
        order.push_back(uses.nodes);
    });
    QVERIFY(found == expected);
    QCOMPARE(order.size(), expected.size());             // each once,
    QVERIFY(std::is_sorted(order.begin(), order.end())); // and in order
}

} // namespace

class AdjacencyTest : public QObject {
    Q_OBJECT
private slots:
    void files_items_in_ascending_order();
    void agrees_with_brute_force();
    void gives_unused_nodes_empty_lists();
    void does_not_depend_on_the_number_of_threads();
    void matches_facets_as_brute_force_does();
    void visits_pieces_as_it_visits_the_whole();
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
    compare_with_brute_force(shuffled(shapes::square(8), 1));
    compare_with_brute_force(shuffled(shapes::cube(5), 2));
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
    const Mesh<2> mesh = shuffled(shapes::square(150), 3); // several pieces of nodes
    set_thread_count(1);
    const NodeNodes one = node_neighbours(mesh);
    set_thread_count(2);
    const NodeNodes two = node_neighbours(mesh);
    set_thread_count(0);
    QVERIFY(one.start == two.start);
    QVERIFY(one.values == two.values);
}

void AdjacencyTest::matches_facets_as_brute_force_does() {
    compare_facets_with_brute_force(shapes::single_tet());
    compare_facets_with_brute_force(shuffled(shapes::square(8), 4));
    compare_facets_with_brute_force(shuffled(shapes::cube(4), 5));
    Mesh<3> damaged = shuffled(shapes::cube(3), 6);
    damaged.elements.push_back(damaged.elements[ElementId(3)]);
    damaged.faces.push_back(damaged.faces[FaceId(5)]);
    damaged.faces.push_back(shapes::nodes(60, 0, 31));
    compare_facets_with_brute_force(damaged);
}

void AdjacencyTest::visits_pieces_as_it_visits_the_whole() {
    const Mesh<3> mesh = shuffled(shapes::cube(3), 7);
    const FacetTable<3> table(mesh);
    std::vector<Facet<3>> whole;
    std::vector<Facet<3>> pieces;
    table.visit(0, 64, [&](const FacetUses<3>& uses) { whole.push_back(uses.nodes); });
    for (const auto& [begin, end] :
         {std::pair<std::size_t, std::size_t>{0, 10}, {10, 11}, {11, 64}}) {
        table.visit(begin, end, [&](const FacetUses<3>& uses) { pieces.push_back(uses.nodes); });
    }
    QVERIFY(whole == pieces);
}

QTEST_APPLESS_MAIN(AdjacencyTest)
#include "adjacency_test.moc"
