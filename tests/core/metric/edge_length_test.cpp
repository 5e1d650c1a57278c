// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/edge_length.h"

#include <QTest>

using namespace ameco;

class EdgeLengthTest : public QObject {
    Q_OBJECT
private slots:
    void is_the_logarithmic_mean_of_the_end_lengths_data();
    void is_the_logarithmic_mean_of_the_end_lengths();
    void does_not_depend_on_the_direction();
    void lies_between_the_end_lengths();
    void is_smooth_where_series_and_quotient_meet();
    void is_zero_where_an_end_sees_none();
    void is_the_integral_of_a_geometrically_growing_size();
};

void EdgeLengthTest::is_the_logarithmic_mean_of_the_end_lengths_data() {
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("b");
    QTest::addColumn<double>("expected");
    QTest::newRow("equal") << 0.7 << 0.7 << 0.7;
    QTest::newRow("double") << 1.0 << 2.0 << 1 / std::log(2.0);
    QTest::newRow("half") << 1.0 << 0.5 << 0.5 / std::log(2.0);
    QTest::newRow("a million times") << 1.0 << 1e6 << 999999 / std::log(1e6);
    // 1 + d/2 - d^2/12 with d = 1e-6
    QTest::newRow("nearly equal") << 1.0 << 1.000001 << 1.0000004999999166667;
}

void EdgeLengthTest::is_the_logarithmic_mean_of_the_end_lengths() {
    QFETCH(const double, a);
    QFETCH(const double, b);
    QFETCH(const double, expected);
    QCOMPARE_LE(std::abs(edge_length(a, b) / expected - 1), 1e-15);
}

void EdgeLengthTest::does_not_depend_on_the_direction() {
    QVERIFY(edge_length(0.3, 17) == edge_length(17, 0.3));
}

void EdgeLengthTest::lies_between_the_end_lengths() {
    for (double b = 1; b < 1e12; b *= 1.7) {
        QCOMPARE_GE(edge_length(1, b), std::min(1.0, b));
        QCOMPARE_LE(edge_length(1, b), std::max(1.0, b));
    }
}

void EdgeLengthTest::is_smooth_where_series_and_quotient_meet() {
    const double below = edge_length(1, 1 + 0.99999e-4);
    const double above = edge_length(1, 1 + 1.00001e-4);
    QCOMPARE_LE(std::abs((above - below) / 2e-9 - 0.5), 1e-4);
}

void EdgeLengthTest::is_zero_where_an_end_sees_none() {
    QCOMPARE(edge_length(0, 1), 0.0);
    QCOMPARE(edge_length(0, 0), 0.0);
}

void EdgeLengthTest::is_the_integral_of_a_geometrically_growing_size() {
    // An edge of length 1 whose size goes from 0.5 to 0.1 as 0.5 * 0.2^t: midpoint rule on 1/h.
    const int n = 2000;
    double integral = 0;
    for (int k = 0; k < n; ++k) {
        integral += 1 / (0.5 * std::pow(0.2, (k + 0.5) / n)) / n;
    }
    QCOMPARE_LE(std::abs(edge_length(1 / 0.5, 1 / 0.1) / integral - 1), 1e-6);
}

QTEST_APPLESS_MAIN(EdgeLengthTest)
#include "edge_length_test.moc"
