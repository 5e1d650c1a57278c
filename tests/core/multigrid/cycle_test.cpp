// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/cycle.h"

#include "core/multigrid/coarse_operator.h"
#include "core/multigrid/invariants.h"
#include "core/multigrid/random_vector.h"

#include <QTest>

#include <cmath>

#include <Eigen/Eigenvalues>

using namespace ameco;

namespace {

/// -u'' on n inner nodes, times h.
SparseMatrix second_difference(int n) {
    SparseMatrix A(n, n);
    for (int i = 0; i < n; ++i) {
        if (i > 0) {
            A.insert(i, i - 1) = -1;
        }
        A.insert(i, i) = 2;
        if (i + 1 < n) {
            A.insert(i, i + 1) = -1;
        }
    }
    A.makeCompressed();
    return A;
}

/// Linear interpolation from (n - 1) / 2 to n inner nodes.
SparseMatrix interpolation(int n) {
    SparseMatrix P(n, (n - 1) / 2);
    for (int j = 0; j < P.cols(); ++j) {
        P.insert(2 * j, j) = 0.5;
        P.insert(2 * j + 1, j) = 1;
        P.insert(2 * j + 2, j) = 0.5;
    }
    P.makeCompressed();
    return P;
}

/// Levels of 2^depth - 1 nodes and coarser.
MultigridMatrices line(int depth, int levels) {
    MultigridMatrices m;
    for (int k = 0; k < levels; ++k) {
        const int n = (1 << (depth - k)) - 1;
        m.A.push_back(0.5 * std::ldexp(1.0, -k) * second_difference(n));
        if (k + 1 < levels) {
            m.P.push_back(interpolation(n));
        }
    }
    return m;
}

double factor(const MultigridMatrices& m, const CycleOptions& options,
              StepLength step = StepLength::full) {
    return convergence_factor(
               m.A[0], Multigrid(m, 0, m.A.size() - 1, options, direct_solver(m.A.back())), step)
        .value;
}

} // namespace

class CycleTest : public QObject {
    Q_OBJECT
private slots:
    void two_grid_jacobi_on_a_line_has_the_theoretical_factor();
    void a_w_cycle_is_as_good_as_two_grids();
    void steps_of_least_energy_converge_where_full_ones_overshoot();
    void the_cycle_is_a_symmetric_preconditioner_data();
    void the_cycle_is_a_symmetric_preconditioner();
    void conjugate_gradients_solve();
    void gmres_solves_unsymmetric_systems();
    void lines_are_solved_exactly();
    void stiffening_leaves_the_galerkin_operator_alone();
    void stiffening_keeps_constants_and_never_softens();
};

void CycleTest::two_grid_jacobi_on_a_line_has_the_theoretical_factor() {
    // Trottenberg et al. 2001: damped Jacobi 2/3 reduces each pair of modes by 1/3 per step.
    const auto m = line(9, 2);
    QVERIFY(std::abs(factor(m, {{SmootherKind::jacobi}, 1, 1, 1}) - 1.0 / 9) < 1e-3);
    const double half = factor(m, {{SmootherKind::jacobi}, 1, 0, 1});
    // One step alone is not symmetric: its factor over ten cycles comes near the limit from below.
    QVERIFY2(std::abs(half - 1.0 / 3) < 1e-2, qPrintable(QString::number(half)));
}

void CycleTest::a_w_cycle_is_as_good_as_two_grids() {
    const CycleOptions w{{SmootherKind::jacobi}, 1, 1, 2};
    QVERIFY(factor(line(9, 5), w) < 0.14);
}

void CycleTest::steps_of_least_energy_converge_where_full_ones_overshoot() {
    const CycleOptions options{{SmootherKind::jacobi}, 1, 1, 1};
    auto m = line(7, 2);
    QVERIFY(factor(m, options, StepLength::least_energy) <= factor(m, options));
    m.A[1] *= 0.2; // five times too soft
    QVERIFY(factor(m, options) > 3);
    // The cycle's corrections are then 1 - 1/9 to 5 times what they should be: steepest descent's
    // bound is (5 - 8/9) / (5 + 8/9).
    const double least = factor(m, options, StepLength::least_energy);
    QVERIFY2(least < 0.7, qPrintable(QString::number(least)));
}

void CycleTest::the_cycle_is_a_symmetric_preconditioner_data() {
    QTest::addColumn<int>("kind");
    for (const SmootherKind kind : {SmootherKind::jacobi, SmootherKind::gauss_seidel,
                                    SmootherKind::chebyshev, SmootherKind::line}) {
        QTest::addRow("%s", std::string(name(kind)).c_str()) << static_cast<int>(kind);
    }
}

void CycleTest::the_cycle_is_a_symmetric_preconditioner() {
    QFETCH(int, kind);
    const auto m = line(6, 3);
    const Multigrid solver(m, 0, 2, {{static_cast<SmootherKind>(kind)}, 2, 2, 1},
                           direct_solver(m.A.back()));
    const Solver B = as_preconditioner(solver);
    const Vector x = random_vector(63, 1), y = random_vector(63, 2);
    QVERIFY(std::abs(x.dot(B(y)) - y.dot(B(x))) < 1e-12 * x.norm() * B(y).norm());
    QVERIFY(x.dot(B(x)) > 0);
}

void CycleTest::conjugate_gradients_solve() {
    const auto m = line(7, 4);
    const Multigrid solver(m, 0, 3, {}, direct_solver(m.A.back()));
    const Vector x = random_vector(127);
    const auto result = conjugate_gradients(m.A[0], m.A[0] * x, as_preconditioner(solver), 1e-12);
    QVERIFY(result.converged);
    QVERIFY((result.x - x).norm() < 1e-9 * x.norm());
    QCOMPARE(result.residuals.size(), static_cast<std::size_t>(result.iterations + 1));
}

void CycleTest::gmres_solves_unsymmetric_systems() {
    SparseMatrix A = second_difference(40);
    for (int i = 1; i < 40; ++i) {
        A.coeffRef(i, i - 1) -= 0.7;
        A.coeffRef(i, i) += 0.7;
    }
    const Vector x = random_vector(40);
    const auto result = gmres(
        A, A * x, [](const Vector& r) { return r; }, 1e-12, 60);
    QVERIFY(result.converged);
    QVERIFY((result.x - x).norm() < 1e-9 * x.norm());
    const auto direct = direct_solver(A, false);
    QVERIFY((direct(A * x) - x).norm() < 1e-10 * x.norm());
}

void CycleTest::lines_are_solved_exactly() {
    const SparseMatrix A = second_difference(20);
    std::vector<int> all;
    for (int i = 0; i < 20; ++i) {
        all.push_back(i);
    }
    SmootherOptions options{SmootherKind::line};
    options.damping = 1;
    const Smoother smoother(A, options, {all});
    const Vector x = random_vector(20);
    Vector y = Vector::Zero(20);
    smoother.before(A * x, y, 1);
    QVERIFY((x - y).norm() < 1e-12);
}

void CycleTest::stiffening_leaves_the_galerkin_operator_alone() {
    const SparseMatrix A = second_difference(31), P = interpolation(31);
    const SparseMatrix G = galerkin_product(A, P);
    const Vector ratios = galerkin_ratios(A, P, G);
    QVERIFY((ratios - Vector::Ones(15)).cwiseAbs().maxCoeff() < 1e-14);
    QVERIFY((stiffened(G, ratios) - G).norm() < 1e-14);
}

void CycleTest::stiffening_keeps_constants_and_never_softens() {
    SparseMatrix A = second_difference(15);
    A.coeffRef(0, 0) = A.coeffRef(14, 14) = 1; // Neumann: constants in the kernel
    Vector ratios = Vector::Ones(15) + random_vector(15);
    const SparseMatrix S = stiffened(A, ratios);
    QVERIFY((S * Vector::Ones(15)).norm() < 1e-13);
    const Eigen::MatrixXd more = Eigen::MatrixXd(S - A);
    QVERIFY((more - more.transpose()).norm() < 1e-14);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(more);
    QVERIFY(eigen.eigenvalues().minCoeff() > -1e-13);
    QVERIFY(more.norm() > 0.1);
}

QTEST_APPLESS_MAIN(CycleTest)
#include "cycle_test.moc"
