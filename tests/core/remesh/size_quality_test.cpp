// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/size_quality.h"

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
Simplex<D> first_nodes() {
    Simplex<D> s;
    for (int i = 0; i <= D; ++i) {
        s[i] = NodeId(i);
    }
    return s;
}

template <int D>
Mesh<D> single_element(const std::array<Vec<D>, D + 1>& points) {
    Mesh<D> mesh;
    for (const Vec<D>& x : points) {
        mesh.points.push_back(x);
    }
    mesh.elements.push_back(first_nodes<D>());
    mesh.region.push_back(1);
    shapes::add_boundary(mesh);
    return mesh;
}

template <int D>
double quality_in(const std::array<Vec<D>, D + 1>& points, const MetricField<D>& target) {
    const Mesh<D> mesh = single_element<D>(points);
    const EditMesh<D> edit(mesh, classify_geometry(mesh));
    return size_quality(edit, make_size_field(target), first_nodes<D>());
}

/// A regular simplex of the given edge, with its corners mapped by A.
template <int D>
std::array<Vec<D>, D + 1> mapped_regular(const Mat<D>& A, double edge = 1) {
    const Mat<D> W = reference::regular_edges<D>();
    std::array<Vec<D>, D + 1> x;
    x[0] = Vec<D>::Zero();
    for (int i = 0; i < D; ++i) {
        x[i + 1] = edge * A * W.col(i);
    }
    return x;
}

/// The definition, with sizes from Eigen's eigenvalues of J J^T.
template <int D>
double direct_quality(const std::array<Vec<D>, D + 1>& x, const MetricField<D>& target) {
    Mat<D> E;
    for (int i = 0; i < D; ++i) {
        E.col(i) = x[i + 1] - x[0];
    }
    const Mat<D> J = E * reference::regular_edges<D>().inverse();
    const Vec<D> h2 = Eigen::SelfAdjointEigenSolver<Mat<D>>(J * J.transpose()).eigenvalues();
    const auto ratios = [](const Vec<D>& squares) {
        Vec<D> e;
        if constexpr (D == 2) {
            e << squares.sum(), squares.prod();
        } else {
            e << squares.sum(),
                squares[0] * squares[1] + squares[0] * squares[2] + squares[1] * squares[2],
                squares.prod();
        }
        Vec<D> r;
        for (int k = 0; k < D; ++k) {
            r[k] = std::sqrt(e[k] / (k == 0 ? 1 : e[k - 1]));
        }
        return r;
    };
    Vec<D> wanted = Vec<D>::Zero();
    for (const Metric<D>& m : target) {
        wanted += ratios(m.sizes.cwiseAbs2()) / (D + 1);
    }
    const Vec<D> r = ratios(h2);
    double product = 1;
    for (int k = 0; k < D; ++k) {
        product *= std::min(r[k] / wanted[k], wanted[k] / r[k]);
    }
    return product;
}

template <int D>
void rate_regular_simplices() {
    const auto target = isotropic<D>(D + 1, 0.3);
    const Mat<D> I = Mat<D>::Identity();
    QCOMPARE_LE(std::abs(quality_in<D>(mapped_regular<D>(I, 0.3), target) - 1), 1e-6);
    double last = 1;
    for (const double factor : {1.2, 1.5, 2.0, 4.0}) {
        const double large = quality_in<D>(mapped_regular<D>(I, 0.3 * factor), target);
        const double small = quality_in<D>(mapped_regular<D>(I, 0.3 / factor), target);
        QCOMPARE_LE(std::abs(large - std::pow(factor, -D)), 1e-6);
        QCOMPARE_LE(std::abs(small - large), 1e-6);
        QCOMPARE_LT(large, last);
        last = large;
    }
    for (const double stretch : {2.0, 10.0, 1e3}) {
        Vec<D> scale = Vec<D>::Ones();
        scale[0] = 1 / stretch;
        const double q = quality_in<D>(mapped_regular<D>(scale.asDiagonal(), 0.3), target);
        QCOMPARE_LT(q, last < 1 ? 0.8 : last);
        last = q;
    }
    QCOMPARE_LT(last, 0.01);
}

template <int D>
void rate_stretched_elements() {
    std::mt19937 random(7);
    for (int n = 0; n < 200; ++n) {
        auto x = reference::stretched_simplex<D>(random, std::pow(10.0, n % 7));
        const MetricField<D> own(D + 1, element_metric<D>(x));
        QCOMPARE_LE(std::abs(quality_in<D>(x, own) - 1), 1e-5);
        // Sizes only: directions do not matter.
        MetricField<D> turned = own;
        for (Metric<D>& m : turned) {
            m.directions = reference::random_rotation<D>(random);
        }
        QCOMPARE(quality_in<D>(x, turned), quality_in<D>(x, own));
        const Mat<D> Q = reference::random_rotation<D>(random);
        for (Vec<D>& p : x) {
            p = Q * p;
        }
        QCOMPARE_LE(std::abs(quality_in<D>(x, own) - 1), 1e-5);
    }
}

template <int D>
void compare_with_eigenvalues() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0.2, 3);
    for (int n = 0; n < 200; ++n) {
        const auto x = reference::stretched_simplex<D>(random, 1 + 5 * (n % 9));
        MetricField<D> target(D + 1);
        const Metric<D> own = element_metric<D>(x);
        for (Metric<D>& m : target) {
            m.sizes = own.sizes * uniform(random);
        }
        const double q = quality_in<D>(x, target);
        QCOMPARE_LE(q, 1.0 + 1e-6);
        QCOMPARE_LE(std::abs(q - direct_quality<D>(x, target)), 1e-5 * q);
    }
}

} // namespace

class SizeQualityTest : public QObject {
    Q_OBJECT
private slots:
    void is_one_for_the_asked_size_and_falls_on_both_sides();
    void is_one_for_stretched_elements_of_the_asked_sizes_however_turned();
    void agrees_with_eigenvalues();
    void is_zero_for_flat_elements();
};

void SizeQualityTest::is_one_for_the_asked_size_and_falls_on_both_sides() {
    rate_regular_simplices<2>();
    rate_regular_simplices<3>();
}

void SizeQualityTest::is_one_for_stretched_elements_of_the_asked_sizes_however_turned() {
    rate_stretched_elements<2>();
    rate_stretched_elements<3>();
}

void SizeQualityTest::agrees_with_eigenvalues() {
    compare_with_eigenvalues<2>();
    compare_with_eigenvalues<3>();
}

void SizeQualityTest::is_zero_for_flat_elements() {
    QCOMPARE(quality_in<2>({Vec<2>{0, 0}, {1, 0}, {3, 0}}, isotropic<2>(3, 1)), 0.0);
    QCOMPARE(quality_in<3>({Vec<3>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, isotropic<3>(4, 1)),
             0.0);
    QCOMPARE(quality_in<3>({Vec<3>{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, isotropic<3>(4, 1)),
             0.0);
}

QTEST_APPLESS_MAIN(SizeQualityTest)
#include "size_quality_test.moc"
