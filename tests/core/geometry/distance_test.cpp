// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/geometry/distance.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace ameco;
using Segment = std::array<Vec<2>, 2>;
using Triangle = std::array<Vec<3>, 3>;

namespace {

/// Distance to the nearest of many points of the triangle.
double sampled_distance(const Vec<3>& p, const Triangle& t, int n) {
    double nearest = (p - t[0]).norm();
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; i + j <= n; ++j) {
            const Vec<3> x = t[0] + (t[1] - t[0]) * i / n + (t[2] - t[0]) * j / n;
            nearest = std::min(nearest, (p - x).norm());
        }
    }
    return nearest;
}

} // namespace

class DistanceTest : public QObject {
    Q_OBJECT
private slots:
    void to_a_segment_is_to_its_nearest_point();
    void to_a_triangle_knows_inside_edges_and_corners_data();
    void to_a_triangle_knows_inside_edges_and_corners();
    void to_a_triangle_agrees_with_samples();
    void to_flat_things_is_to_what_is_left_of_them();
    void the_closest_point_is_at_that_distance();
};

void DistanceTest::to_a_segment_is_to_its_nearest_point() {
    const Segment s{Vec<2>(0, 0), Vec<2>(4, 0)};
    QCOMPARE(distance(Vec<2>(1, 2), s), 2.0);
    QCOMPARE(distance(Vec<2>(1, -2), s), 2.0);
    QCOMPARE(distance(Vec<2>(-3, 4), s), 5.0);
    QCOMPARE(distance(Vec<2>(7, -4), s), 5.0);
    QCOMPARE(distance(Vec<2>(3, 0), s), 0.0);
}

void DistanceTest::to_a_triangle_knows_inside_edges_and_corners_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::addColumn<double>("expected");
    QTest::newRow("above the inside") << 1.0 << 1.0 << 2.0 << 2.0;
    QTest::newRow("below the inside") << 1.0 << 1.0 << -2.0 << 2.0;
    QTest::newRow("in the triangle") << 1.0 << 1.0 << 0.0 << 0.0;
    QTest::newRow("beside an edge") << 2.0 << -3.0 << 4.0 << 5.0;
    QTest::newRow("beside the long edge") << 4.0 << 4.0 << 0.0 << 2 * std::sqrt(2.0);
    QTest::newRow("beyond a corner") << -2.0 << -3.0 << 6.0 << 7.0;
}

void DistanceTest::to_a_triangle_knows_inside_edges_and_corners() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    QFETCH(double, expected);
    const Triangle t{Vec<3>(0, 0, 0), Vec<3>(4, 0, 0), Vec<3>(0, 4, 0)};
    QCOMPARE(distance(Vec<3>(x, y, z), t), expected);
    QCOMPARE(distance(Vec<3>(x, y, z), Triangle{t[0], t[2], t[1]}), expected);
}

void DistanceTest::to_a_triangle_agrees_with_samples() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto point = [&] { return Vec<3>(number(random), number(random), number(random)); };
    constexpr int n = 60;
    for (int i = 0; i < 300; ++i) {
        const Triangle t{point(), point(), point()};
        const Vec<3> p = 2 * point();
        const double exact = distance(p, t);
        const double sampled = sampled_distance(p, t, n);
        const double spacing = ((t[1] - t[0]).norm() + (t[2] - t[0]).norm()) / n;
        QVERIFY(exact <= sampled + 1e-12);
        QVERIFY(exact >= sampled - spacing);
    }
}

void DistanceTest::to_flat_things_is_to_what_is_left_of_them() {
    QCOMPARE(distance(Vec<2>(3, 4), Segment{Vec<2>(0, 0), Vec<2>(0, 0)}), 5.0);
    const Triangle line{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(4, 0, 0)};
    QCOMPARE(distance(Vec<3>(2, 3, 0), line), 3.0);
    QCOMPARE(distance(Vec<3>(7, 0, 4), line), 5.0);
    const Triangle point{Vec<3>(1, 1, 1), Vec<3>(1, 1, 1), Vec<3>(1, 1, 1)};
    QCOMPARE(distance(Vec<3>(1, 4, 5), point), 5.0);
}

void DistanceTest::the_closest_point_is_at_that_distance() {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto point = [&] { return Vec<3>(number(random), number(random), number(random)); };
    for (int i = 0; i < 300; ++i) {
        Triangle t{point(), point(), point()};
        if (i % 3 == 0) { // a height of rounding only
            t[2] = (t[0] + t[1]) / 2;
        }
        const Vec<3> p = 2 * point();
        const Vec<3> q = closest_point(p, t);
        QVERIFY(std::abs((p - q).norm() - distance(p, t)) < 1e-12);
        QVERIFY(distance(q, t) < 1e-12);
    }
    QCOMPARE(closest_point({1, 4, 5}, {Vec<3>(1, 1, 1), Vec<3>(1, 1, 1), Vec<3>(1, 1, 1)}),
             Vec<3>(1, 1, 1));
}

QTEST_APPLESS_MAIN(DistanceTest)
#include "distance_test.moc"
