// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/surface_distance.h"

#include "core/surface/surface_tree.h"
#include "tests/core/surface/surfaces.h"

#include <QtTest>

#include <random>

using namespace ameco;

class SurfaceDistanceTest : public QObject {
    Q_OBJECT
private slots:
    void closest_points_are_those_of_brute_force();
    void a_segment_crosses_a_sphere_where_it_must();
    void a_segment_through_an_edge_is_said_to_touch();
    void bounds_hold_the_exact_distance_data();
    void bounds_hold_the_exact_distance();
    void sees_a_peak_between_nodes_that_agree();
    void differs_by_direction();
    void is_not_fooled_by_samples();
};

void SurfaceDistanceTest::closest_points_are_those_of_brute_force() {
    const Mesh<3> mesh = surfaces::torus(20, 12);
    const SurfaceTree tree(mesh);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1.5, 1.5);
    for (int i = 0; i < 200; ++i) {
        const Vec<3> p(number(random), number(random), number(random));
        double expected = 1e9;
        for (const FaceId f : mesh.faces.ids()) {
            // Dense samples, and so never smaller than the truth.
            const auto& t = tree.triangle(f);
            for (int a = 0; a <= 8; ++a) {
                for (int b = 0; a + b <= 8; ++b) {
                    const Vec<3> x = t[0] + (t[1] - t[0]) * a / 8 + (t[2] - t[0]) * b / 8;
                    expected = std::min(expected, (p - x).norm());
                }
            }
        }
        const auto closest = tree.closest(p);
        QVERIFY(closest.distance <= expected + 1e-12);
        QVERIFY(closest.distance >= expected - 0.06);
        QVERIFY(std::abs((closest.point - p).norm() - closest.distance) < 1e-15);
    }
}

void SurfaceDistanceTest::a_segment_crosses_a_sphere_where_it_must() {
    const SurfaceTree tree(surfaces::sphere(20));
    const auto through = tree.crossings({-3, 0.123, 0.0457}, {3, 0.1, 0.07});
    QVERIFY(through.has_value());
    QCOMPARE(through->size(), std::size_t{2});
    QVERIFY(std::abs((*through)[0].along - 2.0 / 6) < 0.01);
    QVERIFY(std::abs((*through)[1].along - 4.0 / 6) < 0.01);
    QCOMPARE(tree.crossings({0.1, 0.2, 0.3}, {0.3, 0.2, 5})->size(), std::size_t{1});
    QCOMPARE(tree.crossings({0.1, 0.2, 0.3}, {0.3, 0.2, 0.4})->size(), std::size_t{0});
}

void SurfaceDistanceTest::a_segment_through_an_edge_is_said_to_touch() {
    const SurfaceTree tree(surfaces::cube(2));
    QVERIFY(!tree.crossings({0.5, 0.25, 0.5}, {0.5, 0.25, 2}).has_value()); // an edge of the grid
    QVERIFY(!tree.crossings({0.3, 0.2, 1}, {0.3, 0.2, 2}).has_value());     // begins on a face
    const auto clear = tree.crossings({0.3, 0.2, 1}, {0.3, 0.2, 2},
                                      [&](FaceId f) { return tree.triangle(f)[0][2] == 1; });
    QVERIFY(clear.has_value() && clear->empty());
}

void SurfaceDistanceTest::bounds_hold_the_exact_distance_data() {
    QTest::addColumn<double>("inner");
    QTest::addColumn<double>("shift");
    QTest::newRow("the same") << 1.0 << 0.0;
    QTest::newRow("smaller") << 0.9 << 0.0;
    QTest::newRow("1e-9 apart") << 1 - 1e-9 << 0.0;
    QTest::newRow("shifted") << 1.0 << 0.25;
}

void SurfaceDistanceTest::bounds_hold_the_exact_distance() {
    QFETCH(double, inner);
    QFETCH(double, shift);
    // Where faces are this much closer than they are long, a smaller tolerance needs pieces as
    // small as the distance.
    const double tolerance = (inner > 0.99 ? 1 : 1e-4) * std::max(1 - inner, shift) + 1e-15;
    const Mesh<3> a = surfaces::cube(3);
    Mesh<3> b = a;
    for (Vec<3>& x : b.points) {
        x = inner * x + Vec<3>(shift, 0, 0);
    }
    // The corner (1, 1, 1) moves farthest when shrunk, to sqrt(3) (1 - inner) inside.
    const double there = shift > 0 ? shift : std::sqrt(3.0) * (1 - inner);
    const SurfaceDistance d = surface_distance(a, b, tolerance);
    QVERIFY(d.there.converged && d.back.converged);
    QVERIFY(d.lower() <= there + 1e-15 && there - 1e-15 <= d.upper());
    QVERIFY(d.upper() - d.lower() <= tolerance);
}

void SurfaceDistanceTest::sees_a_peak_between_nodes_that_agree() {
    // A square of two triangles under a roof with its ridge in the middle: all nodes of the square
    // are on the roof, its middle is not.
    Mesh<3> flat, roof;
    for (const auto& x : {Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(1, 1, 0), Vec<3>(0, 1, 0)}) {
        flat.points.push_back(x);
        roof.points.push_back(x);
    }
    roof.points.push_back({0.5, 0.5, 0.1});
    surfaces::add_face(flat, {NodeId(0), NodeId(1), NodeId(2)});
    surfaces::add_face(flat, {NodeId(0), NodeId(2), NodeId(3)});
    for (int i = 0; i < 4; ++i) {
        surfaces::add_face(roof, {NodeId(i), NodeId((i + 1) % 4), NodeId(4)});
    }
    const DirectedDistance back = directed_distance(roof, flat, 1e-6);
    QVERIFY(std::abs(back.lower - 0.1) < 1e-12);
    QVERIFY((back.at - Vec<3>(0.5, 0.5, 0.1)).norm() < 1e-12);
    // From the square: the middle is 0.1 cos(slope) from the roof's four sides.
    const double expected = 0.1 * 0.5 / std::hypot(0.1, 0.5);
    const DirectedDistance there = directed_distance(flat, roof, 1e-6);
    QVERIFY(there.lower <= expected + 1e-12 && expected <= there.upper + 1e-12);
    QVERIFY(there.upper - there.lower <= 1e-6);
}

void SurfaceDistanceTest::differs_by_direction() {
    const Mesh<3> a = surfaces::sphere(6);
    const Mesh<3> b = surfaces::both(a, surfaces::sphere(2, 0.1, {5, 0, 0}));
    const SurfaceDistance d = surface_distance(a, b, 1e-6);
    QCOMPARE(d.there.upper, 0.0);
    QVERIFY(std::abs(d.back.lower - 4.1) < 0.02);
}

void SurfaceDistanceTest::is_not_fooled_by_samples() {
    // The chordal error of an icosphere against a finer one: random points never exceed the bound.
    const Mesh<3> coarse = surfaces::sphere(4), fine = surfaces::sphere(16);
    const DirectedDistance d = directed_distance(coarse, fine, 1e-5);
    QVERIFY(d.converged && d.lower > 0.01);
    const SurfaceTree tree(fine);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> number(0, 1);
    for (const Facet<3>& f : coarse.faces) {
        for (int i = 0; i < 5; ++i) {
            const double u = number(random), v = number(random) * (1 - u);
            const Vec<3> x = (1 - u - v) * coarse.points[f[0]] + u * coarse.points[f[1]] +
                             v * coarse.points[f[2]];
            QVERIFY(tree.distance(x) <= d.upper + 1e-14);
        }
    }
}

QTEST_APPLESS_MAIN(SurfaceDistanceTest)
#include "surface_distance_test.moc"
