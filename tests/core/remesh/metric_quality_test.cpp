// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/metric_quality.h"

#include "core/cases/cube.h"
#include "core/metric/element_metric.h"
#include "tests/core/metric/reference.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

template <int D>
using Corners = std::array<Vec<D>, D + 1>;

template <int D>
double quality_in(const Corners<D>& points, const MetricField<D>& target,
                  Quality quality = Quality::original) {
    Mesh<D> mesh;
    Simplex<D> s;
    for (int i = 0; i <= D; ++i) {
        mesh.points.push_back(points[i]);
        s[i] = NodeId(i);
    }
    mesh.elements.push_back(s);
    mesh.region.push_back(1);
    shapes::add_boundary(mesh);
    const EditMesh<D> edit(mesh, classify_geometry(mesh));
    return metric_quality(edit, make_root_field(target), s, quality);
}

template <int D>
MetricQualities qualities_in(const Corners<D>& points, const MetricField<D>& target) {
    std::array<Metric<D>, D + 1> natural;
    std::copy(target.begin(), target.end(), natural.begin());
    return metric_qualities<D>(points, natural);
}

template <int D>
Corners<D> mapped_regular(const Mat<D>& A) {
    const Mat<D> W = reference::regular_edges<D>();
    Corners<D> x;
    x[0] = Vec<D>::Zero();
    for (int i = 0; i < D; ++i) {
        x[i + 1] = A * W.col(i);
    }
    return x;
}

/// (16), (17), (19) with the metric of the element from Eigen's eigenvalues of the mean of the
/// M^-1/2: lengths and volume are measured after mapping the element to the space where M is I.
template <int D>
double direct_quality(const Corners<D>& x, const MetricField<D>& target) {
    Mat<D> mean = Mat<D>::Zero();
    for (const Metric<D>& m : target) {
        mean += m.directions * m.sizes.asDiagonal() * m.directions.transpose() / (D + 1);
    }
    const Eigen::SelfAdjointEigenSolver<Mat<D>> eigen(mean);
    const Mat<D> F =
        eigen.eigenvalues().cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
    Mat<D> E;
    double squares = 0;
    int edges = 0;
    for (int i = 0; i <= D; ++i) {
        for (int j = 0; j < i; ++j) {
            squares += (F * (x[i] - x[j])).squaredNorm();
            ++edges;
        }
        if (i > 0) {
            E.col(i - 1) = F * (x[i] - x[0]);
        }
    }
    const double h = std::sqrt(squares / edges);
    const double volume =
        std::abs(E.determinant()) / std::abs(reference::regular_edges<D>().determinant());
    return volume / std::pow(h, D) * std::min(std::pow(h, D), std::pow(h, -D));
}

template <int D>
void rate_regular_simplices() {
    const auto target = isotropic<D>(D + 1, 0.3);
    const Mat<D> I = 0.3 * Mat<D>::Identity();
    QCOMPARE_LE(std::abs(quality_in<D>(mapped_regular<D>(I), target) - 1), 1e-14);
    for (const double factor : {1.2, 2.0, 4.0}) {
        const double expected = std::pow(factor, -D);
        QCOMPARE_LE(std::abs(quality_in<D>(mapped_regular<D>(I * factor), target) - expected),
                    1e-14);
        QCOMPARE_LE(std::abs(quality_in<D>(mapped_regular<D>(I / factor), target) - expected),
                    1e-14);
        const MetricQualities q = qualities_in<D>(mapped_regular<D>(I * factor), target);
        QCOMPARE_LE(std::abs(q.original - expected), 1e-14);
        QCOMPARE_LE(std::abs(q.modified - expected * expected), 1e-14); // edges and volume
    }
    double last = 1;
    for (const double stretch : {1.5, 3.0, 30.0}) { // at constant volume
        Vec<D> scale = Vec<D>::Ones();
        scale[0] = stretch;
        scale[1] = 1 / stretch;
        const double q = quality_in<D>(mapped_regular<D>(I * scale.asDiagonal()), target);
        QCOMPARE_LT(q, 0.8 * last);
        last = q;
    }
    const Mat<D> mirror = [] {
        Mat<D> m = Mat<D>::Identity();
        m(0, 0) = -1;
        return m;
    }();
    QCOMPARE(quality_in<D>(mapped_regular<D>(I * mirror), target), 0.0); // inverted
}

template <int D>
void rate_in_own_metric() {
    std::mt19937 random(3);
    for (int n = 0; n < 200; ++n) {
        // Columns of sizes 1 ... 1e6 apart, turned at random.
        const Mat<D> Q = reference::random_rotation<D>(random);
        Metric<D> metric;
        metric.directions = Q;
        metric.sizes[0] = std::pow(10.0, -(n % 7));
        const Mat<D> J = Q * metric.sizes.asDiagonal();
        const MetricField<D> target(D + 1, metric);
        QCOMPARE_LE(std::abs(quality_in<D>(mapped_regular<D>(J), target) - 1), 1e-3);
        QCOMPARE_LE(quality_in<D>(mapped_regular<D>(2 * J), target), std::pow(0.5, D) + 1e-3);
    }
}

template <int D>
void compare_bounded() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Mesh<D> mesh = make_cube<D>({.n = 2});
    const MetricField<D> field = nodal_metric(mesh);
    const RootField<D> root = make_root_field(field);
    const EditMesh<D> edit(mesh, classify_geometry(mesh));
    int above = 0, by_volume = 0;
    for (int n = 0; n < 2000; ++n) {
        Simplex<D> s; // any nodes, in any order: large ones, flat ones and inverted ones
        for (NodeId& v : s) {
            v = NodeId(
                std::uniform_int_distribution<std::size_t>(0, mesh.points.size() - 1)(random));
        }
        const double q = metric_quality<D>(edit, root, s);
        const double least = q * std::pow(10, 3 * uniform(random));
        const double bounded = metric_quality_above<D>(edit, root, s, least);
        if (q > least) {
            QCOMPARE(bounded, q);
            ++above;
        } else {
            QCOMPARE_LE(bounded, least);
            by_volume += bounded > q;
        }
    }
    QCOMPARE_GT(above, 50);
    QCOMPARE_GT(by_volume, 5);
}

template <int D>
void compare_with_eigenvalues() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0.5, 2);
    for (int n = 0; n < 300; ++n) {
        Corners<D> x = reference::stretched_simplex<D>(random, 1 + 3 * (n % 9));
        const Metric<D> own = element_metric<D>(x);
        MetricField<D> target(D + 1);
        for (Metric<D>& m : target) {
            m = own;
            m.sizes *= uniform(random);
            m.directions = reference::random_rotation<D>(random) * m.directions;
        }
        const double q = quality_in<D>(x, target);
        QCOMPARE_GT(q, 0.0);
        QCOMPARE_LE(q, 1.0);
        QCOMPARE_LE(std::abs(q - direct_quality<D>(x, target)), 1e-10 * q);
        QCOMPARE_LE(std::abs(q - qualities_in<D>(x, target).original), 1e-10 * q);
        // Turned together with its metric, an element keeps its quality.
        const Mat<D> Q = reference::random_rotation<D>(random);
        for (Vec<D>& p : x) {
            p = Q * p;
        }
        for (Metric<D>& m : target) {
            m.directions = Q * m.directions;
        }
        QCOMPARE_LE(std::abs(quality_in<D>(x, target) - q), 1e-10 * q);
    }
}

/// The three functions of one element: none is above the one with a factor less, all are 1 for the
/// regular element of unit size, and the shape alone knows no sizes.
template <int D>
void choose_quality() {
    std::mt19937 random(7);
    const auto target = isotropic<D>(D + 1, 1);
    for (int n = 0; n < 200; ++n) {
        Corners<D> x = reference::stretched_simplex<D>(random, 1 + n % 5);
        const double shape = quality_in<D>(x, target, Quality::shape);
        const double original = quality_in<D>(x, target, Quality::original);
        const double modified = quality_in<D>(x, target, Quality::modified);
        QCOMPARE_GT(modified, 0.0);
        QCOMPARE_LE(modified, original);
        QCOMPARE_LE(original, shape);
        QCOMPARE_LE(shape, 1 + 1e-14);
        QCOMPARE_LE(std::abs(modified - qualities_in<D>(x, target).modified), 1e-12 * modified);
        for (Vec<D>& p : x) {
            p *= 3;
        }
        QCOMPARE_LE(std::abs(quality_in<D>(x, target, Quality::shape) - shape), 1e-12);
    }
    const Corners<D> regular = mapped_regular<D>(Mat<D>::Identity());
    for (const Quality quality : all_qualities) {
        QCOMPARE_LE(std::abs(quality_in<D>(regular, target, quality) - 1), 1e-14);
        QVERIFY(quality_from_name(name(quality)) == quality);
    }
    QVERIFY(!quality_from_name("nice"));
}

/// An edge that is too long beside one that is too short: the mean does not see it, section 4.4
/// does.
void stretch_at_constant_mean() {
    const auto target = isotropic<2>(3, 1);
    const Corners<2> x{Vec<2>(0, 0), Vec<2>(1.3, 0), Vec<2>(0.2, 0.6)};
    double squares = 0, worst = 1;
    for (const auto& [i, j] : SimplexNumbering<2>::edges) {
        const double s = (x[i] - x[j]).squaredNorm();
        squares += s / 3;
        worst = std::min({worst, s, 1 / s});
    }
    const double volume = 1.3 * 0.6 / std::sqrt(0.75);
    const double shape = volume / squares;
    QCOMPARE_LE(std::abs(quality_in<2>(x, target, Quality::shape) - shape), 1e-14);
    QCOMPARE_LE(std::abs(quality_in<2>(x, target, Quality::original) -
                         shape * std::min(squares, 1 / squares)),
                1e-14);
    QCOMPARE_LE(std::abs(quality_in<2>(x, target, Quality::modified) -
                         shape * worst * std::min(volume, 1 / volume)),
                1e-14);
}

} // namespace

class MetricQualityTest : public QObject {
    Q_OBJECT
private slots:
    void bounded_is_exact_above_the_bound_and_not_above_it_otherwise() {
        compare_bounded<2>();
        compare_bounded<3>();
    }
    void is_one_for_the_asked_size_and_falls_with_size_and_shape();
    void is_one_for_stretched_elements_in_their_own_metric();
    void agrees_with_eigenvalues_and_does_not_see_rotations();
    void more_factors_make_it_smaller_and_the_shape_sees_no_size();
    void each_function_is_its_formula();
};

void MetricQualityTest::is_one_for_the_asked_size_and_falls_with_size_and_shape() {
    rate_regular_simplices<2>();
    rate_regular_simplices<3>();
}

void MetricQualityTest::is_one_for_stretched_elements_in_their_own_metric() {
    rate_in_own_metric<2>();
    rate_in_own_metric<3>();
}

void MetricQualityTest::agrees_with_eigenvalues_and_does_not_see_rotations() {
    compare_with_eigenvalues<2>();
    compare_with_eigenvalues<3>();
}

void MetricQualityTest::more_factors_make_it_smaller_and_the_shape_sees_no_size() {
    choose_quality<2>();
    choose_quality<3>();
}

void MetricQualityTest::each_function_is_its_formula() {
    stretch_at_constant_mean();
}

QTEST_APPLESS_MAIN(MetricQualityTest)
#include "metric_quality_test.moc"
