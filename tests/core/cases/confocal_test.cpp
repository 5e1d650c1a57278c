// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/confocal.h"

#include <cmath>

#include <QtTest>

using namespace ameco;

namespace {

/// Difference of the distances to the two foci: constant on a hyperbola.
double focal_difference(const Vec<2>& p, double f) {
    return (p - Vec<2>(-f, 0)).norm() - (p - Vec<2>(f, 0)).norm();
}

} // namespace

class ConfocalTest : public QObject {
    Q_OBJECT
private slots:
    void stays_on_a_hyperbola_at_the_distance_asked_for_data();
    void stays_on_a_hyperbola_at_the_distance_asked_for();
    void is_straight_on_the_chord_to_the_bit();
    void mirrors_to_the_bit();
    void keeps_the_digits_of_tiny_distances();
    void ends_on_its_ellipse();
};

void ConfocalTest::stays_on_a_hyperbola_at_the_distance_asked_for_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("z");
    QTest::addColumn<double>("distance");
    for (const double distance : {1e-3, 0.1, 5.0}) {
        QTest::addRow("over the middle, %g", distance) << 0.0 << 0.05 << distance;
        QTest::addRow("near the nose, %g", distance) << -0.502 << 0.003 << distance;
        QTest::addRow("below the tail, %g", distance) << 0.4999 << -0.0004 << distance;
        QTest::addRow("far away, %g", distance) << 2.0 << 1.0 << distance;
    }
}

void ConfocalTest::stays_on_a_hyperbola_at_the_distance_asked_for() {
    QFETCH(double, x);
    QFETCH(double, z);
    QFETCH(double, distance);
    const Vec<2> foot(x, z);
    const Vec<2> offset = ConfocalColumn(foot, 0.5).offset(distance);
    QVERIFY(std::abs(offset.norm() / distance - 1) < 1e-13);
    QVERIFY(std::abs(focal_difference(foot + offset, 0.5) - focal_difference(foot, 0.5)) < 1e-13);
    QVERIFY((foot + offset).norm() > foot.norm() - 1e-15); // outwards
    QVERIFY(z * offset[1] > 0);
}

void ConfocalTest::is_straight_on_the_chord_to_the_bit() {
    for (const double x : {-0.51, 0.5003, 3.0}) {
        const ConfocalColumn column({x, 0}, 0.5);
        for (const double distance : {1e-9, 1e-3, 6.0}) {
            const Vec<2> offset = column.offset(distance);
            QCOMPARE(offset[1], 0.0);
            QVERIFY(std::abs(offset[0] / std::copysign(distance, x) - 1) < 1e-14);
        }
    }
}

void ConfocalTest::mirrors_to_the_bit() {
    for (const double distance : {1e-7, 0.3}) {
        const Vec<2> above = ConfocalColumn({0.1, 0.04}, 0.5).offset(distance);
        const Vec<2> below = ConfocalColumn({0.1, -0.04}, 0.5).offset(distance);
        QCOMPARE(below[0], above[0]);
        QCOMPARE(below[1], -above[1]);
    }
}

void ConfocalTest::keeps_the_digits_of_tiny_distances() {
    const ConfocalColumn column({0.2, 0.05}, 0.5);
    const Vec<2> direction = column.offset(1e-12) / 1e-12;
    for (const double distance : {1e-9, 1e-10, 1e-11}) {
        QVERIFY((column.offset(distance) / distance - direction).norm() < 1e-7);
        QVERIFY(std::abs(column.offset(distance).norm() / distance - 1) < 1e-13);
    }
}

void ConfocalTest::ends_on_its_ellipse() {
    const double f = 0.5, radius = 6;
    for (const Vec<2>& foot : {Vec<2>(0, 0.05), Vec<2>(-0.51, 0), Vec<2>(0.45, -0.01)}) {
        const ConfocalColumn column(foot, f);
        const Vec<2> end = foot + column.offset(column.distance_to_ellipse(radius));
        const double a2 = radius * radius + f * f;
        QVERIFY(std::abs(end[0] * end[0] / a2 + end[1] * end[1] / (radius * radius) - 1) < 1e-12);
    }
}

QTEST_APPLESS_MAIN(ConfocalTest)
#include "confocal_test.moc"
