// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/metric.h"

#include "tests/core/metric/reference.h"
#include "tests/core/metric/wide_reference.h"

#include <QTest>

#include <limits>

using namespace ameco;

namespace {

template <int D>
Metric<D> metric_with(const Vec<D>& sizes, const Mat<D>& directions) {
    Metric<D> metric;
    metric.sizes = sizes;
    metric.directions = directions;
    return metric;
}

template <int D>
void go_to_tensor_and_back(double ratio) {
    std::mt19937 random(1);
    for (int n = 0; n < 50; ++n) {
        Vec<D> sizes = Vec<D>::Constant(1e-3);
        sizes[0] /= ratio;
        sizes[D - 1] *= 1.5;
        const Metric<D> metric = metric_with<D>(sizes, reference::random_rotation<D>(random));
        const Metric<D> back = from_tensor<D>(to_tensor<D>(metric));
        // The smallest size has all its digits in the components, the largest loses the square of
        // the aspect ratio of them.
        QVERIFY(is_valid<D>(back));
        QCOMPARE_LE(std::abs(back.sizes[0] / sizes[0] - 1), 1e-14);
        QCOMPARE_LE(std::abs(back.sizes[D - 1] / sizes[D - 1] - 1), 1e-15 * ratio * ratio + 1e-14);
        if (ratio > 1) {
            const double cosine = back.directions.col(0).dot(metric.directions.col(0));
            QCOMPARE_LE(1 - std::abs(cosine), 1e-15);
        }
    }
}

} // namespace

class MetricTest : public QObject {
    Q_OBJECT
private slots:
    void measures_lengths_along_its_directions();
    void is_factored_by_its_length_factor();
    void has_a_tensor_with_rows_of_the_upper_triangle();
    void survives_its_tensor_data();
    void survives_its_tensor();
    void keeps_tiny_eigenvalues_of_a_graded_tensor();
    void is_not_made_from_what_is_not_positive_definite_data();
    void is_not_made_from_what_is_not_positive_definite();
};

void MetricTest::measures_lengths_along_its_directions() {
    std::mt19937 random(2);
    const Metric<3> metric =
        metric_with<3>({1e-6, 1e-3, 10}, reference::random_rotation<3>(random));
    for (int k = 0; k < 3; ++k) {
        const Vec<3> e = metric.sizes[k] * metric.directions.col(k);
        QCOMPARE_LE(std::abs(length<3>(metric, e) - 1), 1e-8);
    }
    QCOMPARE(aspect_ratio<3>(metric), 10 / 1e-6);
    QCOMPARE_LE(std::abs(density<3>(metric) * 1e-8 - 1), 1e-14);
}

void MetricTest::is_factored_by_its_length_factor() {
    std::mt19937 random(3);
    const Metric<3> metric = metric_with<3>({0.1, 1, 2}, reference::random_rotation<3>(random));
    const Vec<3> e(0.3, -0.4, 0.7);
    QCOMPARE_LE(std::abs((length_factor<3>(metric) * e).norm() - length<3>(metric, e)), 1e-14);
}

void MetricTest::has_a_tensor_with_rows_of_the_upper_triangle() {
    // M = sum of v v^T / h^2, by hand.
    const double r = std::sqrt(0.5);
    Mat<3> V;
    V << r, -r, 0, r, r, 0, 0, 0, 1;
    const Tensor<3> M = to_tensor<3>(metric_with<3>({0.5, 1, 2}, V));
    const Tensor<3> expected{2.5, 1.5, 0, 2.5, 0, 0.25};
    for (std::size_t k = 0; k < 6; ++k) {
        QCOMPARE_LE(std::abs(M[k] - expected[k]), 1e-15);
    }
    const Tensor<2> flat = to_tensor<2>(metric_with<2>({0.5, 1}, V.topLeftCorner<2, 2>()));
    QCOMPARE_LE(std::abs(flat[0] - 2.5) + std::abs(flat[1] - 1.5) + std::abs(flat[2] - 2.5), 2e-15);
}

void MetricTest::survives_its_tensor_data() {
    QTest::addColumn<double>("ratio");
    for (const double ratio : {1.0, 1e2, 1e4, 1e6}) {
        QTest::addRow("aspect ratio %g", ratio) << ratio;
    }
}

void MetricTest::survives_its_tensor() {
    QFETCH(const double, ratio);
    go_to_tensor_and_back<2>(ratio);
    go_to_tensor_and_back<3>(ratio);
}

void MetricTest::keeps_tiny_eigenvalues_of_a_graded_tensor() {
    // S B S with S = diag(1e9, 1, 1e-9) and B well conditioned: condition 1e36, and yet all there.
    const Tensor<3> M{4e18, 1e9, 0.5, 3, 1e-9, 2e-18};
    const Vec<3> sizes = from_tensor<3>(M).sizes;
    QCOMPARE_LE(reference::relative_difference<3>(sizes, wide::sizes_of_tensor<3>(M)), 1e-14);
}

void MetricTest::is_not_made_from_what_is_not_positive_definite_data() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    QTest::addColumn<QList<double>>("tensor");
    QTest::newRow("zero") << QList<double>{0, 0, 0, 0, 0, 0};
    QTest::newRow("rank 1") << QList<double>{1, 1, 1, 1, 1, 1};
    QTest::newRow("one zero on the diagonal") << QList<double>{1, 0, 0, 1, 0, 0};
    QTest::newRow("one negative eigenvalue") << QList<double>{1, 2, 0, 1, 0, 1};
    QTest::newRow("all negative") << QList<double>{-1, 0, 0, -1, 0, -1};
    QTest::newRow("not a number") << QList<double>{1, 0, nan, 1, 0, 1};
    QTest::newRow("infinite") << QList<double>{infinity, 0, 0, 1, 0, 1};
}

void MetricTest::is_not_made_from_what_is_not_positive_definite() {
    QFETCH(const QList<double>, tensor);
    Tensor<3> M;
    std::copy(tensor.begin(), tensor.end(), M.begin());
    const Metric<3> metric = from_tensor<3>(M);
    QVERIFY(metric.sizes.array().isNaN().all());
    QVERIFY(!is_valid<3>(metric));
}

QTEST_APPLESS_MAIN(MetricTest)
#include "metric_test.moc"
