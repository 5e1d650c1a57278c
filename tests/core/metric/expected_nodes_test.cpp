// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/expected_nodes.h"

#include "tests/support/shapes.h"

#include <QTest>

#include <cmath>

using namespace ameco;

namespace {

template <int D>
MetricField<D> constant_field(const Mesh<D>& mesh, const Vec<D>& sizes) {
    Metric<D> m;
    m.sizes = sizes;
    return MetricField<D>(mesh.points.size(), m);
}

} // namespace

class ExpectedNodesTest : public QObject {
    Q_OBJECT
private slots:
    void counts_a_box_as_its_lattice_does();
    void counts_a_rectangle_as_its_lattice_does();
    void tends_to_the_complexity_for_fine_meshes();
    void does_not_depend_on_the_numbering_of_faces();
};

void ExpectedNodesTest::counts_a_box_as_its_lattice_does() {
    // A lattice of right-angled cells has sqrt(2) times fewer nodes than one of regular tets, and
    // sqrt(3)/2 times fewer on a face; with sizes h these two factors are all that differs from
    // abc + ab + bc + ca + a + b + c.
    const Mesh<3> mesh = shapes::cube(4);
    const double a = 1 / 0.1, b = 1 / 0.2, c = 1 / 0.25;
    const double found = expected_nodes(mesh, constant_field<3>(mesh, {0.1, 0.2, 0.25}));
    const double lattice =
        std::sqrt(2.0) * a * b * c + (a * b + b * c + c * a) * 2 / std::sqrt(3.0) + a + b + c;
    QVERIFY(std::abs(found / lattice - 1) < 1e-12);
}

void ExpectedNodesTest::counts_a_rectangle_as_its_lattice_does() {
    const Mesh<2> mesh = shapes::rectangle({0, 0.5, 1}, {0, 1, 2});
    const double found = expected_nodes(mesh, constant_field<2>(mesh, {0.1, 0.1}));
    QVERIFY(std::abs(found / (2 / std::sqrt(3.0) * 200 + 30) - 1) < 1e-12);
}

void ExpectedNodesTest::tends_to_the_complexity_for_fine_meshes() {
    const Mesh<3> mesh = shapes::cube(3);
    const double coarse = expected_nodes(mesh, constant_field<3>(mesh, Vec<3>::Constant(2e-3)));
    const double fine = expected_nodes(mesh, constant_field<3>(mesh, Vec<3>::Constant(1e-3)));
    QVERIFY(std::abs(fine / coarse - 8) < 0.02);
    QVERIFY(fine / coarse < 8);
}

void ExpectedNodesTest::does_not_depend_on_the_numbering_of_faces() {
    Mesh<3> mesh = shapes::cube(3);
    const auto field = constant_field<3>(mesh, {0.1, 0.1, 0.3});
    const double before = expected_nodes(mesh, field);
    std::reverse(mesh.faces.begin(), mesh.faces.end());
    for (Facet<3>& f : mesh.faces) {
        std::rotate(f.begin(), f.begin() + 1, f.end());
    }
    QVERIFY(std::abs(expected_nodes(mesh, field) / before - 1) < 1e-12);
}

QTEST_APPLESS_MAIN(ExpectedNodesTest)
#include "expected_nodes_test.moc"
