// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/complexity.h"

#include "core/base/parallel.h"
#include "core/metric/element_metric.h"
#include "tests/core/metric/reference.h"
#include "tests/support/shapes.h"

#include <QTest>

using namespace ameco;

namespace {

template <int D>
MetricField<D> constant_field(const Mesh<D>& mesh, const Vec<D>& sizes) {
    std::mt19937 random(1);
    Metric<D> metric;
    metric.sizes = sizes;
    metric.directions = reference::random_rotation<D>(random);
    return MetricField<D>(mesh.points.size(), metric);
}

bool near(double a, double b) {
    return std::abs(a / b - 1) < 1e-13;
}

} // namespace

class ComplexityTest : public QObject {
    Q_OBJECT
private slots:
    void of_a_constant_field_is_volume_times_density();
    void of_a_varying_field_uses_the_mean_density_of_each_element();
    void predicts_one_element_for_a_regular_simplex();
    void halving_all_sizes_asks_for_two_to_the_dimension_times_as_many();
    void does_not_depend_on_the_number_of_threads();
};

void ComplexityTest::of_a_constant_field_is_volume_times_density() {
    const Mesh<3> cube = shapes::cube(3);
    QVERIFY(near(complexity(cube, constant_field<3>(cube, {1e-6, 0.01, 0.1})), 1e9));
    const Mesh<2> square = shapes::square(4);
    QVERIFY(near(complexity(square, constant_field<2>(square, {1e-6, 0.01})), 1e8));
}

void ComplexityTest::of_a_varying_field_uses_the_mean_density_of_each_element() {
    const Mesh<2> mesh = shapes::single_triangle();
    MetricField<2> field(3);
    field[NodeId(0)].sizes = Vec<2>(1, 1);
    field[NodeId(1)].sizes = Vec<2>(0.5, 1);
    field[NodeId(2)].sizes = Vec<2>(0.1, 1);
    QVERIFY(near(complexity(mesh, field), 0.5 * (1 + 2 + 10) / 3));
}

void ComplexityTest::predicts_one_element_for_a_regular_simplex() {
    std::mt19937 random(2);
    Mesh<3> mesh = shapes::single_tet();
    const auto points = reference::stretched_simplex<3>(random, 1e3);
    std::copy(points.begin(), points.end(), mesh.points.begin());
    const MetricField<3> field(4, element_metric<3>(points));
    QCOMPARE_LE(std::abs(predicted_elements<3>(complexity(mesh, field)) - 1), 1e-9);
    QVERIFY(near(predicted_elements<2>(std::sqrt(3) / 4), 1));
}

void ComplexityTest::halving_all_sizes_asks_for_two_to_the_dimension_times_as_many() {
    const Mesh<3> mesh = shapes::cube(2);
    const double coarse = complexity(mesh, constant_field<3>(mesh, {0.1, 0.2, 0.3}));
    const double fine = complexity(mesh, constant_field<3>(mesh, {0.05, 0.1, 0.15}));
    QVERIFY(near(fine, 8 * coarse));
}

void ComplexityTest::does_not_depend_on_the_number_of_threads() {
    const Mesh<3> mesh = shapes::cube(12); // more elements than one piece has
    const MetricField<3> field = constant_field<3>(mesh, {0.1, 0.2, 0.3});
    set_thread_count(1);
    const double one = complexity(mesh, field);
    set_thread_count(2);
    QVERIFY(complexity(mesh, field) == one);
    set_thread_count(0);
}

QTEST_APPLESS_MAIN(ComplexityTest)
#include "complexity_test.moc"
