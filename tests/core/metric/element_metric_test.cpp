// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/element_metric.h"

#include "tests/core/metric/reference.h"
#include "tests/core/metric/wide_reference.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <cfloat>

using namespace ameco;

namespace {

constexpr int samples = 60;

template <int D>
void compare_lengths(double ratio, double tolerance) {
    std::mt19937 random(1);
    for (int n = 0; n < samples; ++n) {
        const auto points = reference::stretched_simplex<D>(random, ratio);
        QCOMPARE_LE(reference::residual<D>(element_metric<D>(points), points), tolerance);
    }
}

template <int D>
void compare_sizes(double ratio) {
    std::mt19937 random(2);
    for (int n = 0; n < samples; ++n) {
        const auto points = reference::stretched_simplex<D>(random, ratio);
        const Vec<D> sizes = element_metric<D>(points).sizes;
        QCOMPARE_LE(reference::relative_difference<D>(sizes, wide::sizes<D>(points)), 5e-15);
    }
}

template <int D>
void compare_with_inverted_sum() {
    std::mt19937 random(3);
    for (int n = 0; n < samples; ++n) {
        const auto points = reference::stretched_simplex<D>(random, 3);
        const Mat<D> F = length_factor<D>(element_metric<D>(points));
        const Mat<D> M = reference::inverted_sum<D>(points);
        QCOMPARE_LE((F.transpose() * F - M).norm(), 1e-12 * M.norm());
    }
}

template <int D>
void check_frames() {
    std::mt19937 random(4);
    for (int n = 0; n < samples; ++n) {
        const auto points = reference::stretched_simplex<D>(random, std::pow(10.0, n % 9));
        const Metric<D> metric = element_metric<D>(points);
        const Mat<D>& V = metric.directions;
        QVERIFY(std::is_sorted(metric.sizes.begin(), metric.sizes.end()));
        QCOMPARE_LE((V.transpose() * V - Mat<D>::Identity()).cwiseAbs().maxCoeff(), 1e-15);
        QCOMPARE_GT(V.determinant(), 0.0);
        for (int j = 0; j < D - 1; ++j) {
            QCOMPARE(V.col(j).maxCoeff(), V.col(j).cwiseAbs().maxCoeff());
        }
    }
}

template <int D>
void turn_elements() {
    std::mt19937 random(5);
    for (int n = 0; n < samples; ++n) {
        auto points = reference::stretched_simplex<D>(random, 50);
        const Metric<D> before = element_metric<D>(points);
        const Mat<D> Q = reference::random_rotation<D>(random);
        for (Vec<D>& x : points) {
            x = Q * x;
        }
        const Metric<D> after = element_metric<D>(points);
        const Mat<D> F = length_factor<D>(before) * Q.transpose();
        const Mat<D> G = length_factor<D>(after);
        QCOMPARE_LE(reference::relative_difference<D>(after.sizes, before.sizes), 1e-13);
        QCOMPARE_LE((G.transpose() * G - F.transpose() * F).norm(), 1e-12 * G.squaredNorm());
    }
}

/// Elements without volume: which of the sizes are zero.
template <int D>
void check_degenerate(const std::array<Vec<D>, D + 1>& points, int zero_sizes) {
    const Metric<D> metric = element_metric<D>(points);
    const Mat<D>& V = metric.directions;
    QVERIFY(!is_valid<D>(metric));
    for (int k = 0; k < D; ++k) {
        QCOMPARE(metric.sizes[k] < 1e-30, k < zero_sizes);
        QVERIFY(std::isfinite(metric.sizes[k]));
    }
    QCOMPARE_LE((V.transpose() * V - Mat<D>::Identity()).cwiseAbs().maxCoeff(), 1e-15);
}

template <int D>
void compare_many_with_one(const Mesh<D>& mesh) {
    std::vector<Metric<D>> metrics(mesh.elements.size() - 1);
    element_metrics<D>(mesh, ElementId(1), metrics);
    for (std::size_t n = 0; n < metrics.size(); ++n) {
        const Simplex<D>& s = mesh[ElementId(n + 1)];
        QVERIFY(metrics[n] == element_metric<D>(corners_of<D>(mesh, s)));
    }
}

} // namespace

class ElementMetricTest : public QObject {
    Q_OBJECT
private slots:
    void makes_all_edges_one_long_data();
    void makes_all_edges_one_long();
    void has_sizes_right_to_the_last_digits_data();
    void has_sizes_right_to_the_last_digits();
    void is_the_inverted_sum_of_edges_where_that_is_accurate();
    void of_a_regular_simplex_has_its_edge_length_as_sizes();
    void has_ascending_sizes_and_a_right_handed_frame();
    void turns_with_the_element();
    void does_not_depend_on_the_order_of_the_nodes();
    void fills_the_volume_of_the_element();
    void of_a_flat_element_has_zero_sizes();
    void of_many_elements_is_that_of_each();
};

void ElementMetricTest::makes_all_edges_one_long_data() {
    QTest::addColumn<double>("ratio");
    QTest::addColumn<double>("tolerance");
    // The directions are doubles: their last digit, seen at the smallest size, is the limit.
    for (const double ratio : {1.0, 1e2, 1e4, 1e6}) {
        QTest::addRow("aspect ratio %g", ratio) << ratio << 1e-8 * ratio / 1e6 + 1e-14;
    }
}

void ElementMetricTest::makes_all_edges_one_long() {
    QFETCH(const double, ratio);
    QFETCH(const double, tolerance);
    compare_lengths<2>(ratio, tolerance);
    compare_lengths<3>(ratio, tolerance);
}

void ElementMetricTest::has_sizes_right_to_the_last_digits_data() {
    QTest::addColumn<double>("ratio");
    for (const double ratio : {1.0, 1e2, 1e4, 1e6, 1e8, 1e10}) {
        QTest::addRow("aspect ratio %g", ratio) << ratio;
    }
}

void ElementMetricTest::has_sizes_right_to_the_last_digits() {
    QFETCH(const double, ratio);
    compare_sizes<2>(ratio);
    compare_sizes<3>(ratio);
}

void ElementMetricTest::is_the_inverted_sum_of_edges_where_that_is_accurate() {
    compare_with_inverted_sum<2>();
    compare_with_inverted_sum<3>();
}

void ElementMetricTest::of_a_regular_simplex_has_its_edge_length_as_sizes() {
    const std::array<Vec<3>, 4> tet{Vec<3>(1, 1, 1), Vec<3>(-1, 1, -1), Vec<3>(1, -1, -1),
                                    Vec<3>(-1, -1, 1)};
    const Metric<3> metric = element_metric<3>(tet);
    for (const double h : metric.sizes) {
        QCOMPARE_LE(std::abs(h - std::sqrt(8.0)), 2e-15);
    }
}

void ElementMetricTest::has_ascending_sizes_and_a_right_handed_frame() {
    check_frames<2>();
    check_frames<3>();
}

void ElementMetricTest::turns_with_the_element() {
    turn_elements<2>();
    turn_elements<3>();
}

void ElementMetricTest::does_not_depend_on_the_order_of_the_nodes() {
    std::mt19937 random(6);
    auto points = reference::stretched_simplex<3>(random, 1e6);
    const Metric<3> metric = element_metric<3>(points);
    std::array<int, 4> order{0, 1, 2, 3};
    while (std::next_permutation(order.begin(), order.end())) {
        const Metric<3> other = element_metric<3>(
            {points[order[0]], points[order[1]], points[order[2]], points[order[3]]});
        QCOMPARE_LE(reference::relative_difference<3>(other.sizes, metric.sizes), 5e-15);
        QCOMPARE_LE((other.directions - metric.directions).norm(), 1e-8);
    }
}

void ElementMetricTest::fills_the_volume_of_the_element() {
    const Mesh<3> mesh = shapes::stretched_slab(2, 8, 1e-6, 2.0);
    for (const Simplex<3>& s : mesh.elements) {
        const auto x = corners_of<3>(mesh, s);
        Mat<3> edges;
        edges << x[1] - x[0], x[2] - x[0], x[3] - x[0];
        const double unit_simplices = edges.determinant() / 6 / regular_simplex_volume<3>;
        const double product = element_metric<3>(x).sizes.prod();
        QCOMPARE_LE(std::abs(product / unit_simplices - 1), 1e-14);
    }
}

void ElementMetricTest::of_a_flat_element_has_zero_sizes() {
    const Vec<3> o(0.1, 0.2, 0.3);
    const Vec<3> x = Vec<3>::UnitX();
    const Vec<3> y = Vec<3>::UnitY();
    check_degenerate<3>({o, o + x, o + y, o + x + y}, 1);
    check_degenerate<3>({o, o + x, o + 0.5 * x, o + 3 * x}, 2);
    check_degenerate<3>({o, o, o, o + y}, 2);
    check_degenerate<3>({o, o, o, o}, 3);
    check_degenerate<2>({Vec<2>(0, 0), Vec<2>(1, 1), Vec<2>(3, 3)}, 1);
    check_degenerate<2>({Vec<2>(1, 2), Vec<2>(1, 2), Vec<2>(1, 2)}, 2);
}

void ElementMetricTest::of_many_elements_is_that_of_each() {
    compare_many_with_one<2>(shapes::stretched_strip(3, 9, 1e-7, 3.0));
    compare_many_with_one<3>(shapes::stretched_slab(3, 5, 1e-7, 3.0));
}

QTEST_APPLESS_MAIN(ElementMetricTest)
#include "element_metric_test.moc"
