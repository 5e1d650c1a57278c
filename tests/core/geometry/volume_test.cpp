// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/geometry/volume.h"

#include "core/geometry/sum.h"

#include <QTest>

#include <cmath>
#include <random>
#include <vector>

using namespace ameco;
using Triangle = std::array<Vec<2>, 3>;
using Tetrahedron = std::array<Vec<3>, 4>;

class VolumeTest : public QObject {
    Q_OBJECT
private slots:
    void is_positive_for_the_numbering_of_simplex_h();
    void stays_within_its_error_bound();
    void sums_lose_nothing();
    void sums_of_pieces_lose_nothing();
};

void VolumeTest::is_positive_for_the_numbering_of_simplex_h() {
    QCOMPARE(volume(Triangle{Vec<2>(0, 0), Vec<2>(2, 0), Vec<2>(0, 3)}).value, 3.0);
    QCOMPARE(volume(Triangle{Vec<2>(0, 0), Vec<2>(0, 3), Vec<2>(2, 0)}).value, -3.0);
    QCOMPARE(volume(Tetrahedron{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0, 2, 0), Vec<3>(0, 0, 3)})
                 .value,
             1.0);
    QCOMPARE(volume(Tetrahedron{Vec<3>(0, 0, 0), Vec<3>(0, 2, 0), Vec<3>(1, 0, 0), Vec<3>(0, 0, 3)})
                 .value,
             -1.0);
}

void VolumeTest::stays_within_its_error_bound() {
    // Long double has 11 bits more than double, enough to judge by.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int i = 0; i < 10000; ++i) {
        std::array<Vec<3>, 4> x;
        for (Vec<3>& xi : x) {
            xi = {number(random), number(random), 1e-9 * number(random)};
        }
        Eigen::Matrix<long double, 3, 3> edges;
        for (int k = 0; k < 3; ++k) {
            edges.col(k) = x[k + 1].cast<long double>() - x[0].cast<long double>();
        }
        const long double expected =
            edges(0, 0) * (edges(1, 1) * edges(2, 2) - edges(2, 1) * edges(1, 2)) -
            edges(0, 1) * (edges(1, 0) * edges(2, 2) - edges(2, 0) * edges(1, 2)) +
            edges(0, 2) * (edges(1, 0) * edges(2, 1) - edges(2, 0) * edges(1, 1));
        const Volume v = volume(x);
        QVERIFY(std::abs(static_cast<double>(v.value - expected / 6)) <=
                volume_error_bound * v.magnitude);
    }
}

void VolumeTest::sums_lose_nothing() {
    Sum sum;
    sum.add(1e100);
    sum.add(1);
    sum.add(-1e100);
    QCOMPARE(sum.value(), 1.0);
    Sum tenths;
    for (int i = 0; i < 10000000; ++i) {
        tenths.add(0.1);
    }
    QCOMPARE(tenths.value(), 1e6); // to the last bit; a plain loop is off by 1.6e-4
}

void VolumeTest::sums_of_pieces_lose_nothing() {
    Sum total;
    for (const double x : {1e60, 3.0, -1e60, 1e-30}) {
        Sum piece;
        piece.add(x);
        piece.add(1e-40);
        total.add(piece);
    }
    QCOMPARE(total.value(), 3.0);
}

QTEST_APPLESS_MAIN(VolumeTest)
#include "volume_test.moc"
