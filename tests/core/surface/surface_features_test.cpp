// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_features.h"

#include "tests/core/surface/surfaces.h"

#include <QtTest>

#include <set>

using namespace ameco;

class SurfaceFeaturesTest : public QObject {
    Q_OBJECT
private slots:
    void a_cube_has_twelve_curves_and_eight_corners();
    void patches_of_a_cube_are_its_sides_however_it_is_labelled();
    void a_closed_curve_needs_no_corner();
    void a_smooth_surface_has_none();
    void the_angle_decides_data();
    void the_angle_decides();
    void edges_and_corners_of_the_file_are_kept();
};

void SurfaceFeaturesTest::a_cube_has_twelve_curves_and_eight_corners() {
    const Mesh<3> mesh = surfaces::cube(4);
    const SurfaceFeatures features = find_surface_features(mesh);
    QCOMPARE(features.curves.size(), std::size_t{12});
    QCOMPARE(features.corners.size(), std::size_t{8});
    QCOMPARE(features.ridges.size(), std::size_t{48});
    for (const SurfaceCurve& curve : features.curves) {
        QCOMPARE(curve.nodes.size(), std::size_t{5});
        QVERIFY(std::abs(curve.length - 1) < 1e-14);
        QVERIFY(curve.patches.first < curve.patches.second);
        QVERIFY(!curve.closed());
    }
}

void SurfaceFeaturesTest::patches_of_a_cube_are_its_sides_however_it_is_labelled() {
    const Mesh<3> labelled = surfaces::cube(3);
    Mesh<3> mesh = labelled;
    mesh.patch.assign(mesh.faces.size(), 17);
    QCOMPARE(segment_by_angle(mesh, 40), 6);
    std::set<std::pair<int, int>> pairs;
    for (const FaceId f : mesh.faces.ids()) {
        pairs.insert({labelled.patch[f], mesh.patch[f]});
    }
    QCOMPARE(pairs.size(), std::size_t{6});
    QCOMPARE(segment_by_angle(mesh, 91), 1);
}

void SurfaceFeaturesTest::a_closed_curve_needs_no_corner() {
    Mesh<3> mesh = surfaces::sphere(8);
    for (const FaceId f : mesh.faces.ids()) {
        double z = 0;
        for (const NodeId v : mesh.faces[f]) {
            z += mesh.points[v][2];
        }
        mesh.patch[f] = z > 1.5 ? 2 : 1; // a cap
    }
    const SurfaceFeatures features =
        find_surface_features(mesh, {.ridge_angle_deg = 60, .corner_angle_deg = 100});
    QCOMPARE(features.curves.size(), std::size_t{1});
    QVERIFY(features.curves[0].closed());
    QVERIFY(features.corners.empty());
    QVERIFY((features.curves[0].patches == std::pair(1, 2)));
}

void SurfaceFeaturesTest::a_smooth_surface_has_none() {
    QVERIFY(find_surface_features(surfaces::sphere(8)).ridges.empty());
    Mesh<3> mesh = surfaces::torus(30, 20);
    QCOMPARE(segment_by_angle(mesh, 40), 1);
}

void SurfaceFeaturesTest::the_angle_decides_data() {
    QTest::addColumn<double>("turn");
    QTest::addColumn<bool>("ridge");
    QTest::newRow("39") << 39.0 << false;
    QTest::newRow("41") << 41.0 << true;
    QTest::newRow("-41") << -41.0 << true;
    QTest::newRow("179") << 179.0 << true;
}

void SurfaceFeaturesTest::the_angle_decides() {
    QFETCH(double, turn);
    QFETCH(bool, ridge);
    Mesh<3> mesh;
    const double a = turn * std::numbers::pi / 180;
    for (const auto& x : {Vec<3>(0, 0, 0), Vec<3>(0, 1, 0), Vec<3>(-1, 0, 0),
                          Vec<3>(std::cos(a), 0, std::sin(a))}) {
        mesh.points.push_back(x);
    }
    surfaces::add_face(mesh, {NodeId(0), NodeId(1), NodeId(2)});
    surfaces::add_face(mesh, {NodeId(1), NodeId(0), NodeId(3)});
    QCOMPARE(find_surface_features(mesh).ridges.size(), std::size_t(ridge ? 5 : 4)); // four open
    QCOMPARE(segment_by_angle(mesh, 40), ridge ? 2 : 1);
}

void SurfaceFeaturesTest::edges_and_corners_of_the_file_are_kept() {
    Mesh<3> mesh = surfaces::sphere(4);
    const Facet<3> f = mesh.faces[FaceId(0)];
    mesh.features.edges = {{f[1], f[0]}};
    mesh.features.edge_labels = {3};
    mesh.features.corners = {f[2]};
    const SurfaceFeatures features = find_surface_features(mesh);
    QCOMPARE(features.ridges.size(), std::size_t{1});
    QCOMPARE(features.curves.size(), std::size_t{1});
    QCOMPARE(features.corners.size(), std::size_t{3}); // both ends, and the listed one
}

QTEST_APPLESS_MAIN(SurfaceFeaturesTest)
#include "surface_features_test.moc"
