// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/means.h"

#include "core/base/error.h"
#include "core/metric/element_metric.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/metric/reference.h"
#include "tests/core/metric/wide_reference.h"

#include <QTest>

using namespace ameco;

namespace {

/// Angle [rad] between two unit vectors that may point in opposite directions.
template <int D>
double angle_between(const Vec<D>& a, const Vec<D>& b) {
    return (a - a.dot(b) * b).norm();
}

template <int D>
void compare_with_fifty_digits(Mean mean, double ratio) {
    std::mt19937 random(1);
    for (const double angle : {1e-6, 1e-3, 0.3}) {
        const Mesh<D> mesh = reference::star_of(reference::fan<D>(random, ratio, angle));
        std::vector<Metric<D>> metrics(mesh.elements.size());
        element_metrics<D>(mesh, ElementId(0), metrics);
        const Metric<D> found = mean_of<D>(metrics, mean);
        const Metric<D> exact = wide::mean<D>(reference::all_corners(mesh), mean);
        QCOMPARE_LE(reference::relative_difference<D>(found.sizes, exact.sizes), 1e-8);
        QCOMPARE_LE(angle_between<D>(found.directions.col(0), exact.directions.col(0)), 1e-9);
    }
}

} // namespace

class MeansTest : public QObject {
    Q_OBJECT
private slots:
    void have_names();
    void agree_with_fifty_digits_data();
    void agree_with_fifty_digits();
    void of_a_node_are_those_of_its_elements();
    void are_valid_for_any_valid_metrics_data();
    void are_valid_for_any_valid_metrics();
    void blended_is_the_corrected_mean_in_layers_data();
    void blended_is_the_corrected_mean_in_layers();
    void blended_sees_that_elements_at_random_have_no_direction();
    void blended_sizes_lie_between_the_two_means();
    void say_which_node_does_not_converge();
};

void MeansTest::have_names() {
    for (const Mean mean : all_means) {
        QVERIFY(mean_from_name(name(mean)) == mean);
    }
    QVERIFY(!mean_from_name("median"));
}

void MeansTest::agree_with_fifty_digits_data() {
    QTest::addColumn<int>("mean");
    QTest::addColumn<double>("ratio");
    for (const Mean mean : all_means) {
        if (!comes_from_sums(mean) || mean == Mean::blended) {
            continue; // geodesic_mean_test; of blended, both ingredients are tested
        }
        for (const double ratio : {1.0, 1e2, 1e4, 1e6}) {
            QTest::addRow("%s, aspect ratio %g", name(mean).data(), ratio)
                << static_cast<int>(mean) << ratio;
        }
    }
}

void MeansTest::agree_with_fifty_digits() {
    QFETCH(const int, mean);
    QFETCH(const double, ratio);
    compare_with_fifty_digits<2>(static_cast<Mean>(mean), ratio);
    compare_with_fifty_digits<3>(static_cast<Mean>(mean), ratio);
}

void MeansTest::of_a_node_are_those_of_its_elements() {
    std::mt19937 random(2);
    const Mesh<3> mesh = reference::star_of(reference::fan<3>(random, 1e3, 0.01));
    std::vector<Metric<3>> metrics(mesh.elements.size());
    element_metrics<3>(mesh, ElementId(0), metrics);
    for (const Mean mean : all_means) {
        if (mean == Mean::geodesic_fixed_step) {
            continue; // may not converge
        }
        QVERIFY(nodal_metric(mesh, mean)[NodeId(0)] == mean_of<3>(metrics, mean));
    }
}

void MeansTest::are_valid_for_any_valid_metrics_data() {
    QTest::addColumn<int>("mean");
    for (const Mean mean : all_means) {
        if (mean != Mean::geodesic_fixed_step) {
            QTest::addRow("%s", name(mean).data()) << static_cast<int>(mean);
        }
    }
}

void MeansTest::are_valid_for_any_valid_metrics() {
    // Directions at random and sizes from 1e-9 to 1: far worse than any mesh.
    QFETCH(const int, mean);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> exponent(-9, 0);
    for (int n = 0; n < 200; ++n) {
        std::vector<Metric<3>> metrics(1 + static_cast<std::size_t>(n) % 24);
        for (Metric<3>& metric : metrics) {
            for (double& h : metric.sizes) {
                h = std::pow(10, exponent(random));
            }
            std::sort(metric.sizes.begin(), metric.sizes.end());
            metric.directions = reference::random_rotation<3>(random);
        }
        const Metric<3> found = mean_of<3>(metrics, static_cast<Mean>(mean));
        QVERIFY(is_valid<3>(found));
        QVERIFY(std::is_sorted(found.sizes.begin(), found.sizes.end()));
    }
}

void MeansTest::blended_is_the_corrected_mean_in_layers_data() {
    QTest::addColumn<double>("ratio");
    for (const double ratio : {10.0, 1e3, 1e6}) {
        QTest::addRow("aspect ratio %g", ratio) << ratio;
    }
}

void MeansTest::blended_is_the_corrected_mean_in_layers() {
    // The fan's height, whatever the turn; (8) swells it.
    QFETCH(const double, ratio);
    std::mt19937 random(5);
    for (const double angle : {0.0, 0.1, 0.5}) {
        const std::vector<Metric<3>> metrics = reference::fan<3>(random, ratio, angle);
        const Vec<3> corrected = mean_of<3>(metrics, Mean::corrected).sizes;
        QCOMPARE(mean_of<3>(metrics, Mean::blended).sizes[0], corrected[0]);
    }
    // A needle: both small sizes.
    std::vector<Metric<3>> needles;
    for (Metric<3> needle : reference::fan<3>(random, 1, 0.5)) {
        needle.sizes = Vec<3>(1 / ratio, 1.1 / ratio, 2);
        needles.push_back(needle);
    }
    const Vec<3> sizes = mean_of<3>(needles, Mean::blended).sizes;
    QCOMPARE_LE(sizes[1], 1.1 / ratio * (1 + 1e-12));
}

void MeansTest::blended_sees_that_elements_at_random_have_no_direction() {
    std::mt19937 random(6);
    std::vector<Metric<3>> metrics(24);
    for (Metric<3>& metric : metrics) {
        metric.sizes = Vec<3>(0.7, 1, 1.4);
        metric.directions = reference::random_rotation<3>(random);
    }
    QCOMPARE_GT(aspect_ratio(mean_of<3>(metrics, Mean::corrected)), 1.99);
    QCOMPARE_LT(aspect_ratio(mean_of<3>(metrics, Mean::interpolation)), 1.3);
    QCOMPARE_LT(aspect_ratio(mean_of<3>(metrics, Mean::blended)), 1.4);
}

void MeansTest::blended_sizes_lie_between_the_two_means() {
    std::mt19937 random(7);
    for (int n = 0; n < 200; ++n) {
        const auto metrics = reference::fan<3>(random, std::pow(10, 0.01 * n), 0.01 * n);
        const Vec<3> corrected = mean_of<3>(metrics, Mean::corrected).sizes;
        const Vec<3> own = mean_of<3>(metrics, Mean::interpolation).sizes;
        const Vec<3> blended = mean_of<3>(metrics, Mean::blended).sizes;
        QVERIFY(std::is_sorted(blended.begin(), blended.end()));
        for (int k = 0; k < 3; ++k) {
            QCOMPARE_GE(blended[k], std::min(corrected[k], own[k]) * (1 - 1e-12));
            QCOMPARE_LE(blended[k], std::max(corrected[k], own[k]) * (1 + 1e-12));
        }
    }
}

void MeansTest::say_which_node_does_not_converge() {
    std::mt19937 random(4);
    const Mesh<2> mesh = reference::star_of(reference::fan<2>(random, 1e4, 0.5));
    try {
        (void)nodal_metric(mesh, Mean::geodesic_fixed_step);
        QFAIL("it converged");
    } catch (const NotConverged& e) {
        QVERIFY(QString(e.what()).startsWith("node 0: geodesic-fixed-step: no mean of 12 metrics"));
        QVERIFY(e.code() == ExitCode::check_failed);
    }
}

QTEST_APPLESS_MAIN(MeansTest)
#include "means_test.moc"
