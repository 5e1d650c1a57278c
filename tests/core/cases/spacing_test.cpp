// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/spacing.h"

#include <cmath>

#include <QtTest>

using namespace ameco;

class SpacingTest : public QObject {
    Q_OBJECT
private slots:
    void layers_grow_until_they_are_as_large_as_allowed();
    void layers_keep_a_first_height_larger_than_that();
    void heights_of_a_nanometre_keep_their_digits();
    void the_filling_ratio_fills_the_length_data();
    void the_filling_ratio_fills_the_length();
    void nodes_follow_the_size();
    void nodes_of_a_constant_size_are_equidistant();
};

void SpacingTest::layers_grow_until_they_are_as_large_as_allowed() {
    const auto s = growing_layers(1, 2, 3, 5);
    const std::vector<double> expected{0, 1, 3, 6, 9, 12};
    QCOMPARE(s, expected);
}

void SpacingTest::layers_keep_a_first_height_larger_than_that() {
    const std::vector<double> expected{0, 4, 8};
    QCOMPARE(growing_layers(4, 1.5, 3, 2), expected);
}

void SpacingTest::heights_of_a_nanometre_keep_their_digits() {
    const auto s = growing_layers(1e-9, 1.1, 1, 50);
    for (std::size_t k = 0; k < 50; ++k) {
        const double height = s[k + 1] - s[k];
        QVERIFY(std::abs(height / (1e-9 * std::pow(1.1, k)) - 1) < 1e-13);
    }
}

void SpacingTest::the_filling_ratio_fills_the_length_data() {
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("length");
    QTest::addColumn<int>("n");
    QTest::newRow("growing") << 1e-3 << 6.46 << 90;
    QTest::newRow("one layer") << 2.0 << 5.0 << 1;
    QTest::newRow("constant") << 0.5 << 5.0 << 10;
    QTest::newRow("shrinking") << 1.0 << 2.0 << 10;
    QTest::newRow("tiny first height") << 1e-12 << 10.0 << 20;
}

void SpacingTest::the_filling_ratio_fills_the_length() {
    QFETCH(double, height);
    QFETCH(double, length);
    QFETCH(int, n);
    const double r = filling_ratio(height, length, static_cast<std::size_t>(n));
    double sum = 0;
    for (int k = 1; k <= n; ++k) {
        sum += height * std::pow(r, k);
    }
    QVERIFY(std::abs(sum / length - 1) < 1e-12);
}

void SpacingTest::nodes_follow_the_size() {
    // Sizes that grow linearly from 0.01 give intervals in geometric progression.
    const auto s = equidistribute(1, 20, [](double x) { return 0.01 + 0.2 * x; });
    QCOMPARE(s.size(), 21u);
    QCOMPARE(s.front(), 0.0);
    QCOMPARE(s.back(), 1.0);
    const double ratio = std::pow(21, 1 / 20.0); // size at the end over size at the start, 20 steps
    for (std::size_t i = 2; i < s.size(); ++i) {
        QVERIFY(std::abs((s[i] - s[i - 1]) / (s[i - 1] - s[i - 2]) / ratio - 1) < 1e-3);
    }
}

void SpacingTest::nodes_of_a_constant_size_are_equidistant() {
    const auto s = equidistribute(2, 8, [](double) { return 0.3; });
    for (std::size_t i = 0; i < s.size(); ++i) {
        QVERIFY(std::abs(s[i] - 0.25 * static_cast<double>(i)) < 1e-12);
    }
}

QTEST_APPLESS_MAIN(SpacingTest)
#include "spacing_test.moc"
