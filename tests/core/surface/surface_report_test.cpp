// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_report.h"

#include "core/base/error.h"
#include "core/surface/self_intersections.h"
#include "core/surface/surface_repair.h"
#include "tests/core/surface/surfaces.h"

#include <QtTest>

#include <limits>

using namespace ameco;

class SurfaceReportTest : public QObject {
    Q_OBJECT
private slots:
    void counts_handles_and_parts_data();
    void counts_handles_and_parts();
    void refuses_what_bounds_no_volume_data();
    void refuses_what_bounds_no_volume();
    void lists_every_place();
    void refuses_numbers_that_make_no_sense();
    void finds_the_same_intersections_as_brute_force();
    void faces_that_only_touch_as_neighbours_do_not_intersect();
};

namespace {

/// A strip of n quadrilaterals that is closed after half a twist.
Mesh<3> moebius_band(int n) {
    Mesh<3> mesh;
    for (int i = 0; i < n; ++i) {
        const double u = 2 * std::numbers::pi * i / n;
        for (const double s : {-0.3, 0.3}) {
            const double r = 1 + s * std::cos(u / 2);
            mesh.points.push_back({r * std::cos(u), r * std::sin(u), s * std::sin(u / 2)});
        }
    }
    for (int i = 0; i < n; ++i) {
        const bool last = i + 1 == n; // its ends are exchanged
        const NodeId a(2 * i), b(2 * i + 1);
        const NodeId c(last ? 0 : 2 * i + 3), d(last ? 1 : 2 * i + 2);
        surfaces::add_face(mesh, {a, b, c});
        surfaces::add_face(mesh, {a, c, d});
    }
    return mesh;
}

/// A Klein bottle (figure 8 immersed in space): closed, every edge between two faces, one side.
Mesh<3> klein_bottle(int n, int m) {
    Mesh<3> mesh;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * (j + 0.5) / m;
            const double r = 2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
            mesh.points.push_back(
                {r * std::cos(u), r * std::sin(u),
                 std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v)});
        }
    }
    const auto node = [&](int i, int j) {
        j %= m;
        return i < n ? NodeId(i * m + j) : NodeId((m - 1 - j)); // glued upside down
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            surfaces::add_face(mesh, {node(i, j), node(i + 1, j), node(i + 1, j + 1)});
            surfaces::add_face(mesh, {node(i, j), node(i + 1, j + 1), node(i, j + 1)});
        }
    }
    return mesh;
}

Mesh<3> damaged(const QString& damage) {
    Mesh<3> mesh = surfaces::cube(3);
    const Facet<3> face = mesh.faces[FaceId(4)];
    if (damage == "hole") {
        surfaces::remove_face(mesh, FaceId(4));
    } else if (damage == "turned") {
        surfaces::turn(mesh, FaceId(4));
    } else if (damage == "twice") {
        surfaces::add_face(mesh, {face[1], face[2], face[0]});
    } else if (damage == "fin") {
        mesh.points.push_back({2, 2, 2});
        surfaces::add_face(mesh, {face[0], face[1], NodeId(mesh.points.size() - 1)});
    } else if (damage == "unmerged") {
        mesh = surfaces::unmerged(mesh);
    } else if (damage == "flat") {
        mesh.points[face[2]] = (mesh.points[face[0]] + mesh.points[face[1]]) / 2;
    } else if (damage == "pinched") { // two cubes with a common corner
        Mesh<3> other = surfaces::cube(3);
        for (Vec<3>& x : other.points) {
            x = -x;
        }
        for (const FaceId f : other.faces.ids()) {
            surfaces::turn(other, f); // a reflection turns the faces inwards
        }
        const auto corner_of = [](const Mesh<3>& m) {
            return NodeId(static_cast<std::size_t>(
                std::find(m.points.begin(), m.points.end(), Vec<3>(0, 0, 0)) - m.points.begin()));
        };
        const NodeId here = corner_of(mesh);
        const NodeId there(corner_of(other).index() + mesh.points.size());
        mesh = surfaces::both(mesh, other);
        for (Facet<3>& f : mesh.faces) {
            std::replace(f.begin(), f.end(), there, here);
        }
    } else if (damage == "crossing") { // two overlapping spheres
        mesh = surfaces::both(surfaces::sphere(3), surfaces::sphere(3, 1, {1, 0.1, 0.2}));
    } else if (damage == "pushed through") {
        mesh.points[face[0]] = Vec<3>(2, 2, -2);
    } else if (damage == "moebius") {
        mesh = moebius_band(24);
    } else if (damage == "klein") {
        mesh = klein_bottle(24, 12);
    } else if (damage == "edge of four") { // two cubes with a common edge
        Mesh<3> other = surfaces::cube(1), first = surfaces::cube(1);
        for (Vec<3>& x : other.points) {
            x += Vec<3>(1, 1, 0);
        }
        mesh = surfaces::both(first, other);
        for (Facet<3>& f : mesh.faces) {
            for (NodeId& v : f) {
                const auto same = std::find(mesh.points.begin(), mesh.points.end(), mesh.points[v]);
                v = NodeId(static_cast<std::size_t>(same - mesh.points.begin()));
            }
        }
    }
    return mesh;
}

} // namespace

void SurfaceReportTest::counts_handles_and_parts_data() {
    QTest::addColumn<QString>("shape");
    QTest::addColumn<int>("parts");
    QTest::addColumn<int>("genus");
    QTest::addColumn<double>("volume");
    QTest::newRow("cube") << "cube" << 1 << 0 << 1.0;
    QTest::newRow("torus") << "torus" << 1 << 1 << 2 * std::pow(std::numbers::pi * 0.3, 2);
    QTest::newRow("two spheres") << "spheres" << 2 << 0 << 4 * std::numbers::pi / 3;
}

void SurfaceReportTest::counts_handles_and_parts() {
    QFETCH(QString, shape);
    QFETCH(int, parts);
    QFETCH(int, genus);
    QFETCH(double, volume);
    const Mesh<3> mesh = shape == "cube"    ? surfaces::cube(3)
                         : shape == "torus" ? surfaces::torus(60, 40)
                                            : surfaces::both(surfaces::sphere(12),
                                                             surfaces::sphere(12, 1, {3, 0, 0}));
    const SurfaceReport report = inspect_surface(mesh);
    QVERIFY2(report.sound(), defect_remarks(report.defects).empty()
                                 ? ""
                                 : defect_remarks(report.defects).front().c_str());
    QCOMPARE(report.parts.size(), std::size_t(parts));
    QCOMPARE(report.parts.back().genus(), std::int64_t(genus));
    QVERIFY(std::abs(report.parts.back().volume - volume) < 0.02 * volume);
    require_sound_surface(report, "a.stl"); // throws nothing
}

void SurfaceReportTest::refuses_what_bounds_no_volume_data() {
    QTest::addColumn<QString>("damage");
    QTest::addColumn<QString>("words");
    QTest::newRow("hole") << "hole"
                          << "3 open edges, with one face only";
    QTest::newRow("face turned") << "turned"
                                 << "turned differently";
    QTest::newRow("face twice") << "twice"
                                << "edges of more than two faces";
    QTest::newRow("fin") << "fin"
                         << "1 edge of more than two faces";
    QTest::newRow("nodes not merged") << "unmerged"
                                      << "open edges";
    QTest::newRow("flat face") << "flat"
                               << "intersect";
    QTest::newRow("touching at a node") << "pinched"
                                        << "1 node where parts of the surface only touch";
    QTest::newRow("two spheres overlap") << "crossing"
                                         << "pairs of faces that intersect";
    QTest::newRow("a corner pushed through") << "pushed through"
                                             << "pairs of faces that intersect";
    QTest::newRow("Moebius band") << "moebius"
                                  << "open edges";
    QTest::newRow("Klein bottle") << "klein"
                                  << "intersect";
    QTest::newRow("touching along an edge") << "edge of four"
                                            << "1 edge of more than two faces";
}

void SurfaceReportTest::refuses_what_bounds_no_volume() {
    QFETCH(QString, damage);
    QFETCH(QString, words);
    const SurfaceReport report = inspect_surface(damaged(damage));
    QVERIFY(!report.sound());
    try {
        require_sound_surface(report, "a.stl");
        QFAIL("accepted");
    } catch (const InputError& error) {
        QVERIFY2(QString(error.what()).startsWith("a.stl: "), error.what());
        QVERIFY2(QString(error.what()).contains(words), error.what());
        QVERIFY2(!QString(error.what()).contains('\n'), error.what());
    }
    if (damage == "twice" || damage == "unmerged" || damage == "flat") {
        // What follows from it is not told where it is mended with it.
        QVERIFY(repair_helps(damaged(damage), report));
        try {
            require_sound_surface(report, "a.stl", true);
            QFAIL("accepted");
        } catch (const InputError& error) {
            QVERIFY2(QString(error.what()).endsWith("--repair mends this without loss"),
                     error.what());
            QVERIFY2(!QString(error.what()).contains(words), error.what());
        }
    } else if (damage != "turned") {
        QVERIFY(!repair_helps(damaged(damage), report));
    }
    if (damage == "klein") {
        QVERIFY(!report.parts[0].orientable);
        QVERIFY(report.parts[0].closed);
    }
}

void SurfaceReportTest::lists_every_place() {
    Mesh<3> mesh = surfaces::cube(3);
    const Facet<3> face = mesh.faces[FaceId(4)];
    surfaces::remove_face(mesh, FaceId(4));
    const SurfaceDefects defects = inspect_surface(mesh).defects;
    QCOMPARE(defects.open_edges.size(), std::size_t{3});
    for (const Edge& edge : defects.open_edges) {
        for (const NodeId v : edge) {
            QVERIFY(std::find(face.begin(), face.end(), v) != face.end());
        }
    }
}

void SurfaceReportTest::refuses_numbers_that_make_no_sense() {
    QVERIFY_THROWS_EXCEPTION(InputError, (void)inspect_surface(Mesh<3>()));
    Mesh<3> mesh = surfaces::cube(2);
    mesh.faces[FaceId(0)][1] = NodeId(1000);
    QVERIFY_THROWS_EXCEPTION(InputError, (void)inspect_surface(mesh));
    mesh = surfaces::cube(2);
    mesh.points[mesh.faces[FaceId(0)][1]][2] = std::numeric_limits<double>::quiet_NaN();
    QVERIFY_THROWS_EXCEPTION(InputError, (void)inspect_surface(mesh));
}

void SurfaceReportTest::finds_the_same_intersections_as_brute_force() {
    // Spheres that overlap: a pair intersects if an edge of one face crosses the other.
    const Mesh<3> mesh =
        surfaces::both(surfaces::sphere(4), surfaces::sphere(4, 0.9, {0.63, 0.29, 0.17}));
    const auto crosses = [&](const Facet<3>& f, const Facet<3>& g) {
        const auto x = [&](NodeId v) { return mesh.points[v]; };
        for (int k = 0; k < 3; ++k) {
            const Vec<3> p = x(f[k]), q = x(f[(k + 1) % 3]);
            const int side = orientation(x(g[0]), x(g[1]), x(g[2]), p);
            if (side * orientation(x(g[0]), x(g[1]), x(g[2]), q) >= 0) {
                continue;
            }
            const int s = orientation(p, q, x(g[0]), x(g[1]));
            if (s == orientation(p, q, x(g[1]), x(g[2])) &&
                s == orientation(p, q, x(g[2]), x(g[0]))) {
                return true;
            }
        }
        return false;
    };
    std::vector<std::array<FaceId, 2>> expected;
    const std::size_t half = mesh.faces.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
        for (std::size_t j = half; j < 2 * half; ++j) {
            const Facet<3>&f = mesh.faces[FaceId(i)], &g = mesh.faces[FaceId(j)];
            if (crosses(f, g) || crosses(g, f)) {
                expected.push_back({FaceId(i), FaceId(j)});
            }
        }
    }
    QVERIFY(expected.size() > 20);
    QVERIFY(self_intersections(mesh) == expected);
}

void SurfaceReportTest::faces_that_only_touch_as_neighbours_do_not_intersect() {
    QVERIFY(self_intersections(surfaces::cube(4)).empty()); // many coplanar neighbours
    QVERIFY(self_intersections(surfaces::torus(20, 12)).empty());
}

QTEST_APPLESS_MAIN(SurfaceReportTest)
#include "surface_report_test.moc"
