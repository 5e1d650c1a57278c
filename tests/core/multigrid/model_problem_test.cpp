// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/model_problem.h"

#include "core/base/error.h"
#include "core/multigrid/cycle.h"
#include "tests/core/multigrid/grids.h"

#include <QTest>

using namespace ameco;

namespace {

Mesh<3> small_layer() {
    return grids::layer<3>({{"nx", "4"}, {"ny", "4"}, {"nz", "5"}, {"aspect-ratio", "50"}});
}

/// A linear function at the nodes.
template <int D>
Vector linear(const Mesh<D>& mesh, const Vec<D>& g) {
    Vector u(static_cast<Eigen::Index>(mesh.points.size()));
    for (const NodeId v : mesh.points.ids()) {
        u[v.value()] = g.dot(mesh.points[v]);
    }
    return u;
}

} // namespace

class ModelProblemTest : public QObject {
    Q_OBJECT
private slots:
    void stiffness_is_symmetric_with_zero_row_sums();
    void energy_of_a_linear_function_is_its_gradient_squared_times_the_volume();
    void linear_functions_solve_the_interior_equations();
    void upwinding_makes_convection_monotone();
    void upwinding_keeps_row_sums();
    void load_sums_to_the_volume();
    void dirichlet_patches_are_left_out_of_the_unknowns();
    void an_unknown_patch_is_refused();
};

void ModelProblemTest::stiffness_is_symmetric_with_zero_row_sums() {
    const Mesh<3> mesh = small_layer();
    const SparseMatrix A = assemble(mesh, ModelProblem<3>());
    const double scale = A.diagonal().maxCoeff();
    QVERIFY((SparseMatrix(A.transpose()) - A).norm() < 1e-12 * scale);
    QVERIFY((A * Vector::Ones(A.cols())).cwiseAbs().maxCoeff() < 1e-12 * scale);
}

void ModelProblemTest::energy_of_a_linear_function_is_its_gradient_squared_times_the_volume() {
    const Mesh<3> mesh = small_layer();
    ModelProblem<3> problem;
    problem.diffusion << 2, 0.5, 0, 0.5, 1, 0.1, 0, 0.1, 3;
    const Vec<3> g(1, -2, 0.5);
    const Vector u = linear<3>(mesh, g);
    const double energy = u.dot(assemble(mesh, problem) * u);
    const double expected = g.dot(problem.diffusion * g) * unit_load(mesh).sum();
    QVERIFY(std::abs(energy - expected) < 1e-10 * expected);
}

void ModelProblemTest::linear_functions_solve_the_interior_equations() {
    const Mesh<3> mesh = small_layer();
    const SparseMatrix A = assemble(mesh, ModelProblem<3>());
    const Vector r = A * linear<3>(mesh, {1, 2, 3});
    for (const NodeId v : free_nodes(mesh, ModelProblem<3>())) {
        QVERIFY(std::abs(r[v.value()]) < 1e-12 * A.coeff(v.value(), v.value()));
    }
}

void ModelProblemTest::upwinding_makes_convection_monotone() {
    const Mesh<3> mesh = small_layer();
    ModelProblem<3> diffusion, both;
    both.velocity = {100, -30, 7};
    const SparseMatrix C = assemble(mesh, both) - assemble(mesh, diffusion);
    for (Eigen::Index i = 0; i < C.rows(); ++i) {
        for (SparseMatrix::InnerIterator it(C, i); it; ++it) {
            QVERIFY(it.col() == i ? it.value() >= -1e-12 : it.value() <= 1e-12);
        }
    }
}

void ModelProblemTest::upwinding_keeps_row_sums() {
    const Mesh<3> mesh = small_layer();
    ModelProblem<3> problem;
    problem.velocity = {100, -30, 7};
    const SparseMatrix A = assemble(mesh, problem);
    QVERIFY((A * Vector::Ones(A.cols())).cwiseAbs().maxCoeff() < 1e-12 * A.diagonal().maxCoeff());
}

void ModelProblemTest::load_sums_to_the_volume() {
    const Mesh<2> mesh = grids::layer<2>({{"nx", "4"}, {"nz", "3"}, {"aspect-ratio", "4"}});
    double top = 0;
    for (const auto& x : mesh.points) {
        top = std::max(top, x[1]);
    }
    QVERIFY(std::abs(unit_load(mesh).sum() - top) < 1e-14);
}

void ModelProblemTest::dirichlet_patches_are_left_out_of_the_unknowns() {
    const Mesh<3> mesh = small_layer();
    const auto inside = free_nodes(mesh, ModelProblem<3>());
    QCOMPARE(inside.size(), std::size_t(3 * 3 * 4));
    ModelProblem<3> wall;
    wall.dirichlet_patches = {mesh.patch[FaceId(0)]};
    QVERIFY(free_nodes(mesh, wall).size() > inside.size());
}

void ModelProblemTest::an_unknown_patch_is_refused() {
    ModelProblem<3> problem;
    problem.dirichlet_patches = {77};
    QVERIFY_THROWS_EXCEPTION(UsageError, (void)free_nodes(small_layer(), problem));
}

QTEST_APPLESS_MAIN(ModelProblemTest)
#include "model_problem_test.moc"
