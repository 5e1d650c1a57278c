// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_repair.h"

#include "core/surface/surface_distance.h"
#include "core/surface/surface_report.h"
#include "tests/core/surface/surfaces.h"

#include <QtTest>

using namespace ameco;

class SurfaceRepairTest : public QObject {
    Q_OBJECT
private slots:
    void leaves_a_sound_surface_as_it_is();
    void mends_what_is_harmless_data();
    void mends_what_is_harmless();
    void turns_the_walls_of_cavities_inwards();
    void takes_a_node_on_an_edge_into_the_face_beside_it();
    void leaves_holes_alone();
};

void SurfaceRepairTest::leaves_a_sound_surface_as_it_is() {
    Mesh<3> mesh = surfaces::cube(3);
    const Mesh<3> before = mesh;
    QVERIFY(repair_surface(mesh).nothing());
    QVERIFY(mesh == before);
}

void SurfaceRepairTest::mends_what_is_harmless_data() {
    QTest::addColumn<QString>("damage");
    for (const char* damage : {"unmerged", "some turned", "all turned", "twice", "node twice",
                               "unused node", "everything"}) {
        QTest::newRow(damage) << damage;
    }
}

void SurfaceRepairTest::mends_what_is_harmless() {
    QFETCH(QString, damage);
    const bool all = damage == "everything";
    const Mesh<3> good = surfaces::torus(24, 12);
    Mesh<3> mesh = good;
    if (damage == "unmerged" || all) {
        mesh = surfaces::unmerged(mesh);
    }
    for (const FaceId f : mesh.faces.ids()) {
        if (damage == "all turned" || ((damage == "some turned" || all) && f.value() % 3 == 0)) {
            surfaces::turn(mesh, f);
        }
    }
    const Facet<3> face = mesh.faces[FaceId(7)];
    if (damage == "twice" || all) {
        surfaces::add_face(mesh, {face[1], face[0], face[2]});
    }
    if (damage == "node twice" || all) {
        surfaces::add_face(mesh, {face[0], face[0], face[2]});
    }
    if (damage == "unused node" || all) {
        mesh.points.push_back({7, 7, 7});
    }
    QVERIFY(!repair_surface(mesh).nothing());
    const SurfaceReport report = inspect_surface(mesh);
    QVERIFY(report.sound());
    QCOMPARE(report.unused_nodes, std::int64_t{0});
    QCOMPARE(mesh.faces.size(), good.faces.size());
    QCOMPARE(mesh.points.size(), good.points.size());
    QCOMPARE(report.parts[0].genus(), std::int64_t{1});
    QVERIFY(report.parts[0].volume > 0);
    QCOMPARE(surface_distance(mesh, good, 1e-9).upper(), 0.0);
}

void SurfaceRepairTest::turns_the_walls_of_cavities_inwards() {
    // A shell, and a ball in its cavity; beside them another ball; all turned outwards.
    Mesh<3> mesh = surfaces::both(surfaces::sphere(6, 3), surfaces::sphere(5, 2));
    mesh = surfaces::both(mesh, surfaces::sphere(4, 1));
    mesh = surfaces::both(mesh, surfaces::sphere(4, 1, {10, 0, 0}));
    QCOMPARE(repair_surface(mesh).faces_turned, std::int64_t{20 * 25});
    const SurfaceReport report = inspect_surface(mesh);
    std::vector<bool> outwards;
    for (const SurfacePart& part : report.parts) {
        outwards.push_back(part.volume > 0);
    }
    QVERIFY((outwards == std::vector<bool>{true, false, true, true}));
}

void SurfaceRepairTest::takes_a_node_on_an_edge_into_the_face_beside_it() {
    // The edge of a cube's face has a node in its middle that only one side knows; a face without
    // area fills the gap.
    Mesh<3> mesh = surfaces::cube(1);
    const auto [a, b, c] = mesh.faces[FaceId(0)];
    const NodeId middle(mesh.points.size());
    mesh.points.push_back((mesh.points[a] + mesh.points[b]) / 2);
    mesh.faces[FaceId(0)] = {a, middle, c};
    surfaces::add_face(mesh, {middle, b, c});
    surfaces::add_face(mesh, {a, b, middle});
    QCOMPARE(inspect_surface(mesh).defects.flat_faces.size(), std::size_t{1});
    QCOMPARE(repair_surface(mesh).edges_flipped, std::int64_t{1});
    const SurfaceReport report = inspect_surface(mesh);
    QVERIFY(report.sound());
    QVERIFY(std::abs(report.parts[0].volume - 1) < 1e-14);
}

void SurfaceRepairTest::leaves_holes_alone() {
    Mesh<3> mesh = surfaces::cube(2);
    surfaces::remove_face(mesh, FaceId(3));
    QVERIFY(repair_surface(mesh).nothing());
    QVERIFY(inspect_surface(mesh).defects.beyond_repair());
}

QTEST_APPLESS_MAIN(SurfaceRepairTest)
#include "surface_repair_test.moc"
