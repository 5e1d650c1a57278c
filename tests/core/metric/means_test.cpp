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
        if (!comes_from_sums(mean)) {
            continue; // geodesic_mean_test
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
