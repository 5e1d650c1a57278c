// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/nodal_metric.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/coarsen/target_metric.h"
#include "core/metric/element_metric.h"
#include "tests/core/metric/reference.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <cstring>

using namespace ameco;

namespace {

constexpr std::array converging_means{Mean::corrected, Mean::interpolation, Mean::log_euclidean,
                                      Mean::geodesic};
constexpr NodeId centre(0);

template <int D>
Metric<D> metric_with(const Vec<D>& sizes, const Mat<D>& directions) {
    Metric<D> metric;
    metric.sizes = sizes;
    metric.directions = directions;
    return metric;
}

template <int D>
void turn_star(Mean mean) {
    std::mt19937 random(7);
    const Mesh<D> mesh = reference::star_of(reference::fan<D>(random, 100, 0.3));
    const Mat<D> Q = reference::random_rotation<D>(random);
    Mesh<D> turned = mesh;
    for (Vec<D>& x : turned.points) {
        x = Q * x;
    }
    const Metric<D> before = nodal_metric(mesh, mean)[centre];
    const Metric<D> after = nodal_metric(turned, mean)[centre];
    QCOMPARE_LE(reference::relative_difference<D>(after.sizes, before.sizes), 1e-12);
    const Mat<D> F = length_factor<D>(before) * Q.transpose();
    const Mat<D> G = length_factor<D>(after);
    QCOMPARE_LE((G.transpose() * G - F.transpose() * F).norm(), 1e-10 * G.squaredNorm());
}

template <int D>
bool same_bytes(const MetricField<D>& a, const MetricField<D>& b) {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), a.size() * sizeof(a.raw()[0])) == 0;
}

template <int D>
void compare_thread_counts(const Mesh<D>& mesh, Mean mean) {
    set_thread_count(1);
    const MetricField<D> one = nodal_metric(mesh, mean);
    for (const int threads : {2, 3, 7}) {
        set_thread_count(threads);
        QVERIFY(same_bytes(nodal_metric(mesh, mean), one));
    }
    set_thread_count(0);
}

/// A layer with each element listed many times over: more of them than are held at a time.
Mesh<2> many_blocks() {
    Mesh<2> mesh = shapes::stretched_strip(15, 15, 1e-4);
    const std::vector<Simplex<2>> once = mesh.elements.raw();
    while (mesh.elements.size() < 140000) {
        for (const Simplex<2>& s : once) {
            mesh.elements.push_back(s);
        }
    }
    return mesh;
}

/// Asks to stop from the start, or counts progress.
class TestMonitor : public Monitor {
public:
    explicit TestMonitor(bool stop) : stop_(stop) {}
    void message(Severity, std::string_view) override {}
    void progress(double fraction, std::string_view) override { last = fraction; }
    [[nodiscard]] bool stop_requested() const override { return stop_; }
    double last = -1;

private:
    bool stop_;
};

} // namespace

class NodalMetricTest : public QObject {
    Q_OBJECT
private slots:
    void of_one_element_is_its_metric_data();
    void of_one_element_is_its_metric();
    void of_commuting_metrics_is_the_mean_of_their_sizes();
    void turns_with_the_mesh_data();
    void turns_with_the_mesh();
    void corrected_has_the_directions_of_the_interpolation_and_mean_sorted_sizes();
    void interpolation_is_the_mean_of_the_inverse_roots();
    void interpolation_keeps_the_smallest_size_of_aligned_elements();
    void log_euclidean_has_the_geometric_mean_of_determinants();
    void log_euclidean_commutes_with_inversion();
    void log_euclidean_is_sharper_than_interpolation_in_a_curved_layer();
    void of_the_model_box_has_the_sizes_of_its_cells_data();
    void of_the_model_box_has_the_sizes_of_its_cells();
    void sums_the_elements_of_many_blocks();
    void does_not_depend_on_the_number_of_threads();
    void stops_when_asked();
};

void NodalMetricTest::of_one_element_is_its_metric_data() {
    QTest::addColumn<int>("mean");
    for (const Mean mean : converging_means) {
        QTest::newRow(std::string(name(mean)).c_str()) << static_cast<int>(mean);
    }
}

void NodalMetricTest::of_one_element_is_its_metric() {
    QFETCH(const int, mean);
    std::mt19937 random(1);
    const Mesh<3> mesh = reference::star_of(
        std::vector{metric_with<3>({1e-3, 0.1, 2}, reference::random_rotation<3>(random))});
    const MetricField<3> field = nodal_metric(mesh, static_cast<Mean>(mean));
    const Metric<3> expected = element_metric<3>(corners_of<3>(mesh, mesh[ElementId(0)]));
    for (const Metric<3>& metric : field) {
        QCOMPARE_LE(reference::relative_difference<3>(metric.sizes, expected.sizes), 1e-12);
        QCOMPARE_LE((metric.directions - expected.directions).norm(), 1e-12);
    }
}

void NodalMetricTest::of_commuting_metrics_is_the_mean_of_their_sizes() {
    std::mt19937 random(2);
    const Mat<3> V = reference::random_rotation<3>(random);
    Mat<3> other; // the same axes, the first two exchanged
    other << -V.col(1), V.col(0), V.col(2);
    const Mesh<3> mesh =
        reference::star_of(std::vector{metric_with<3>({1, 4, 10}, V), metric_with<3>({3, 9, 20}, V),
                                       metric_with<3>({2, 6, 40}, other)});
    const auto sizes = [&](Mean mean) { return nodal_metric(mesh, mean)[centre].sizes; };
    using reference::relative_difference;
    const double third = 1.0 / 3;
    QCOMPARE_LE(relative_difference<3>(sizes(Mean::corrected), Vec<3>(2, 19 * third, 70 * third)),
                1e-13);
    QCOMPARE_LE(relative_difference<3>(sizes(Mean::interpolation),
                                       Vec<3>(10 * third, 15 * third, 70 * third)),
                1e-13);
    QCOMPARE_LE(relative_difference<3>(sizes(Mean::log_euclidean),
                                       Vec<3>(std::cbrt(18.0), std::cbrt(72.0), std::cbrt(8000.0))),
                1e-13);
}

void NodalMetricTest::turns_with_the_mesh_data() {
    of_one_element_is_its_metric_data();
}

void NodalMetricTest::turns_with_the_mesh() {
    QFETCH(const int, mean);
    turn_star<2>(static_cast<Mean>(mean));
    turn_star<3>(static_cast<Mean>(mean));
}

void NodalMetricTest::corrected_has_the_directions_of_the_interpolation_and_mean_sorted_sizes() {
    std::mt19937 random(3);
    const std::vector<Metric<3>> metrics = reference::fan<3>(random, 1e4, 0.2);
    const Mesh<3> mesh = reference::star_of(metrics);
    Vec<3> mean = Vec<3>::Zero();
    for (const Metric<3>& metric : metrics) {
        mean += metric.sizes / static_cast<double>(metrics.size());
    }
    const Metric<3> corrected = nodal_metric(mesh, Mean::corrected)[centre];
    const Metric<3> interpolation = nodal_metric(mesh, Mean::interpolation)[centre];
    QVERIFY(corrected.directions == interpolation.directions);
    QCOMPARE_LE(reference::relative_difference<3>(corrected.sizes, mean), 1e-11);
    // What the correction is for: a fan of directions swells the smallest size of (8).
    QCOMPARE_GT(interpolation.sizes[0], 50 * corrected.sizes[0]);
}

void NodalMetricTest::interpolation_is_the_mean_of_the_inverse_roots() {
    std::mt19937 random(4);
    const std::vector<Metric<3>> metrics = reference::fan<3>(random, 20, 0.5);
    Mat<3> S = Mat<3>::Zero();
    for (const Metric<3>& m : metrics) {
        S += m.directions * m.sizes.asDiagonal() * m.directions.transpose() /
             static_cast<double>(metrics.size());
    }
    const Metric<3> mean = nodal_metric(reference::star_of(metrics), Mean::interpolation)[centre];
    const Mat<3> T = mean.directions * mean.sizes.asDiagonal() * mean.directions.transpose();
    QCOMPARE_LE((T - S).norm(), 1e-13 * S.norm());
}

void NodalMetricTest::interpolation_keeps_the_smallest_size_of_aligned_elements() {
    std::mt19937 random(5);
    for (const double ratio : {1e4, 1e6, 1e8}) {
        const std::vector<Metric<3>> metrics(
            3, metric_with<3>({1 / ratio, 0.5, 1}, reference::random_rotation<3>(random)));
        const Metric<3> mean =
            nodal_metric(reference::star_of(metrics), Mean::interpolation)[centre];
        QCOMPARE_LE(std::abs(mean.sizes[0] * ratio - 1), 1e-15 * ratio);
    }
}

void NodalMetricTest::log_euclidean_has_the_geometric_mean_of_determinants() {
    std::mt19937 random(6);
    for (const double ratio : {1.0, 1e3, 1e6}) {
        const std::vector<Metric<3>> metrics = reference::fan<3>(random, ratio, 0.4);
        double sum = 0;
        for (const Metric<3>& metric : metrics) {
            sum += std::log(density<3>(metric)) / static_cast<double>(metrics.size());
        }
        const Mesh<3> mesh = reference::star_of(metrics);
        const double mean = density<3>(nodal_metric(mesh, Mean::log_euclidean)[centre]);
        QCOMPARE_LE(std::abs(mean / std::exp(sum) - 1), 1e-15 * ratio + 1e-12);
    }
}

void NodalMetricTest::log_euclidean_commutes_with_inversion() {
    std::mt19937 random(8);
    std::vector<Metric<3>> metrics = reference::fan<3>(random, 1e3, 0.4);
    const Metric<3> mean = nodal_metric(reference::star_of(metrics), Mean::log_euclidean)[centre];
    for (Metric<3>& metric : metrics) {
        metric.sizes = metric.sizes.cwiseInverse().eval();
    }
    const Metric<3> inverse =
        nodal_metric(reference::star_of(metrics), Mean::log_euclidean)[centre];
    const Vec<3> expected = mean.sizes.cwiseInverse().reverse();
    QCOMPARE_LE(reference::relative_difference<3>(inverse.sizes, expected), 1e-11);
}

void NodalMetricTest::log_euclidean_is_sharper_than_interpolation_in_a_curved_layer() {
    std::mt19937 random(9);
    const Mesh<2> mesh = reference::star_of(reference::fan<2>(random, 1e3, 0.35));
    QCOMPARE_LT(nodal_metric(mesh, Mean::log_euclidean)[centre].sizes[0],
                0.5 * nodal_metric(mesh, Mean::interpolation)[centre].sizes[0]);
}

void NodalMetricTest::of_the_model_box_has_the_sizes_of_its_cells_data() {
    QTest::addColumn<double>("flatness");
    for (const double flatness : {1e-3, 1e-4, 1e-5, 1e-6}) {
        QTest::addRow("dz = %g dx", flatness) << flatness;
    }
}

void NodalMetricTest::of_the_model_box_has_the_sizes_of_its_cells() {
    // Paper, 5.1: eight cells; sizes are approximately dx, dy, dz, and only dz is to double.
    QFETCH(const double, flatness);
    const Mesh<3> mesh = shapes::box({0, 1, 2}, {0, 1, 2}, {0, flatness, 2 * flatness});
    for (const Metric<3>& metric : nodal_metric(mesh)) {
        const Vec<3>& h = metric.sizes;
        QCOMPARE_LE(std::abs(h[0] / flatness - 1), flatness); // exactly dz in each Kuhn tet
        QCOMPARE_GT(h[1], 0.8);
        QCOMPARE_LT(h[2], 1.7);
        QCOMPARE_LE(std::abs(metric.directions(2, 0) - 1), 1e-5);
        const Vec<3> target = coarsened_sizes<3>(h, {.factor = 2, .slack = 1});
        QVERIFY(target == Vec<3>(2 * h[0], h[1], h[2]));
    }
}

void NodalMetricTest::sums_the_elements_of_many_blocks() {
    // Against a plain loop over all elements.
    const Mesh<2> mesh = many_blocks();
    IdVector<NodeId, Vec<2>> sums(mesh.points.size(), Vec<2>::Zero());
    IdVector<NodeId, int> counts(mesh.points.size(), 0);
    for (const Simplex<2>& s : mesh.elements) {
        const Vec<2> sizes = element_metric<2>(corners_of<2>(mesh, s)).sizes;
        for (const NodeId i : s) {
            sums[i] += sizes;
            ++counts[i];
        }
    }
    const MetricField<2> field = nodal_metric(mesh);
    for (const NodeId i : field.ids()) {
        if (field[i].sizes != Vec<2>(sums[i] / counts[i])) {
            QFAIL(qPrintable(QString("node %1").arg(i.value())));
        }
    }
}

void NodalMetricTest::does_not_depend_on_the_number_of_threads() {
    const Mesh<3> slab = shapes::stretched_slab(7, 12, 1e-6, 1.8);
    for (const Mean mean : converging_means) {
        compare_thread_counts(slab, mean);
    }
    compare_thread_counts(many_blocks(), Mean::corrected);
}

void NodalMetricTest::stops_when_asked() {
    const Mesh<3> mesh = shapes::cube(2);
    TestMonitor impatient(true);
    QVERIFY_THROWS_EXCEPTION(Cancelled, (void)nodal_metric(mesh, Mean::corrected, impatient));
    TestMonitor patient(false);
    QCOMPARE(nodal_metric(mesh, Mean::corrected, patient).size(), mesh.points.size());
    QCOMPARE(patient.last, 1.0);
}

QTEST_APPLESS_MAIN(NodalMetricTest)
#include "nodal_metric_test.moc"
