// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/element_measures.h"

#include "core/metric/element_metric.h"
#include "tests/core/metric/reference.h"

#include <QTest>

#include <Eigen/LU>

using namespace ameco;

namespace {

/// In its own metric an element is regular and of unit size.
template <int D>
void measure_in_own_metric() {
    std::mt19937 random(11);
    for (int n = 0; n < 200; ++n) {
        const double stretch = std::pow(10.0, n % 6);
        const auto x = reference::stretched_simplex<D>(random, stretch);
        const ElementMeasures<D> m =
            element_measures<D>(x, invert(root_of<D>(element_metric<D>(x))));
        const double error = 1e-13 * stretch * stretch;
        for (const double square : m.squares) {
            QCOMPARE_LE(std::abs(square - 1), error + 1e-12);
        }
        QCOMPARE_LE(std::abs(m.h2 - 1), error + 1e-12);
        QCOMPARE_LE(std::abs(m.volume - 1), error + 1e-12);
        QCOMPARE_LE(std::abs(shape_quality(m) - 1), error + 1e-12);
    }
}

template <int D>
void invert_random_roots() {
    std::mt19937 random(13);
    for (int n = 0; n < 100; ++n) {
        Metric<D> metric;
        metric.directions = reference::random_rotation<D>(random);
        metric.sizes = Vec<D>::LinSpaced(D, 0.1, 1 + n);
        const Tensor<D> s = root_of<D>(metric);
        Mat<D> full;
        int k = 0;
        for (int r = 0; r < D; ++r) {
            for (int c = r; c < D; ++c) {
                full(r, c) = full(c, r) = s[k++];
            }
        }
        const SymmetricInverse<D> inverse = invert(s);
        QCOMPARE_LE(std::abs(inverse.det / full.determinant() - 1), 1e-10);
        const Vec<D> e = Vec<D>::Random();
        const double expected = (full.inverse() * e).squaredNorm();
        const double found = squared_norm(inverse.adj, e) / (inverse.det * inverse.det);
        QCOMPARE_LE(std::abs(found / expected - 1), 1e-9);
    }
}

} // namespace

class ElementMeasuresTest : public QObject {
    Q_OBJECT
private slots:
    void an_element_is_regular_in_its_own_metric() {
        measure_in_own_metric<2>();
        measure_in_own_metric<3>();
    }
    void roots_are_inverted_without_an_eigenproblem() {
        invert_random_roots<2>();
        invert_random_roots<3>();
    }
    void the_mean_is_over_the_nodes() {
        MetricField<2> field(3);
        for (int i = 0; i < 3; ++i) {
            field[NodeId(i)].directions = Mat<2>::Identity();
            field[NodeId(i)].sizes = Vec<2>(1, 2) * (i + 1);
        }
        const Tensor<2> mean =
            mean_root<2>(make_root_field(field), {NodeId(0), NodeId(1), NodeId(2)});
        QCOMPARE(mean[0], 2.0);
        QCOMPARE(mean[1], 0.0);
        QCOMPARE(mean[2], 4.0);
    }
};

QTEST_APPLESS_MAIN(ElementMeasuresTest)
#include "element_measures_test.moc"
