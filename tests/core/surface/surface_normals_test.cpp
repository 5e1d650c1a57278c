// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_normals.h"

#include "core/base/error.h"
#include "tests/core/surface/surfaces.h"

#include <QtTest>

using namespace ameco;

class SurfaceNormalsTest : public QObject {
    Q_OBJECT
private slots:
    void of_a_sphere_are_radii();
    void of_a_cube_see_all_sides_alike();
    void nobody_sees_all_faces_of_a_folded_corner();
    void neighbours_are_in_order();
    void faces_beyond_edges_are_mutual();
    void refuses_a_surface_that_is_none();
};

void SurfaceNormalsTest::of_a_sphere_are_radii() {
    const Mesh<3> mesh = surfaces::sphere(12);
    const auto directions = node_directions(mesh, HalfEdges(mesh));
    for (const NodeId v : mesh.points.ids()) {
        QVERIFY(directions[v].normal.dot(mesh.points[v]) > 0.998);
        QVERIFY(directions[v].visibility > 0.99);
        QVERIFY(std::abs(directions[v].normal.norm() - 1) < 1e-14);
    }
}

void SurfaceNormalsTest::of_a_cube_see_all_sides_alike() {
    const Mesh<3> mesh = surfaces::cube(3);
    const auto directions = node_directions(mesh, HalfEdges(mesh));
    for (const NodeId v : mesh.points.ids()) {
        Vec<3> expected = Vec<3>::Zero();
        for (int i = 0; i < 3; ++i) {
            expected[i] = mesh.points[v][i] == 0 ? -1 : mesh.points[v][i] == 1 ? 1 : 0;
        }
        QVERIFY((directions[v].normal - expected.normalized()).norm() < 1e-12);
        QVERIFY(std::abs(directions[v].visibility - 1 / expected.norm()) < 1e-12);
    }
}

void SurfaceNormalsTest::nobody_sees_all_faces_of_a_folded_corner() {
    // The top of a thin fin that a hat-shaped valley cuts: normals to both sides, up, and down.
    Mesh<3> mesh;
    const std::vector<Vec<3>> rim{{1, 0, 0.2}, {0.1, 1, 0.2}, {-1, 0, -5}, {0.1, -1, 0.2}};
    mesh.points.push_back({0, 0, 0});
    for (const Vec<3>& x : rim) {
        mesh.points.push_back(x);
    }
    for (int i = 0; i < 4; ++i) {
        surfaces::add_face(mesh, {NodeId(0), NodeId(1 + i), NodeId(1 + (i + 1) % 4)});
    }
    const HalfEdges half_edges(mesh);
    const auto directions = node_directions(mesh, half_edges);
    const auto normals = face_normals(mesh);
    for (const FaceId f : half_edges.faces_around(NodeId(0))) {
        QVERIFY(directions[NodeId(0)].normal.dot(normals[f]) >=
                directions[NodeId(0)].visibility - 1e-14);
    }
    // No direction of a fine grid does better.
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 100; ++j) {
            const double u = std::numbers::pi * i / 100, v = 2 * std::numbers::pi * j / 100;
            const Vec<3> n(std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u));
            double least = 1;
            for (const Vec<3>& m : normals) {
                least = std::min(least, n.dot(m));
            }
            QVERIFY(least <= directions[NodeId(0)].visibility + 1e-12);
        }
    }
}

void SurfaceNormalsTest::neighbours_are_in_order() {
    const Mesh<3> mesh = surfaces::cube(3);
    const HalfEdges half_edges(mesh);
    for (const NodeId v : mesh.points.ids()) {
        const auto ring = half_edges.nodes_around(v);
        QCOMPARE(ring.size(), half_edges.faces_around(v).size());
        QCOMPARE(*std::min_element(ring.begin(), ring.end()), ring.front());
        for (std::size_t i = 0; i < ring.size(); ++i) { // v, ring[i], ring[i+1] is a face
            const Facet<3> expected = sorted(Facet<3>{v, ring[i], ring[(i + 1) % ring.size()]});
            QVERIFY(std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Facet<3>& f) {
                return sorted(f) == expected &&
                       !oppositely_oriented(f, Facet<3>{v, ring[i], ring[(i + 1) % ring.size()]});
            }));
        }
    }
}

void SurfaceNormalsTest::faces_beyond_edges_are_mutual() {
    Mesh<3> mesh = surfaces::cube(2);
    surfaces::remove_face(mesh, FaceId(5));
    const HalfEdges half_edges(mesh);
    int open = 0;
    for (const FaceId f : mesh.faces.ids()) {
        for (int k = 0; k < 3; ++k) {
            const FaceId g = half_edges.face_beyond(f, k);
            if (!g.valid()) {
                ++open;
                continue;
            }
            bool mutual = false;
            for (int j = 0; j < 3; ++j) {
                mutual = mutual || half_edges.face_beyond(g, j) == f;
            }
            QVERIFY(mutual);
        }
    }
    QCOMPARE(open, 3);
}

void SurfaceNormalsTest::refuses_a_surface_that_is_none() {
    Mesh<3> mesh = surfaces::cube(1);
    mesh.points.push_back({2, 2, 2});
    surfaces::add_face(
        mesh, {mesh.faces[FaceId(0)][0], mesh.faces[FaceId(0)][1], NodeId(mesh.points.size() - 1)});
    QVERIFY_THROWS_EXCEPTION(InputError, HalfEdges{mesh});
}

QTEST_APPLESS_MAIN(SurfaceNormalsTest)
#include "surface_normals_test.moc"
