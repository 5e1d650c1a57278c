// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/boundary.h"

#include "core/mesh/check.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <set>

using namespace ameco;
using shapes::nodes;

namespace {

template <int D>
Mesh<D> without_faces(Mesh<D> mesh) {
    mesh.faces.clear();
    mesh.patch.clear();
    return mesh;
}

/// A regular polygon of `n` corners around the origin, cut into a fan.
Mesh<2> polygon(int n) {
    Mesh<2> mesh;
    mesh.points.push_back({0, 0});
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / n;
        mesh.points.push_back({std::cos(angle), std::sin(angle)});
        mesh.elements.push_back(nodes(0, 1 + i, 1 + (i + 1) % n));
        mesh.region.push_back(1);
    }
    return mesh;
}

template <int D>
std::set<int> patches(const Mesh<D>& mesh) {
    return {mesh.patch.begin(), mesh.patch.end()};
}

} // namespace

class BoundaryTest : public QObject {
    Q_OBJECT
private slots:
    void leaves_a_good_mesh_alone();
    void adds_a_missing_boundary();
    void gives_each_smooth_side_its_patch();
    void splits_patches_where_the_boundary_turns_data();
    void splits_patches_where_the_boundary_turns();
    void fills_holes_with_new_patches_only();
    void keeps_clear_of_patch_ids_that_have_names_only();
    void turns_faces_outwards();
    void turns_elements_if_all_are_negative();
    void leaves_single_negative_elements_alone();
    void drops_orphans_with_what_refers_to_them();
    void keeps_orphans_that_faces_use();
    void leaves_broken_meshes_alone();
};

void BoundaryTest::leaves_a_good_mesh_alone() {
    Mesh<3> mesh = shapes::cube(3);
    mesh.patch_names[2] = "outlet";
    mesh.features.corners = {NodeId(0)};
    const Mesh<3> before = mesh;
    const BoundaryRepair repair = complete_boundary(mesh);
    QVERIFY(mesh == before);
    QCOMPARE(repair.faces_added, 0);
    QCOMPARE(repair.faces_turned, 0);
    QCOMPARE(repair.orphans_removed, 0);
    QVERIFY(!repair.elements_turned);
    QCOMPARE(repair.first_new_patch, 7);
}

void BoundaryTest::adds_a_missing_boundary() {
    Mesh<3> tet = without_faces(shapes::single_tet());
    QCOMPARE(complete_boundary(tet).faces_added, 4);
    QVERIFY2(check(tet).valid(), check(tet).summary().c_str());
    Mesh<3> slab = without_faces(shapes::stretched_slab(3, 25, 1e-9));
    QCOMPARE(complete_boundary(slab).faces_added, 2 * (2 * 9 + 4 * 3 * 25));
    QVERIFY2(check(slab).valid(), check(slab).summary().c_str());
    Mesh<2> square = without_faces(shapes::square(3));
    QCOMPARE(complete_boundary(square).faces_added, 12);
    QVERIFY2(check(square).valid(), check(square).summary().c_str());
}

void BoundaryTest::gives_each_smooth_side_its_patch() {
    const Mesh<3> original = shapes::stretched_slab(3, 25, 1e-9);
    Mesh<3> mesh = without_faces(original);
    const BoundaryRepair repair = complete_boundary(mesh);
    QCOMPARE(repair.first_new_patch, 1);
    QCOMPARE(patches(mesh), (std::set<int>{1, 2, 3, 4, 5, 6}));
    QCOMPARE(mesh.patch_names.at(1), std::string("boundary-1"));
    QCOMPARE(mesh.patch_names.at(6), std::string("boundary-6"));
    // The new patches are the sides of the box, in some order.
    std::map<Facet<3>, int> side;
    for (const FaceId f : original.faces.ids()) {
        side[sorted(original.faces[f])] = original.patch[f];
    }
    std::set<std::pair<int, int>> pairs;
    for (const FaceId f : mesh.faces.ids()) {
        pairs.emplace(side.at(sorted(mesh.faces[f])), mesh.patch[f]);
    }
    QCOMPARE(pairs.size(), std::size_t{6});
}

void BoundaryTest::splits_patches_where_the_boundary_turns_data() {
    QTest::addColumn<int>("corners");
    QTest::addColumn<double>("angle");
    QTest::addColumn<int>("expected");
    QTest::newRow("turns by 36, ridges from 40") << 10 << 40.0 << 1;
    QTest::newRow("turns by 36, ridges from 35") << 10 << 35.0 << 10;
    QTest::newRow("turns by 45, ridges from 40") << 8 << 40.0 << 8;
    QTest::newRow("turns by 120, ridges from 130") << 3 << 130.0 << 1;
}

void BoundaryTest::splits_patches_where_the_boundary_turns() {
    QFETCH(int, corners);
    QFETCH(double, angle);
    QFETCH(int, expected);
    Mesh<2> mesh = polygon(corners);
    complete_boundary(mesh, angle);
    QVERIFY(check(mesh).valid());
    QCOMPARE(patches(mesh).size(), static_cast<std::size_t>(expected));
}

void BoundaryTest::fills_holes_with_new_patches_only() {
    Mesh<3> mesh = shapes::cube(3);
    const Mesh<3> original = mesh;
    mesh.faces.clear();
    mesh.patch.clear();
    for (const FaceId f : original.faces.ids()) {
        if (original.patch[f] != 3 && original.patch[f] != 4) { // low and high y
            mesh.faces.push_back(original.faces[f]);
            mesh.patch.push_back(original.patch[f]);
        }
    }
    const std::size_t listed = mesh.faces.size();
    const Mesh<3> before = mesh;
    const BoundaryRepair repair = complete_boundary(mesh);
    QCOMPARE(repair.faces_added, 36);
    QCOMPARE(repair.first_new_patch, 7);
    QVERIFY(std::equal(before.faces.begin(), before.faces.end(), mesh.faces.begin()));
    QVERIFY(std::equal(before.patch.begin(), before.patch.end(), mesh.patch.begin()));
    const std::set<int> added(mesh.patch.begin() + static_cast<std::ptrdiff_t>(listed),
                              mesh.patch.end());
    QCOMPARE(added, (std::set<int>{7, 8}));
    QVERIFY(check(mesh).valid());
}

void BoundaryTest::keeps_clear_of_patch_ids_that_have_names_only() {
    Mesh<2> mesh = without_faces(shapes::single_triangle());
    mesh.patch_names[12] = "unused";
    QCOMPARE(complete_boundary(mesh).first_new_patch, 13);
    QCOMPARE(patches(mesh), (std::set<int>{13, 14, 15}));
    QCOMPARE(mesh.patch_names.at(12), std::string("unused"));

    Mesh<2> huge = shapes::single_triangle();
    huge.faces.raw().pop_back();
    huge.patch.raw().pop_back();
    huge.patch[FaceId(0)] = std::numeric_limits<int>::max();
    QCOMPARE(complete_boundary(huge).first_new_patch, 2);
}

void BoundaryTest::turns_faces_outwards() {
    Mesh<3> mesh = shapes::cube(2);
    for (Facet<3>& f : mesh.faces) {
        std::swap(f[0], f[1]);
    }
    QCOMPARE(complete_boundary(mesh).faces_turned, static_cast<std::int64_t>(mesh.faces.size()));
    QVERIFY(check(mesh).valid());
    Mesh<2> square = shapes::square(2);
    std::swap(square.faces[FaceId(3)][0], square.faces[FaceId(3)][1]);
    QCOMPARE(complete_boundary(square).faces_turned, 1);
    QVERIFY(check(square).valid());
}

void BoundaryTest::turns_elements_if_all_are_negative() {
    Mesh<3> mesh = shapes::cube(2);
    const Mesh<3> original = mesh;
    for (Simplex<3>& s : mesh.elements) {
        std::swap(s[2], s[3]);
    }
    const BoundaryRepair repair = complete_boundary(mesh);
    QVERIFY(repair.elements_turned);
    QCOMPARE(repair.faces_turned, 0); // they were right all along
    QVERIFY(mesh == original);
    Mesh<2> square = without_faces(shapes::square(2));
    for (Simplex<2>& s : square.elements) {
        std::swap(s[0], s[1]);
    }
    QVERIFY(complete_boundary(square).elements_turned);
    QVERIFY(check(square).valid());
}

void BoundaryTest::leaves_single_negative_elements_alone() {
    Mesh<3> mesh = shapes::cube(2);
    std::swap(mesh.elements[ElementId(0)][0], mesh.elements[ElementId(0)][1]);
    const Mesh<3> before = mesh;
    QVERIFY(!complete_boundary(mesh).elements_turned);
    QVERIFY(mesh == before);
}

void BoundaryTest::drops_orphans_with_what_refers_to_them() {
    Mesh<3> mesh = shapes::single_tet();
    const Mesh<3> tet = mesh;
    // Nodes 0 and 2 of the new numbering belong to nobody.
    mesh.points = IdVector<NodeId, Vec<3>>(
        std::vector<Vec<3>>{{9, 9, 9}, {0, 0, 0}, {8, 8, 8}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    mesh.labels = IdVector<NodeId, int>(std::vector<int>{10, 11, 12, 13, 14, 15});
    const std::array<int, 4> moved{1, 3, 4, 5};
    const auto renumber = [&](auto& tuples) {
        for (auto& tuple : tuples) {
            for (NodeId& v : tuple) {
                v = NodeId(moved[v.index()]);
            }
        }
    };
    renumber(mesh.elements);
    renumber(mesh.faces);
    mesh.features.corners = {NodeId(5), NodeId(2)};
    mesh.features.required_nodes = {NodeId(0)};
    mesh.features.edges = {nodes(1, 2), nodes(1, 3), nodes(4, 5)};
    mesh.features.edge_labels = {21, 22, 23};
    mesh.features.ridges = {0, 2};
    mesh.features.required_edges = {1};

    QCOMPARE(complete_boundary(mesh).orphans_removed, 2);
    QVERIFY(mesh.points == tet.points);
    QVERIFY(mesh.elements == tet.elements);
    QVERIFY(mesh.faces == tet.faces);
    QCOMPARE(mesh.labels.raw(), (std::vector<int>{11, 13, 14, 15}));
    QVERIFY(mesh.features.corners == std::vector<NodeId>{NodeId(3)});
    QVERIFY(mesh.features.required_nodes.empty());
    QVERIFY(mesh.features.edges == (std::vector<Edge>{nodes(0, 1), nodes(2, 3)}));
    QCOMPARE(mesh.features.edge_labels, (std::vector<int>{22, 23}));
    QCOMPARE(mesh.features.ridges, std::vector<int>{1});
    QCOMPARE(mesh.features.required_edges, std::vector<int>{0});
    QVERIFY(check(mesh).valid());
}

void BoundaryTest::keeps_orphans_that_faces_use() {
    Mesh<3> mesh = shapes::single_tet();
    mesh.points.push_back({2, 2, 2});
    mesh.faces.push_back(nodes(0, 1, 4));
    mesh.patch.push_back(1);
    QCOMPARE(complete_boundary(mesh).orphans_removed, 0);
    QCOMPARE(check(mesh).errors.at(0).defect, Defect::face_without_element);
}

void BoundaryTest::leaves_broken_meshes_alone() {
    const auto stays = [](Mesh<3> mesh) {
        const Mesh<3> before = mesh;
        complete_boundary(mesh);
        return mesh.elements == before.elements && mesh.faces == before.faces &&
               mesh.points.size() == before.points.size();
    };
    Mesh<3> out_of_range = without_faces(shapes::two_tets());
    out_of_range.elements[ElementId(0)][0] = NodeId(99);
    QVERIFY(stays(out_of_range));
    Mesh<3> not_finite = without_faces(shapes::two_tets());
    not_finite.points[NodeId(1)][0] = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(stays(not_finite));
    Mesh<3> repeated = without_faces(shapes::two_tets());
    repeated.elements[ElementId(0)][0] = repeated.elements[ElementId(0)][1];
    QVERIFY(stays(repeated));
    QVERIFY(stays(Mesh<3>()));
}

QTEST_APPLESS_MAIN(BoundaryTest)
#include "boundary_test.moc"
