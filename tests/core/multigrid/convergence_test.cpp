// SPDX-License-Identifier: AGPL-3.0-or-later
/// What the whole program is for: multigrid converges on our hierarchies at the rate of theory, and
/// not on those coarsened with as many nodes in all directions.
#include "core/multigrid/study.h"
#include "tests/core/multigrid/grids.h"

#include <QTest>

using namespace ameco;

namespace {

double two_grid_factor(const LevelEquations& equations, std::size_t k, SmootherKind kind) {
    CycleOptions options;
    options.smoother.kind = kind;
    return two_grid(equations, k, options, exact_solver(equations, k + 1)).value;
}

LevelEquations poisson(const grids::Grids<3>& g,
                       CoarseOperator kind = CoarseOperator::rediscretised) {
    return level_equations(g.meshes, g.transfers, ModelProblem<3>(), kind);
}

Mesh<3> tall_layer(const char* aspect_ratio, const char* growth, const char* displace) {
    return grids::layer<3>({{"nx", "8"},
                            {"ny", "8"},
                            {"nz", "32"},
                            {"aspect-ratio", aspect_ratio},
                            {"growth", growth},
                            {"displace", displace}});
}

/// Layers on a curved wall, largest aspect ratio 4e5, and all that lies between them and the
/// isotropic far field.
const grids::Grids<3>& ellipsoid() {
    static const grids::Grids<3> g = grids::coarsened(
        std::get<Mesh<3>>(make_case(
            "shell",
            {{"a", "3"}, {"b", "2"}, {"c", "1"}, {"aspect-ratio", "1e5"}, {"frequency", "4"}})),
        4);
    return g;
}

/// A regular cube and every other of its nodes.
grids::Grids<3> every_other_node() {
    grids::Grids<3> g;
    for (const char* n : {"12", "6"}) {
        g.meshes.push_back(std::get<Mesh<3>>(make_case("cube", {{"n", n}, {"displace", "0"}})));
    }
    g.transfers.push_back(make_transfer(g.meshes[0], g.meshes[1]));
    return g;
}

} // namespace

class ConvergenceTest : public QObject {
    Q_OBJECT
private slots:
    void two_grids_reach_the_theoretical_factor_in_layers_data();
    void two_grids_reach_the_theoretical_factor_in_layers();
    void the_last_layers_converge_like_the_first();
    void cycles_do_not_feel_the_aspect_ratio();
    void cycles_converge_by_themselves_on_an_ellipsoid_data();
    void cycles_converge_by_themselves_on_an_ellipsoid();
    void steps_of_least_energy_keep_every_pair_of_an_ellipsoid_below_three_tenths();
    void isotropic_levels_converge_no_slower_than_every_other_node_does();
    void coarse_matrices_of_all_kinds_agree_on_nested_spaces();
    void full_coarsening_by_the_same_ratio_fails();
    void one_node_too_many_on_one_line_is_felt_and_found();
    void smoothers_leave_out_what_continues_a_line();
};

void ConvergenceTest::two_grids_reach_the_theoretical_factor_in_layers_data() {
    QTest::addColumn<QByteArray>("aspect_ratio");
    QTest::addColumn<QByteArray>("growth");
    QTest::addColumn<QByteArray>("displace");
    QTest::addColumn<int>("nodes_per_part");
    for (const char* aspect_ratio : {"1e2", "1e4", "1e6"}) {
        for (const char* growth : {"1", "1.2"}) {
            for (const char* displace : {"0", "0.2"}) {
                QTest::addRow("aspect ratio %s, growth %s, displaced by %s", aspect_ratio, growth,
                              displace)
                    << QByteArray(aspect_ratio) << QByteArray(growth) << QByteArray(displace)
                    << 1000000;
            }
        }
    }
    for (const char* aspect_ratio : {"1e2", "1e6"}) {
        QTest::addRow("aspect ratio %s, in parts for threads", aspect_ratio)
            << QByteArray(aspect_ratio) << QByteArray("1.2") << QByteArray("0.2") << 300;
    }
}

void ConvergenceTest::two_grids_reach_the_theoretical_factor_in_layers() {
    QFETCH(QByteArray, aspect_ratio);
    QFETCH(QByteArray, growth);
    QFETCH(QByteArray, displace);
    QFETCH(int, nodes_per_part);
    CoarsenOptions options;
    options.nodes_per_part = static_cast<std::size_t>(nodes_per_part);
    const auto g = grids::coarsened(
        tall_layer(aspect_ratio.constData(), growth.constData(), displace.constData()), 4, options);
    const LevelEquations equations = poisson(g);
    for (std::size_t k = 0; k < 4; ++k) {
        const LevelStructure structure = level_structure(g.meshes[k]);
        if (structure.lines.node_count < static_cast<std::int64_t>(g.meshes[k].points.size())) {
            break; // not all of it is layers
        }
        const double jacobi = two_grid_factor(equations, k, SmootherKind::jacobi);
        const double gauss_seidel = two_grid_factor(equations, k, SmootherKind::gauss_seidel);
        QVERIFY2(jacobi <= 0.115, qPrintable(QString("level %1: %2").arg(k).arg(jacobi)));
        QVERIFY2(gauss_seidel <= 0.20,
                 qPrintable(QString("level %1: %2").arg(k).arg(gauss_seidel)));
    }
}

void ConvergenceTest::the_last_layers_converge_like_the_first() {
    // Four levels on, cells are 6 times as long as high: edges can be swapped for their lengths.
    const auto g = grids::coarsened(grids::layer<3>({{"nx", "20"},
                                                     {"ny", "20"},
                                                     {"nz", "48"},
                                                     {"aspect-ratio", "1e2"},
                                                     {"growth", "1"},
                                                     {"displace", "0.2"}}),
                                    5);
    const LevelEquations equations = poisson(g);
    for (std::size_t k = 0; k < 5; ++k) {
        const double jacobi = two_grid_factor(equations, k, SmootherKind::jacobi);
        QVERIFY2(jacobi <= 0.1155, qPrintable(QString("level %1: %2").arg(k).arg(jacobi)));
    }
}

void ConvergenceTest::cycles_do_not_feel_the_aspect_ratio() {
    std::vector<int> iterations;
    for (const char* aspect_ratio : {"1e4", "1e6"}) {
        const auto g = grids::coarsened(tall_layer(aspect_ratio, "1", "0.2"), 3);
        const LevelEquations equations = poisson(g);
        const Vector load = restricted(unit_load(g.meshes[0]), equations.unknowns[0]);
        const CycleStudy study = study_cycle(equations, {}, load);
        QVERIFY2(study.factor <= 0.21, qPrintable(QString::number(study.factor)));
        QVERIFY(study.krylov.iterations <= 8);
        iterations.push_back(study.krylov.iterations);
    }
    QVERIFY(std::abs(iterations[0] - iterations[1]) <= 1);
}

void ConvergenceTest::cycles_converge_by_themselves_on_an_ellipsoid_data() {
    QTest::addColumn<CoarseOperator>("kind");
    for (const CoarseOperator kind : all_coarse_operators) {
        QTest::newRow(name(kind).data()) << kind;
    }
}

void ConvergenceTest::cycles_converge_by_themselves_on_an_ellipsoid() {
    QFETCH(CoarseOperator, kind);
    const LevelEquations equations = poisson(ellipsoid(), kind);
    const Vector load = restricted(unit_load(ellipsoid().meshes[0]), equations.unknowns[0]);
    CycleOptions options;
    options.before = options.after = 2;
    const CycleStudy study = study_cycle(equations, options, load);
    QVERIFY2(study.factor <= 0.3, qPrintable(QString::number(study.factor)));
    QVERIFY(study.krylov.iterations <= 8);
}

void ConvergenceTest::steps_of_least_energy_keep_every_pair_of_an_ellipsoid_below_three_tenths() {
    const LevelEquations equations = poisson(ellipsoid());
    for (std::size_t k = 0; k + 1 < ellipsoid().meshes.size(); ++k) {
        const double factor =
            two_grid(equations, k, {}, exact_solver(equations, k + 1), StepLength::least_energy)
                .value;
        QVERIFY2(factor <= 0.3, qPrintable(QString("pair %1: %2").arg(k).arg(factor)));
    }
}

void ConvergenceTest::isotropic_levels_converge_no_slower_than_every_other_node_does() {
    // The yardstick for isotropic zones: coarsened by exactly 2 in all directions, the coarse space
    // is part of the fine one, and even then the factor is above 0.3.
    const double ideal =
        two_grid_factor(poisson(every_other_node()), 0, SmootherKind::gauss_seidel);
    QVERIFY2(ideal > 0.3 && ideal < 0.4, qPrintable(QString::number(ideal)));
    const auto ours = grids::coarsened(
        std::get<Mesh<3>>(make_case("cube", {{"n", "12"}, {"diagonals", "random"}})), 2);
    const LevelEquations equations = poisson(ours);
    for (std::size_t k = 0; k < 2; ++k) {
        const double factor = two_grid_factor(equations, k, SmootherKind::gauss_seidel);
        QVERIFY2(factor <= ideal + 0.02,
                 qPrintable(QString("level %1: %2, ideal %3").arg(k).arg(factor).arg(ideal)));
    }
}

void ConvergenceTest::coarse_matrices_of_all_kinds_agree_on_nested_spaces() {
    const auto g = every_other_node();
    const SparseMatrix& P = g.transfers[0].P;
    const ModelProblem<3> problem;
    const SparseMatrix fine_A = assemble(g.meshes[0], problem);
    const SparseMatrix coarse_A = assemble(g.meshes[1], problem);
    const Vector ratios = galerkin_ratios(fine_A, P, coarse_A);
    for (const CoarseOperator kind : all_coarse_operators) {
        const SparseMatrix A =
            coarse_matrix(kind, g.meshes[0], g.meshes[1], P, fine_A, coarse_A, ratios, problem);
        QVERIFY2((A - coarse_A).norm() <= 1e-12 * coarse_A.norm(), name(kind).data());
    }
}

void ConvergenceTest::full_coarsening_by_the_same_ratio_fails() {
    // Twice as many nodes go in all, but along the plate instead of across the layers.
    grids::Grids<3> g;
    g.meshes.push_back(tall_layer("1e4", "1", "0"));
    g.meshes.push_back(grids::layer<3>({{"nx", "4"},
                                        {"ny", "4"},
                                        {"nz", "32"},
                                        {"aspect-ratio", "2e4"},
                                        {"growth", "1"},
                                        {"displace", "0"}}));
    g.transfers.push_back(make_transfer(g.meshes[0], g.meshes[1]));
    QVERIFY(check(g.transfers[0], g.meshes[0], g.meshes[1]).passed());
    QVERIFY(two_grid_factor(poisson(g), 0, SmootherKind::jacobi) >= 0.9);
}

void ConvergenceTest::one_node_too_many_on_one_line_is_felt_and_found() {
    const auto g = grids::coarsened(tall_layer("1e4", "1", "0"), 1);
    const LevelStructure structure = level_structure(g.meshes[0]);
    // Takes a kept node in the middle of a line out of P: its line then has a gap of three, bridged
    // by linear interpolation.
    Transfer t = g.transfers[0];
    const IdVector<NodeId, NodeId> kept = coarse_of(t);
    NodeId victim;
    for (const NodeId v : g.meshes[0].points.ids()) {
        const Lines& l = structure.lines;
        const bool inner = (g.meshes[0].points[v] - Vec<3>(0.5, 0.5, 0)).head<2>().norm() < 1e-9;
        if (inner && l.position[v] == 16 && kept[v].valid()) {
            victim = v;
        }
    }
    QVERIFY(victim.valid());
    const NodeId c = kept[victim];
    NodeId below = structure.lines.previous[victim], above = structure.lines.next[victim];
    below = structure.lines.previous[below];
    above = structure.lines.next[above];
    SparseMatrix Q(t.P.cols(), t.P.cols());
    for (int j = 0; j < Q.cols(); ++j) {
        if (j != c.value()) {
            Q.insert(j, j) = 1;
        }
    }
    Q.insert(c.value(), kept[below].value()) = 0.5;
    Q.insert(c.value(), kept[above].value()) = 0.5;
    t.P = SparseMatrix(t.P * Q);
    LevelEquations equations = poisson(g);
    std::vector<NodeId> unknowns;
    for (const NodeId v : equations.unknowns[1]) {
        if (v != c) {
            unknowns.push_back(v);
        }
    }
    equations.matrices.P[0] = restricted(t.P, equations.unknowns[0], unknowns);
    equations.unknowns[1] = unknowns;
    equations.matrices.A[1] = galerkin_product(equations.matrices.A[0], equations.matrices.P[0]);
    const Solver coarse = direct_solver(equations.matrices.A[1]);
    const ConvergenceFactor slow =
        two_grid(equations, 0, {{SmootherKind::jacobi}, 1, 1, 1}, coarse);
    QVERIFY2(slow.value > 0.3, qPrintable(QString::number(slow.value)));
    t.parent[c] = NodeId();
    t.kind[victim] = TransferKind::interpolated;
    const ErrorMode<3> mode =
        examine_error(g.meshes[0], structure, t, slow.slowest, equations.matrices.A[0].diagonal(),
                      equations.unknowns[0], equations.ratios[0]);
    QVERIFY(mode.worst[0].node == victim);
    QCOMPARE(mode.worst[0].gap, 3);
    QVERIFY(mode.worst[0].findings.find("gap") != std::string::npos);
    QVERIFY(mode.carriers < 40);
}

void ConvergenceTest::smoothers_leave_out_what_continues_a_line() {
    const auto unknowns_on_lines = [](const Mesh<3>& mesh) {
        const auto unknowns = free_nodes(mesh, ModelProblem<3>());
        const UnknownLines lines = smoother_lines(mesh, make_couplings(mesh), unknowns);
        std::size_t sum = 0;
        for (const std::vector<int>& line : lines) {
            sum += line.size();
        }
        return sum;
    };
    const Mesh<3> layer = tall_layer("1e4", "1", "0");
    QCOMPARE(unknowns_on_lines(layer), std::size_t{7 * 7 * 31}); // all that are not on the boundary
    const auto wing = std::get<Mesh<3>>(make_case("onera-m6", {{"preset", "m6-8k"}}));
    const auto on_lines = static_cast<std::size_t>(level_structure(wing).lines.node_count);
    QVERIFY(unknowns_on_lines(wing) > on_lines / 2);
    LineOptions strong;
    strong.continuation = strong.dominance;
    const auto on_strong = static_cast<std::size_t>(level_structure(wing, strong).lines.node_count);
    QVERIFY(on_strong < on_lines);
    QVERIFY(unknowns_on_lines(wing) <= on_strong);
}

QTEST_APPLESS_MAIN(ConvergenceTest)
#include "convergence_test.moc"
