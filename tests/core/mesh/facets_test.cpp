// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/facets.h"

#include "tests/support/shapes.h"

#include <QTest>

#include <map>

using namespace ameco;
using shapes::nodes;

namespace {

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

class FacetsTest : public QObject {
    Q_OBJECT
private slots:
    void matches_facets_as_brute_force_does();
    void visits_pieces_as_it_visits_the_whole();
    void knows_which_way_a_face_points();
};

void FacetsTest::matches_facets_as_brute_force_does() {
    compare_facets_with_brute_force(shapes::single_tet());
    compare_facets_with_brute_force(shapes::shuffled(shapes::square(8), 4));
    compare_facets_with_brute_force(shapes::shuffled(shapes::cube(4), 5));
    Mesh<3> damaged = shapes::shuffled(shapes::cube(3), 6);
    damaged.elements.push_back(damaged.elements[ElementId(3)]);
    damaged.faces.push_back(damaged.faces[FaceId(5)]);
    damaged.faces.push_back(shapes::nodes(60, 0, 31));
    compare_facets_with_brute_force(damaged);
}

void FacetsTest::visits_pieces_as_it_visits_the_whole() {
    const Mesh<3> mesh = shapes::shuffled(shapes::cube(3), 7);
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

void FacetsTest::knows_which_way_a_face_points() {
    Mesh<3> tet = shapes::single_tet();
    const ElementSide bottom{ElementId(0), 3};
    QVERIFY(!points_inward<3>(tet, bottom, nodes(0, 2, 1)));
    QVERIFY(!points_inward<3>(tet, bottom, nodes(2, 1, 0)));
    QVERIFY(points_inward<3>(tet, bottom, nodes(0, 1, 2)));
    tet.points[NodeId(3)][2] = 0; // flat: nobody can say
    QVERIFY(!points_inward<3>(tet, bottom, nodes(0, 1, 2)));
    const Mesh<2> triangle = shapes::single_triangle();
    QVERIFY(!points_inward<2>(triangle, {ElementId(0), 0}, nodes(1, 2)));
    QVERIFY(points_inward<2>(triangle, {ElementId(0), 0}, nodes(2, 1)));
}

QTEST_APPLESS_MAIN(FacetsTest)
#include "facets_test.moc"
