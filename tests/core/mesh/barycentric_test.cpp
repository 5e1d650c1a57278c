// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/barycentric.h"

#include "core/geometry/volume.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace ameco;

namespace {

/// Simplices of any aspect ratio up to that of `flat`, with positive volume.
template <int D>
std::array<Vec<D>, D + 1> random_simplex(std::mt19937& random, double flat) {
    std::uniform_real_distribution<double> number(0, 1);
    std::array<Vec<D>, D + 1> x;
    do {
        for (Vec<D>& corner : x) {
            for (int i = 0; i < D; ++i) {
                corner[i] = number(random);
            }
            corner[D - 1] *= flat;
        }
    } while (volume(x).value < 0.01 * flat);
    return x;
}

template <int D>
Vec<D> mean_of(const std::array<Vec<D>, D + 1>& x, const std::array<double, D + 1>& w) {
    Vec<D> p = Vec<D>::Zero();
    for (std::size_t i = 0; i <= D; ++i) {
        p += w[i] * x[i];
    }
    return p;
}

template <int D>
void gives_the_weights_of_a_mean(double flat) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-0.5, 1);
    for (int run = 0; run < 200; ++run) {
        const auto x = random_simplex<D>(random, flat);
        std::array<double, D + 1> w;
        w[D] = 1;
        for (std::size_t i = 0; i < D; ++i) {
            w[i] = number(random);
            w[D] -= w[i];
        }
        const auto found = barycentric<D>(x, mean_of<D>(x, w));
        double sum = 0;
        for (std::size_t i = 0; i <= D; ++i) {
            QCOMPARE_LE(std::abs(found[i] - w[i]), 1e-11);
            sum += found[i];
        }
        QCOMPARE_LE(std::abs(sum - 1), 1e-14);
    }
}

/// d w_i / d e by the gradient and by a difference, which is exact for linear functions.
template <int D>
void gradients_are_differences() {
    std::mt19937 random(4);
    for (int run = 0; run < 50; ++run) {
        const auto x = random_simplex<D>(random, 1);
        const auto gradients = scaled_gradients(x);
        const double scale = volume(x).value * (D == 2 ? 2 : 6);
        const Vec<D> inside = mean_of<D>(x, [] {
            std::array<double, D + 1> w;
            w.fill(1.0 / (D + 1));
            return w;
        }());
        const auto here = barycentric<D>(x, inside);
        for (int k = 0; k < D; ++k) {
            const auto there = barycentric<D>(x, Vec<D>(inside + 0.125 * Vec<D>::Unit(k)));
            for (std::size_t i = 0; i <= D; ++i) {
                QCOMPARE_LE(std::abs(gradients[i][k] / scale - (there[i] - here[i]) / 0.125),
                            1e-10);
            }
        }
    }
}

} // namespace

class BarycentricTest : public QObject {
    Q_OBJECT
private slots:
    void gives_the_weights_of_a_mean_data();
    void gives_the_weights_of_a_mean();
    void is_negative_outside();
    void has_the_gradients_of_linear_functions();
};

void BarycentricTest::gives_the_weights_of_a_mean_data() {
    QTest::addColumn<double>("flat");
    QTest::newRow("round") << 1.0;
    QTest::newRow("aspect ratio 1e4") << 1e-4;
    QTest::newRow("aspect ratio 1e6, of height 1e-6") << 1e-6;
}

void BarycentricTest::gives_the_weights_of_a_mean() {
    QFETCH(double, flat);
    ::gives_the_weights_of_a_mean<2>(flat);
    ::gives_the_weights_of_a_mean<3>(flat);
}

void BarycentricTest::is_negative_outside() {
    const std::array<Vec<2>, 3> x{Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(0, 1)};
    const auto w = barycentric<2>(x, Vec<2>(1, 1));
    QCOMPARE(w[0], -1.0);
    QCOMPARE(w[1], 1.0);
    QCOMPARE(w[2], 1.0);
}

void BarycentricTest::has_the_gradients_of_linear_functions() {
    gradients_are_differences<2>();
    gradients_are_differences<3>();
}

QTEST_APPLESS_MAIN(BarycentricTest)
#include "barycentric_test.moc"
