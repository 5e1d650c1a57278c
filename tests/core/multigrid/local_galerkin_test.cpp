// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/local_galerkin.h"

#include "core/multigrid/invariants.h"
#include "core/multigrid/study.h"
#include "tests/core/multigrid/grids.h"

#include <QTest>

#include <cmath>

#include <Eigen/SparseCholesky>

using namespace ameco;

class LocalGalerkinTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void is_rediscretised_where_nothing_is_too_soft();
    void is_galerkin_where_everything_is();
    void stays_symmetric_positive_definite_with_constants_in_its_kernel();
    void removes_what_makes_cycles_diverge();

private:
    [[nodiscard]] SparseMatrix with_limit(double limit) const {
        return local_galerkin(wing_.meshes[0], wing_.meshes[1], wing_.transfers[0].P, ratios_,
                              ModelProblem<3>(), limit);
    }

    grids::Grids<3> wing_;
    SparseMatrix fine_, coarse_;
    Vector ratios_;
};

void LocalGalerkinTest::initTestCase() {
    CoarsenOptions options;
    options.least_stiffness = 0; // swaps that make nodes soft are refused otherwise
    wing_ = grids::coarsened(std::get<Mesh<3>>(make_case("onera-m6", {{"preset", "m6-8k"}})), 3,
                             options);
    fine_ = assemble(wing_.meshes[0], ModelProblem<3>());
    coarse_ = assemble(wing_.meshes[1], ModelProblem<3>());
    ratios_ = galerkin_ratios(fine_, wing_.transfers[0].P, coarse_);
    QVERIFY2(ratios_.maxCoeff() > 2, "the case has soft places");
}

void LocalGalerkinTest::is_rediscretised_where_nothing_is_too_soft() {
    QVERIFY((with_limit(ratios_.maxCoeff() + 1) - coarse_).norm() <= 1e-12 * coarse_.norm());
    const auto layer = grids::coarsened(grids::layer<2>({{"aspect-ratio", "1e4"}}), 1);
    const ModelProblem<2> problem;
    const SparseMatrix A = assemble(layer.meshes[1], problem);
    const Vector ratios =
        galerkin_ratios(assemble(layer.meshes[0], problem), layer.transfers[0].P, A);
    const SparseMatrix L =
        local_galerkin(layer.meshes[0], layer.meshes[1], layer.transfers[0].P, ratios, problem);
    QVERIFY((L - A).norm() <= 1e-12 * A.norm());
}

void LocalGalerkinTest::is_galerkin_where_everything_is() {
    const SparseMatrix G = galerkin_product(fine_, wing_.transfers[0].P);
    QVERIFY((with_limit(0) - G).norm() <= 1e-12 * G.norm());
}

void LocalGalerkinTest::stays_symmetric_positive_definite_with_constants_in_its_kernel() {
    for (const double limit : {1.25, 2.0}) {
        const SparseMatrix L = with_limit(limit);
        QVERIFY((L - SparseMatrix(L.transpose())).norm() <= 1e-14 * L.norm());
        const Vector sums = L * Vector::Ones(L.cols());
        QVERIFY(sums.cwiseAbs().maxCoeff() <= 1e-12 * L.diagonal().maxCoeff());
        const auto unknowns = free_nodes(wing_.meshes[1], ModelProblem<3>());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(
            restricted(L, unknowns, unknowns));
        QCOMPARE(factors.info(), Eigen::Success);
        QVERIFY(factors.vectorD().minCoeff() > 0);
        // It costs little where little is soft.
        const auto soft = static_cast<double>((ratios_.array() > limit).count());
        const double denser =
            static_cast<double>(L.nonZeros()) / static_cast<double>(coarse_.nonZeros());
        QVERIFY2(denser < 1.1 + 10 * soft / static_cast<double>(ratios_.size()),
                 qPrintable(QString("%1, %2 soft").arg(denser).arg(soft)));
        const Vector left = galerkin_ratios(fine_, wing_.transfers[0].P, L);
        for (Eigen::Index i = 0; i < left.size(); ++i) {
            QVERIFY(ratios_[i] <= limit || std::abs(left[i] - 1) <= 1e-10);
        }
    }
}

void LocalGalerkinTest::removes_what_makes_cycles_diverge() {
    const auto study = [&](CoarseOperator kind) {
        const LevelEquations equations =
            level_equations(wing_.meshes, wing_.transfers, ModelProblem<3>(), kind);
        return study_cycle(equations, {},
                           restricted(unit_load(wing_.meshes[0]), equations.unknowns[0]));
    };
    const CycleStudy before = study(CoarseOperator::rediscretised);
    const CycleStudy after = study(CoarseOperator::local_galerkin);
    QVERIFY2(before.factor > 0.6, qPrintable(QString::number(before.factor)));
    QVERIFY2(after.factor < 0.5, qPrintable(QString::number(after.factor)));
    QVERIFY(after.krylov.iterations < before.krylov.iterations);
}

QTEST_GUILESS_MAIN(LocalGalerkinTest)
#include "local_galerkin_test.moc"
