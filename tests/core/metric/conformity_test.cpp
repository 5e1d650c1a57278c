// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/conformity.h"

#include "core/base/parallel.h"
#include "core/metric/element_metric.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/metric/reference.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <numeric>

using namespace ameco;

namespace {

template <int D>
MetricField<D> isotropic(const Mesh<D>& mesh, double size) {
    MetricField<D> field(mesh.points.size());
    for (Metric<D>& metric : field) {
        metric.sizes.setConstant(size);
    }
    return field;
}

/// A patch of equilateral triangles of edge 1.
Mesh<2> regular_triangles(int n) {
    Mesh<2> mesh = shapes::square(n);
    for (Vec<2>& x : mesh.points) {
        x = n * Vec<2>(x[0] - x[1] / 2, x[1] * std::sqrt(0.75));
    }
    return mesh;
}

bool same(const Conformity& a, const Conformity& b) {
    return a.edges == b.edges && a.in_band == b.in_band && a.below_half == b.below_half &&
           a.above_two == b.above_two && a.shortest == b.shortest && a.longest == b.longest &&
           a.mean_quality == b.mean_quality && a.worst_quality == b.worst_quality;
}

} // namespace

class ConformityTest : public QObject {
    Q_OBJECT
private slots:
    void of_a_regular_mesh_is_full();
    void of_a_stretched_regular_mesh_is_full_data();
    void of_a_stretched_regular_mesh_is_full();
    void counts_every_edge_once();
    void sees_edges_that_are_too_short_or_too_long();
    void has_the_mean_ratio_of_a_right_triangle_as_quality();
    void does_not_see_the_size_in_the_shape();
    void takes_the_logarithmic_mean_of_two_lengths();
    void does_not_depend_on_the_number_of_threads();
    void classes_hold_every_edge_and_element_at_its_place();
    void classes_at_the_ends_hold_what_is_beyond();
};

void ConformityTest::of_a_regular_mesh_is_full() {
    const Mesh<2> mesh = regular_triangles(5);
    const Conformity c = conformity(mesh, isotropic(mesh, 1));
    QCOMPARE(c.in_band, 1.0);
    QCOMPARE(c.below_half + c.above_two, 0.0);
    QCOMPARE_LE(std::abs(c.shortest - 1) + std::abs(c.longest - 1), 1e-14);
    QCOMPARE_LE(1 - c.worst_quality, 1e-14);
    QCOMPARE_LE(std::abs(c.mean_quality - 1), 1e-14);
}

void ConformityTest::of_a_stretched_regular_mesh_is_full_data() {
    QTest::addColumn<double>("ratio");
    for (const double ratio : {1.0, 1e3, 1e6}) {
        QTest::addRow("aspect ratio %g", ratio) << ratio;
    }
}

void ConformityTest::of_a_stretched_regular_mesh_is_full() {
    QFETCH(const double, ratio);
    std::mt19937 random(1);
    Mesh<3> mesh = shapes::single_tet();
    const auto points = reference::stretched_simplex<3>(random, ratio);
    std::copy(points.begin(), points.end(), mesh.points.begin());
    const Conformity c = conformity(mesh, MetricField<3>(4, element_metric<3>(points)));
    QCOMPARE(c.edges, 6);
    QCOMPARE(c.in_band, 1.0);
    QCOMPARE_LE(std::abs(c.longest - 1), 1e-15 * ratio + 1e-14);
    QCOMPARE_LE(1 - c.worst_quality, 1e-15 * ratio + 1e-14);
}

void ConformityTest::counts_every_edge_once() {
    const Mesh<3> mesh = shapes::cube(2);
    // 3 * 2 * 9 along the axes, 3 * 4 * 3 face diagonals, 8 space diagonals.
    QCOMPARE(conformity(mesh, isotropic(mesh, 1)).edges, 54 + 36 + 8);
}

void ConformityTest::sees_edges_that_are_too_short_or_too_long() {
    const Mesh<2> mesh = shapes::rectangle({0, 1, 2}, {0, 1, 2}); // 12 edges of 1, 4 of sqrt(2)
    const auto with = [&](double size) { return conformity(mesh, isotropic(mesh, size)); };
    QCOMPARE(with(1.2).in_band, 1.0);
    QCOMPARE(with(1.5).in_band, 0.25); // 0.67 and 0.94
    QCOMPARE(with(2.2).below_half, 0.75);
    QCOMPARE(with(2.2).in_band, 0.0);
    QCOMPARE(with(4).below_half, 1.0);
    QCOMPARE(with(0.6).above_two, 0.25);
    QCOMPARE(with(0.25).above_two, 1.0);
    QCOMPARE(with(0.25).shortest, 4.0);
}

void ConformityTest::has_the_mean_ratio_of_a_right_triangle_as_quality() {
    // (17): 4/sqrt(3) * area 1/2 / (mean of 1, 1, 2).
    const Mesh<2> mesh = shapes::square(3);
    const Conformity c = conformity(mesh, isotropic(mesh, 0.1));
    const double expected = 4 / std::sqrt(3) * 0.5 / (4.0 / 3);
    QCOMPARE_LE(std::abs(c.worst_quality - expected), 1e-14);
    QCOMPARE_LE(std::abs(c.mean_quality - expected), 1e-14);
}

void ConformityTest::does_not_see_the_size_in_the_shape() {
    const Mesh<3> mesh = shapes::cube(2);
    const Conformity small = conformity(mesh, isotropic(mesh, 1e-3));
    const Conformity large = conformity(mesh, isotropic(mesh, 1e3));
    QCOMPARE_LE(std::abs(small.worst_quality - large.worst_quality), 1e-14);
}

void ConformityTest::takes_the_logarithmic_mean_of_two_lengths() {
    const Mesh<2> mesh = shapes::single_triangle();
    MetricField<2> field = isotropic(mesh, 1);
    field[NodeId(1)].sizes.setConstant(0.1);
    field[NodeId(2)].sizes.setConstant(0.1);
    const Conformity c = conformity(mesh, field);
    QCOMPARE_LE(std::abs(c.shortest - 9 / std::log(10)), 1e-14); // between lengths 1 and 10
    QCOMPARE_LE(std::abs(c.longest - std::sqrt(200)), 1e-13);
}

void ConformityTest::does_not_depend_on_the_number_of_threads() {
    const Mesh<3> mesh = shapes::stretched_slab(9, 12, 1e-5, 1.7);
    const MetricField<3> field = nodal_metric(mesh);
    set_thread_count(1);
    const Conformity one = conformity(mesh, field);
    for (const int threads : {2, 5}) {
        set_thread_count(threads);
        QVERIFY(same(conformity(mesh, field), one));
    }
    set_thread_count(0);
}

void ConformityTest::classes_hold_every_edge_and_element_at_its_place() {
    const Mesh<2> mesh = regular_triangles(5);
    // Edges of length sqrt(2)^3: log2 = 1.5, in the class that begins there.
    const ConformityClasses c = classify_conformity(mesh, isotropic(mesh, std::exp2(-1.501)));
    constexpr int middle = ConformityClasses::length_classes / 2;
    QCOMPARE(c.length[middle + 6], conformity(mesh, isotropic(mesh, 1)).edges);
    QCOMPARE(c.quality.back(), static_cast<std::int64_t>(mesh.elements.size()));
    const auto sum = [](const auto& counts) {
        return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    };
    QCOMPARE(sum(c.length), c.length[middle + 6]);
    QCOMPARE(sum(c.quality), c.quality.back());
}

void ConformityTest::classes_at_the_ends_hold_what_is_beyond() {
    const Mesh<2> mesh = regular_triangles(3);
    const std::int64_t edges = conformity(mesh, isotropic(mesh, 1)).edges;
    QCOMPARE(classify_conformity(mesh, isotropic(mesh, 1e-6)).length.back(), edges);
    QCOMPARE(classify_conformity(mesh, isotropic(mesh, 1e6)).length.front(), edges);
}

QTEST_APPLESS_MAIN(ConformityTest)
#include "conformity_test.moc"
