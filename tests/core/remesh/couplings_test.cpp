// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/couplings.h"

#include "core/cases/cube.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

#include <cmath>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

template <int D>
void compare_both_ways(const Mesh<D>& mesh) {
    const Couplings c = make_couplings(mesh);
    for (const NodeId v : mesh.points.ids()) {
        const auto neighbours = std::as_const(c.neighbours)[v];
        double sum = 0, magnitude = 0;
        for (std::size_t i = 0; i < neighbours.size(); ++i) {
            const double value = static_cast<double>(c.at(v)[i]);
            QCOMPARE(c.between(v, neighbours[i]), c.at(v)[i]);
            const double back = static_cast<double>(c.between(neighbours[i], v));
            sum += value;
            magnitude += std::abs(value);
            QCOMPARE_LE(std::abs(value - back),
                        1e-6 * static_cast<double>(c.diagonal[v] + c.diagonal[neighbours[i]]));
        }
        QCOMPARE_GT(c.diagonal[v], 0.0f);
        QCOMPARE_LE(std::abs(static_cast<double>(c.diagonal[v]) - sum), 1e-6 * magnitude);
    }
}

/// The row of an inner node annihilates linear functions: their Laplacian is zero.
template <int D>
void apply_to_linear_functions(const Mesh<D>& mesh) {
    const Couplings c = make_couplings(mesh);
    const GeometryClasses<D> classes = classify_geometry(mesh);
    int inner = 0;
    for (const NodeId v : mesh.points.ids()) {
        if (classes.node[v] != NodeClass::interior) {
            continue;
        }
        ++inner;
        const auto neighbours = std::as_const(c.neighbours)[v];
        Vec<D> residual = Vec<D>::Zero();
        double scale = 0;
        for (std::size_t i = 0; i < neighbours.size(); ++i) {
            const Vec<D> e = mesh.points[neighbours[i]] - mesh.points[v];
            residual += static_cast<double>(c.at(v)[i]) * e;
            scale += std::abs(static_cast<double>(c.at(v)[i])) * e.norm();
        }
        QCOMPARE_LE(residual.norm(), 1e-6 * scale);
    }
    QCOMPARE_GT(inner, 0);
}

} // namespace

class CouplingsTest : public QObject {
    Q_OBJECT
private slots:
    void rows_sum_to_zero_and_are_symmetric();
    void linear_functions_are_harmonic();
    void right_angled_grids_give_the_stencil_of_finite_differences();
    void nodes_without_common_edge_are_not_coupled();
    void obtuse_angles_couple_negatively();
};

void CouplingsTest::rows_sum_to_zero_and_are_symmetric() {
    compare_both_ways(make_cube<2>({.n = 6, .diagonals = Diagonals::random, .shuffle = 2}));
    compare_both_ways(make_cube<3>({.n = 4, .diagonals = Diagonals::random, .shuffle = 2}));
    compare_both_ways(shapes::stretched_strip(4, 20, 1e-9));
    compare_both_ways(shapes::stretched_slab(3, 20, 1e-9));
}

void CouplingsTest::linear_functions_are_harmonic() {
    apply_to_linear_functions(make_cube<2>({.n = 6, .diagonals = Diagonals::random}));
    apply_to_linear_functions(make_cube<3>({.n = 4, .diagonals = Diagonals::random}));
}

void CouplingsTest::right_angled_grids_give_the_stencil_of_finite_differences() {
    // Cells of 1/2 x 1/8: hy / hx = 1/4 along x, 4 along y, nothing along the diagonals.
    const Mesh<2> plane = shapes::rectangle({0, 0.5, 1}, {0, 0.125, 0.25});
    const Couplings c = make_couplings(plane);
    const NodeId v(4);
    QCOMPARE(c.between(v, NodeId(3)), 0.25f);
    QCOMPARE(c.between(v, NodeId(5)), 0.25f);
    QCOMPARE(c.between(v, NodeId(1)), 4.0f);
    QCOMPARE(c.between(v, NodeId(7)), 4.0f);
    QCOMPARE(c.between(v, NodeId(0)), 0.0f);
    QCOMPARE(c.between(v, NodeId(8)), 0.0f);
    QCOMPARE(c.diagonal[v], 8.5f);
    QCOMPARE(c.between(NodeId(0), NodeId(1)), 0.125f); // half of the cells lie at the side
    // Cells of 1/2 x 1/4 x 1/8: hy hz / hx along x, and so on.
    const Mesh<3> space = shapes::box({0, 0.5, 1}, {0, 0.25, 0.5}, {0, 0.125, 0.25});
    const Couplings c3 = make_couplings(space);
    const NodeId centre(13);
    QCOMPARE(c3.between(centre, NodeId(12)), 0.0625f);
    QCOMPARE(c3.between(centre, NodeId(16)), 0.25f);
    QCOMPARE(c3.between(centre, NodeId(22)), 1.0f);
    QCOMPARE(c3.between(centre, NodeId(26)), 0.0f);
    QCOMPARE(c3.diagonal[centre], 2.625f);
}

void CouplingsTest::nodes_without_common_edge_are_not_coupled() {
    const Couplings c = make_couplings(shapes::square(2));
    QCOMPARE(c.between(NodeId(0), NodeId(8)), 0.0f);
    QCOMPARE(c.between(NodeId(2), NodeId(6)), 0.0f);
    QCOMPARE(c.between(NodeId(4), NodeId(4)), 0.0f);
}

void CouplingsTest::obtuse_angles_couple_negatively() {
    // Half the cotangent of the angle at node 2, 120 degrees.
    const double h = std::sqrt(3.0) / 6;
    const Couplings c = make_couplings(
        shapes::from_literals<2>({{0, 0}, {1, 0}, {0.5, h}}, {shapes::nodes(0, 1, 2)}));
    QCOMPARE(c.between(NodeId(0), NodeId(1)), static_cast<float>(-0.5 / std::sqrt(3.0)));
}

QTEST_APPLESS_MAIN(CouplingsTest)
#include "couplings_test.moc"
