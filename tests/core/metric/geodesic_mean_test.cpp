// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/geodesic_mean.h"

#include "core/cases/model_layer.h"
#include "core/mesh/adjacency.h"
#include "core/metric/element_metric.h"
#include "core/metric/geodesic.h"
#include "tests/core/metric/reference.h"
#include "tests/core/metric/wide_reference.h"

#include <QTest>

using namespace ameco;

namespace {

template <int D>
GeodesicMean<D> mean(const std::vector<Metric<D>>& metrics, GeodesicStep step) {
    GeodesicOptions options;
    options.step = step;
    return geodesic_mean<D>(metrics, options);
}

template <int D>
GeodesicMean<D> mean(const std::vector<Metric<D>>& metrics) {
    return mean(metrics, GeodesicStep::newton);
}

/// The metrics of the elements around the central node of figure 1.
std::vector<Metric<2>> central_metrics(double angle_deg, double stretching) {
    ModelLayerOptions options;
    options.angle_deg = angle_deg;
    options.stretching = stretching;
    const Mesh<2> mesh = make_model_layer(options);
    const int columns = 2 * options.cells + 1;
    const NodeId centre(options.layers / 2 * columns + options.cells);
    std::vector<Metric<2>> metrics;
    const NodeElements balls = node_elements(mesh);
    for (const ElementId e : balls[centre]) {
        metrics.push_back(element_metric<2>(corners_of<2>(mesh, mesh[e])));
    }
    return metrics;
}

template <int D>
void compare_with_fifty_digits(double ratio, double angle) {
    std::mt19937 random(1);
    for (int n = 0; n < 4; ++n) {
        const Mesh<D> mesh = reference::star_of(reference::fan<D>(random, ratio, angle));
        std::vector<Metric<D>> metrics(mesh.elements.size());
        element_metrics<D>(mesh, ElementId(0), metrics);
        const GeodesicMean<D> found = mean(metrics);
        QVERIFY(found.converged);
        QCOMPARE_LE(found.iterations, 20);
        // Bounds the relative error of the sizes, and the aspect ratio times the error of the
        // short axis' direction.
        const double bound = wide::geodesic_residual<D>(reference::all_corners(mesh), found.mean);
        QCOMPARE_LE(bound, 5e-15 * ratio + 2e-12);
    }
}

template <int D>
void check_determinant() {
    std::mt19937 random(2);
    const std::vector<Metric<D>> metrics = reference::fan<D>(random, 1e4, 0.4);
    double sum = 0;
    for (const Metric<D>& metric : metrics) {
        sum += std::log(density(metric)) / static_cast<double>(metrics.size());
    }
    QCOMPARE_LE(std::abs(density(mean(metrics).mean) / std::exp(sum) - 1), 1e-10);
}

template <int D>
void check_inversion() {
    std::mt19937 random(3);
    const std::vector<Metric<D>> metrics = reference::fan<D>(random, 1e3, 0.4);
    std::vector<Metric<D>> inverses;
    for (const Metric<D>& metric : metrics) {
        inverses.push_back(inverse(metric));
    }
    QCOMPARE_LE(invariant_distance(inverse(mean(inverses).mean), mean(metrics).mean), 1e-10);
}

} // namespace

class GeodesicMeanTest : public QObject {
    Q_OBJECT
private slots:
    void agrees_with_fifty_digits_data();
    void agrees_with_fifty_digits();
    void of_two_metrics_is_half_way_between();
    void of_commuting_metrics_is_the_geometric_mean_of_sizes();
    void has_the_geometric_mean_of_determinants();
    void commutes_with_inversion();
    void does_not_depend_on_the_order();
    void by_the_fixed_step_is_the_same_where_it_converges();
    void by_the_fixed_step_diverges_as_the_paper_says_data();
    void by_the_fixed_step_diverges_as_the_paper_says();
};

void GeodesicMeanTest::agrees_with_fifty_digits_data() {
    QTest::addColumn<double>("ratio");
    QTest::addColumn<double>("angle");
    for (const double ratio : {1.0, 1e2, 1e4, 1e6}) {
        for (const double angle : {0.0, 1e-6, 1e-3, 0.35, 1.5}) {
            QTest::addRow("aspect ratio %g, directions within %g", ratio, angle) << ratio << angle;
        }
    }
}

void GeodesicMeanTest::agrees_with_fifty_digits() {
    QFETCH(const double, ratio);
    QFETCH(const double, angle);
    compare_with_fifty_digits<2>(ratio, angle);
    compare_with_fifty_digits<3>(ratio, angle);
}

void GeodesicMeanTest::of_two_metrics_is_half_way_between() {
    std::mt19937 random(4);
    for (const double ratio : {1.0, 1e2, 1e4}) {
        std::vector<Metric<3>> metrics = reference::fan<3>(random, ratio, 0.5);
        metrics.resize(2);
        QCOMPARE_LE(invariant_distance(mean(metrics).mean, geodesic(metrics[0], metrics[1], 0.5)),
                    1e-11 * ratio);
    }
}

void GeodesicMeanTest::of_commuting_metrics_is_the_geometric_mean_of_sizes() {
    std::mt19937 random(5);
    Metric<3> a;
    a.directions = reference::random_rotation<3>(random);
    Metric<3> b = a;
    a.sizes = Vec<3>(1e-6, 1, 2);
    b.sizes = Vec<3>(4e-6, 1, 8);
    const Metric<3> m = mean<3>({a, b}).mean;
    QCOMPARE_LE(reference::relative_difference<3>(m.sizes, Vec<3>(2e-6, 1, 4)), 1e-9);
}

void GeodesicMeanTest::has_the_geometric_mean_of_determinants() {
    check_determinant<2>();
    check_determinant<3>();
}

void GeodesicMeanTest::commutes_with_inversion() {
    check_inversion<2>();
    check_inversion<3>();
}

void GeodesicMeanTest::does_not_depend_on_the_order() {
    std::mt19937 random(6);
    std::vector<Metric<3>> metrics = reference::fan<3>(random, 1e5, 0.3);
    const Metric<3> forward = mean(metrics).mean;
    std::reverse(metrics.begin(), metrics.end());
    QCOMPARE_LE(invariant_distance(mean(metrics).mean, forward), 1e-9);
}

void GeodesicMeanTest::by_the_fixed_step_is_the_same_where_it_converges() {
    for (const double stretching : {100.0, 1000.0}) {
        const std::vector<Metric<2>> metrics = central_metrics(0, stretching);
        const GeodesicMean<2> fixed = mean(metrics, GeodesicStep::fixed);
        QVERIFY(fixed.converged);
        QCOMPARE_LE(invariant_distance(fixed.mean, mean(metrics).mean), 1e-10);
    }
}

void GeodesicMeanTest::by_the_fixed_step_diverges_as_the_paper_says_data() {
    QTest::addColumn<double>("stretching");
    QTest::addRow("stretching 100") << 100.0;
    QTest::addRow("stretching 1000") << 1000.0;
}

void GeodesicMeanTest::by_the_fixed_step_diverges_as_the_paper_says() {
    // Section 2.3.5, alpha = 20 degrees.
    QFETCH(const double, stretching);
    const std::vector<Metric<2>> metrics = central_metrics(20, stretching);
    const GeodesicMean<2> fixed = mean(metrics, GeodesicStep::fixed);
    QVERIFY(!fixed.converged);
    QVERIFY(is_valid(fixed.mean));
    QCOMPARE_GT(fixed.residual, 0.1);
    const GeodesicMean<2> newton = mean(metrics);
    QVERIFY(newton.converged);
    QCOMPARE_LE(newton.iterations, 15);
}

QTEST_APPLESS_MAIN(GeodesicMeanTest)
#include "geodesic_mean_test.moc"
