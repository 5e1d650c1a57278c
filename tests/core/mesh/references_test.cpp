// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/references.h"

#include "tests/support/shapes.h"

#include <QTest>

#include <limits>

using namespace ameco;
using shapes::nodes;

class ReferencesTest : public QObject {
    Q_OBJECT
private slots:
    void finds_nothing_in_good_meshes();
    void counts_all_and_names_the_first();
    void names_the_first_of_many_elements();
    void takes_lines_for_faces_in_2d();
    void sees_repetitions();
    void tells_what_can_be_computed();
};

void ReferencesTest::finds_nothing_in_good_meshes() {
    QCOMPARE(find_bad_references(shapes::cube(2)).count, 0);
    QCOMPARE(find_bad_references(Mesh<2>()).count, 0);
}

void ReferencesTest::counts_all_and_names_the_first() {
    Mesh<3> mesh = shapes::two_tets();
    mesh.elements[ElementId(1)] = nodes(-1, 5, 2, 1000);
    mesh.faces[FaceId(0)][0] = NodeId(77);
    const BadReferences bad = find_bad_references(mesh);
    QCOMPARE(bad.count, 4);
    QCOMPARE(bad.example, std::string("element 1 refers to node -1, but there are 5"));
}

void ReferencesTest::names_the_first_of_many_elements() {
    Mesh<2> mesh = shapes::square(160);
    QVERIFY(mesh.elements.size() > 3 * 16384); // pieces that threads share
    for (const int e : {50000, 20000, 20001}) {
        mesh.elements[ElementId(e)][1] = NodeId(-1);
    }
    const BadReferences bad = find_bad_references(mesh);
    QCOMPARE(bad.count, 3);
    QVERIFY(bad.example.starts_with("element 20000 refers to node -1"));
    QVERIFY(!is_computable(mesh));
    mesh = shapes::square(160);
    mesh.elements[ElementId(50000)][1] = mesh.elements[ElementId(50000)][0];
    QVERIFY(!is_computable(mesh));
}

void ReferencesTest::takes_lines_for_faces_in_2d() {
    Mesh<2> mesh = shapes::single_triangle();
    mesh.features.ridges = {2};
    QCOMPARE(find_bad_references(mesh).count, 0);
    mesh.features.ridges = {3};
    QCOMPARE(find_bad_references(mesh).example,
             std::string("ridge 0 refers to face 3, but there are 3"));
}

void ReferencesTest::sees_repetitions() {
    QVERIFY(!has_repetition(nodes(3, 1, 2, 0)));
    QVERIFY(has_repetition(nodes(3, 1, 2, 3)));
    QVERIFY(has_repetition(nodes(1, 1)));
}

void ReferencesTest::tells_what_can_be_computed() {
    QVERIFY(is_computable(shapes::two_tets()));
    const auto after = [](auto damage) {
        Mesh<3> mesh = shapes::two_tets();
        damage(mesh);
        return is_computable(mesh);
    };
    QVERIFY(!after([](Mesh<3>& m) { m.elements[ElementId(0)][0] = NodeId(5); }));
    QVERIFY(!after([](Mesh<3>& m) { m.elements[ElementId(0)] = nodes(0, 0, 1, 2); }));
    QVERIFY(!after([](Mesh<3>& m) { m.faces[FaceId(0)] = nodes(0, 0, 1); }));
    QVERIFY(!after(
        [](Mesh<3>& m) { m.points[NodeId(2)][2] = std::numeric_limits<double>::infinity(); }));
}

QTEST_APPLESS_MAIN(ReferencesTest)
#include "references_test.moc"
