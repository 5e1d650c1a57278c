// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/limited_metric.h"

#include <QTest>

#include <cmath>
#include <random>

#include <Eigen/Geometry>

using namespace ameco;

namespace {

Metric<3> random_metric(std::mt19937& random, double decades) {
    std::uniform_real_distribution<double> exponent(-decades, 0), part(-1, 1);
    Metric<3> m;
    m.sizes << std::pow(10, exponent(random)), std::pow(10, exponent(random)),
        std::pow(10, exponent(random));
    std::sort(m.sizes.data(), m.sizes.data() + 3);
    const Eigen::Quaterniond q(part(random), part(random), part(random), part(random));
    m.directions = q.normalized().toRotationMatrix();
    return m;
}

} // namespace

class LimitedMetricTest : public QObject {
    Q_OBJECT
private slots:
    void what_is_within_reach_is_the_target() {
        Metric<3> from;
        Metric<3> target;
        target.sizes << 0.6, 1.0, 1.9;
        double excess = 0;
        QVERIFY(limited_metric(from, target, 2, excess) == target);
        QCOMPARE(excess, 1.0);
    }

    void no_vector_becomes_much_longer_or_shorter() {
        std::mt19937 random(5);
        std::normal_distribution<double> normal;
        for (int n = 0; n < 2000; ++n) {
            const Metric<3> from = random_metric(random, 5), target = random_metric(random, 5);
            double excess = 0;
            const Metric<3> limited = limited_metric(from, target, 2, excess);
            QVERIFY(is_valid(limited));
            QVERIFY(excess >= 1);
            // In the unit ball of `from`, where all vectors have length 1.
            Vec<3> y(normal(random), normal(random), normal(random));
            const Vec<3> e = from.directions * from.sizes.asDiagonal() * y.normalized();
            const double ratio = length(limited, e) / length(from, e);
            QVERIFY2(ratio <= 2.01 && ratio >= 1 / 2.01, std::to_string(ratio).c_str());
        }
    }

    void steps_lead_to_the_target() {
        Metric<2> at;
        at.sizes << 1, 1;
        Metric<2> target;
        target.sizes << 1e-6, 0.5;
        target.directions << 0.8, 0.6, -0.6, 0.8;
        int steps = 0;
        for (double excess = 2; excess > 1 && steps < 100; ++steps) {
            at = limited_metric(at, target, 2, excess);
        }
        QCOMPARE(steps, 20); // 2^20 > 1e6
        QVERIFY(at == target);
    }
};

QTEST_APPLESS_MAIN(LimitedMetricTest)
#include "limited_metric_test.moc"
