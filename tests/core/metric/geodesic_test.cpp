// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/geodesic.h"

#include "tests/core/metric/reference.h"
#include "tests/core/metric/wide_reference.h"

#include <QTest>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

using namespace ameco;

namespace {

constexpr int samples = 40;

template <int D>
Metric<D> random_metric(std::mt19937& random, double ratio) {
    std::uniform_real_distribution<double> uniform(0, 1);
    Metric<D> metric;
    for (int k = 0; k < D; ++k) {
        metric.sizes[k] = std::pow(ratio, -uniform(random));
    }
    metric.sizes[0] = 1 / ratio;
    std::sort(metric.sizes.begin(), metric.sizes.end());
    metric.directions = reference::random_rotation<D>(random);
    return metric;
}

/// Two metrics of that aspect ratio whose directions differ by up to `angle` [rad].
template <int D>
std::array<Metric<D>, 2> pair(std::mt19937& random, double ratio, double angle) {
    const std::vector<Metric<D>> metrics = reference::fan<D>(random, ratio, angle / 2);
    return {metrics[0], metrics[1]};
}

/// M -> A M A^T, equation (20).
template <int D>
Metric<D> moved(const Mat<D>& A, const Metric<D>& metric) {
    const Mat<D> G = A.transpose().inverse() * metric.directions * metric.sizes.asDiagonal();
    const Eigen::JacobiSVD<Mat<D>> svd(G, Eigen::ComputeFullU);
    Metric<D> result;
    result.sizes = svd.singularValues().reverse();
    result.directions = svd.matrixU().rowwise().reverse();
    return result;
}

template <int D>
Mat<D> random_matrix(std::mt19937& random) {
    std::normal_distribution<double> normal;
    Mat<D> A;
    for (int i = 0; i < D * D; ++i) {
        A.data()[i] = normal(random);
    }
    return A + 3 * Mat<D>::Identity(); // far enough from a singular one
}

template <int D>
Tangent<D> random_tangent(std::mt19937& random) {
    const Mat<D> A = random_matrix<D>(random);
    return {A + A.transpose() - 6 * Mat<D>::Identity()};
}

template <int D>
double difference(const Tangent<D>& a, const Tangent<D>& b) {
    return (a.X - b.X).norm();
}

template <int D>
void check_inverses() {
    std::mt19937 random(1);
    for (int n = 0; n < samples; ++n) {
        const Metric<D> a = random_metric<D>(random, std::pow(10, n % 3));
        const Metric<D> b = random_metric<D>(random, std::pow(10, n % 3));
        QCOMPARE_LE(invariant_distance(exp_map(a, log_map(a, b)), b), 1e-10);
        const Tangent<D> t = random_tangent<D>(random);
        QCOMPARE_LE(difference(log_map(a, exp_map(a, t)), t), 1e-10);
    }
    for (int n = 0; n < samples; ++n) { // thin, and nearly of the same directions
        const auto [a, b] = pair<D>(random, 1e6, 1e-6);
        QCOMPARE_LE(invariant_distance(exp_map(a, log_map(a, b)), b), 1e-8);
    }
}

template <int D>
void check_linear_maps() {
    std::mt19937 random(2);
    for (int n = 0; n < samples; ++n) {
        const Metric<D> a = random_metric<D>(random, 30);
        const Metric<D> b = random_metric<D>(random, 30);
        const Mat<D> A = random_matrix<D>(random);
        const double d = invariant_distance(a, b);
        QCOMPARE_LE(std::abs(invariant_distance(moved(A, a), moved(A, b)) - d), 1e-9);
        const Mat<D> W_1 = to_matrix(a, random_tangent<D>(random));
        const Mat<D> W_2 = to_matrix(a, random_tangent<D>(random));
        const double product = scalar_product(to_tangent(a, W_1), to_tangent(a, W_2));
        const Metric<D> c = moved(A, a);
        const double after = scalar_product(to_tangent<D>(c, A * W_1 * A.transpose()),
                                            to_tangent<D>(c, A * W_2 * A.transpose()));
        QCOMPARE_LE(std::abs(after - product), 1e-7 * (1 + std::abs(product)));
    }
}

template <int D>
void check_formulas() {
    std::mt19937 random(3);
    for (int n = 0; n < samples; ++n) {
        const Metric<D> M = random_metric<D>(random, 10);
        const Tangent<D> t = random_tangent<D>(random);
        // M^(1/2), M^(-1/2) by the definition, tensors formed.
        const Mat<D>& V = M.directions;
        const Mat<D> root = V * M.sizes.cwiseInverse().asDiagonal() * V.transpose();
        const Mat<D> inverse_root = V * M.sizes.asDiagonal() * V.transpose();
        const Mat<D> W = to_matrix(M, t);
        const Eigen::SelfAdjointEigenSolver<Mat<D>> eigen(inverse_root * W * inverse_root);
        const Mat<D> exponential = root * eigen.eigenvectors() *
                                   eigen.eigenvalues().array().exp().matrix().asDiagonal() *
                                   eigen.eigenvectors().transpose() * root;
        const Mat<D> F = length_factor(exp_map(M, t));
        QCOMPARE_LE((F.transpose() * F - exponential).norm(), 1e-11 * exponential.norm());
        QCOMPARE_LE(difference(to_tangent(M, W), t), 1e-11);
        const Mat<D> inverse_M = inverse_root * inverse_root;
        QCOMPARE_LE(std::abs((inverse_root * W * inverse_M * W * inverse_root).trace() -
                             scalar_product(t, t)),
                    1e-9);
    }
}

template <int D>
void check_geodesics() {
    std::mt19937 random(4);
    for (int n = 0; n < samples; ++n) {
        const Metric<D> a = random_metric<D>(random, 100);
        const Metric<D> b = random_metric<D>(random, 100);
        const double d = invariant_distance(a, b);
        QCOMPARE_LE(std::abs(std::sqrt(scalar_product(log_map(a, b), log_map(a, b))) - d), 1e-11);
        for (const double t : {0.1, 0.5, 0.8}) {
            const Metric<D> between = geodesic(a, b, t);
            QCOMPARE_LE(std::abs(invariant_distance(a, between) - t * d), 1e-9);
            QCOMPARE_LE(std::abs(invariant_distance(between, b) - (1 - t) * d), 1e-9);
        }
        const Metric<D> c = random_metric<D>(random, 100); // any way round is longer
        QCOMPARE_LE(d, invariant_distance(a, c) + invariant_distance(c, b) + 1e-12);
    }
}

template <int D>
void check_symmetry(double ratio) {
    std::mt19937 random(5);
    for (int n = 0; n < samples; ++n) {
        const Metric<D> a = random_metric<D>(random, ratio);
        const Metric<D> b = random_metric<D>(random, ratio);
        const double d = invariant_distance(a, b);
        const double tolerance = 1e-15 * ratio * d + 1e-13;
        QCOMPARE_LE(std::abs(invariant_distance(b, a) - d), tolerance);
        QCOMPARE_LE(std::abs(invariant_distance(inverse(a), inverse(b)) - d), tolerance);
        QCOMPARE_LE(invariant_distance(a, a), 1e-14 * ratio);
    }
}

template <int D>
void compare_with_fifty_digits(double ratio) {
    std::mt19937 random(6);
    for (const double angle : {1e-8, 1e-5, 1e-2, 0.3, 3.0}) {
        for (int n = 0; n < 10; ++n) {
            const auto [a, b] = pair<D>(random, ratio, angle);
            const Tangent<D> exact = wide::log_map(a, b);
            QCOMPARE_LE(difference(log_map(a, b), exact), 2e-15 * ratio + 1e-13);
            QCOMPARE_LE(std::abs(invariant_distance(a, b) - exact.X.norm()), 2e-15 * ratio + 1e-13);
        }
    }
}

} // namespace

class GeodesicTest : public QObject {
    Q_OBJECT
private slots:
    void exponential_and_logarithm_are_inverses();
    void distance_and_scalar_product_do_not_change_under_linear_maps();
    void maps_and_scalar_product_are_those_of_the_paper();
    void geodesics_are_the_shortest_ways();
    void distance_is_symmetric_and_does_not_change_under_inversion_data();
    void distance_is_symmetric_and_does_not_change_under_inversion();
    void distance_of_metrics_with_common_directions_is_that_of_their_logarithms();
    void logarithm_agrees_with_fifty_digits_data();
    void logarithm_agrees_with_fifty_digits();
};

void GeodesicTest::exponential_and_logarithm_are_inverses() {
    check_inverses<2>();
    check_inverses<3>();
}

void GeodesicTest::distance_and_scalar_product_do_not_change_under_linear_maps() {
    check_linear_maps<2>();
    check_linear_maps<3>();
}

void GeodesicTest::maps_and_scalar_product_are_those_of_the_paper() {
    check_formulas<2>();
    check_formulas<3>();
}

void GeodesicTest::geodesics_are_the_shortest_ways() {
    check_geodesics<2>();
    check_geodesics<3>();
}

void GeodesicTest::distance_is_symmetric_and_does_not_change_under_inversion_data() {
    QTest::addColumn<double>("ratio");
    for (const double ratio : {1.0, 1e2, 1e4, 1e6, 1e8}) {
        QTest::addRow("aspect ratio %g", ratio) << ratio;
    }
}

void GeodesicTest::distance_is_symmetric_and_does_not_change_under_inversion() {
    QFETCH(const double, ratio);
    check_symmetry<2>(ratio);
    check_symmetry<3>(ratio);
}

void GeodesicTest::distance_of_metrics_with_common_directions_is_that_of_their_logarithms() {
    std::mt19937 random(7);
    Metric<3> a = random_metric<3>(random, 1e6);
    Metric<3> b = a;
    a.sizes = Vec<3>(1e-6, 1, 1);
    b.sizes = Vec<3>(1e-6, 1e-3, 2);
    const double expected = 2 * std::hypot(std::log(1e3), std::log(2.0));
    QCOMPARE_LE(std::abs(invariant_distance(a, b) - expected), 1e-9);
}

void GeodesicTest::logarithm_agrees_with_fifty_digits_data() {
    distance_is_symmetric_and_does_not_change_under_inversion_data();
}

void GeodesicTest::logarithm_agrees_with_fifty_digits() {
    QFETCH(const double, ratio);
    compare_with_fifty_digits<2>(ratio);
    compare_with_fifty_digits<3>(ratio);
}

QTEST_APPLESS_MAIN(GeodesicTest)
#include "geodesic_test.moc"
