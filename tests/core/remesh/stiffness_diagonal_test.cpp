// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/stiffness_diagonal.h"

#include "core/cases/layer.h"
#include "core/remesh/couplings.h"
#include "tests/core/remesh/swap_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

template <int D>
StiffnessDiagonal<D> sum_of_elements(const Workbench<D>& bench) {
    StiffnessDiagonal<D> sum;
    for (const Simplex<D>& s : bench.mesh.elements) {
        sum.add(bench.edit, s);
    }
    return sum;
}

template <int D>
void compare_with_the_matrix(const Mesh<D>& mesh) {
    const Couplings couplings = make_couplings(mesh);
    const Workbench<D> bench(mesh);
    const StiffnessDiagonal<D> sum = sum_of_elements(bench);
    QCOMPARE(sum.parts().size(), mesh.points.size());
    for (const NodeId v : mesh.points.ids()) {
        const auto expected = static_cast<double>(couplings.diagonal[v]);
        QVERIFY(std::abs(sum[v] - expected) <= 1e-5 * expected);
    }
}

} // namespace

class StiffnessDiagonalTest : public QObject {
    Q_OBJECT
private slots:
    void all_elements_together_have_the_matrix_s_diagonal();
    void is_nothing_beside_the_elements();
};

void StiffnessDiagonalTest::all_elements_together_have_the_matrix_s_diagonal() {
    compare_with_the_matrix(displaced_cube<2>(4, 1));
    compare_with_the_matrix(displaced_cube<3>(3, 2));
    compare_with_the_matrix(make_layer<3>({.nx = 3, .ny = 3, .nz = 6, .aspect_ratio = 1e5}));
}

void StiffnessDiagonalTest::is_nothing_beside_the_elements() {
    const Workbench<2> bench(make_cube<2>({.n = 2}));
    StiffnessDiagonal<2> one;
    const Simplex<2>& s = bench.mesh.elements[ElementId(0)];
    one.add(bench.edit, s);
    for (const NodeId v : bench.mesh.points.ids()) {
        QCOMPARE(one[v] > 0, std::find(s.begin(), s.end(), v) != s.end());
    }
    one.clear();
    QCOMPARE(one[s[0]], 0.0);
}

QTEST_APPLESS_MAIN(StiffnessDiagonalTest)
#include "stiffness_diagonal_test.moc"
