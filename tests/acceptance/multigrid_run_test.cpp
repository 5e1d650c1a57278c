// SPDX-License-Identifier: AGPL-3.0-or-later
/// ameco transfer and ameco multigrid, as users run them.
#include "tests/acceptance/run_ameco.h"

using namespace ameco::test;

class MultigridRunTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void transfer_writes_a_row_per_fine_node();
    void transfer_fails_where_a_coarse_node_is_not_used();
    void multigrid_reports_pairs_and_the_whole_hierarchy();
    void every_method_converges_data();
    void every_method_converges();
    void multigrid_writes_a_picture_and_matrices();
    void multigrid_writes_the_slowest_errors();
    void refuses_data();
    void refuses();

private:
    Workspace here_;
};

void MultigridRunTest::initTestCase() {
    QCOMPARE(here_
                 .ameco({"case", "layer", "--nx", "6", "--ny", "6", "--nz", "16", "--aspect-ratio",
                         "1e4", "--growth", "1", "-o", "fine.meshb"})
                 .code,
             0);
    QCOMPARE(here_.ameco({"case", "cube", "--n", "4", "-o", "cube.meshb"}).code, 0);
    QCOMPARE(here_.ameco({"coarsen", "fine.meshb", "-o", "levels", "-n", "2"}).code, 0);
}

void MultigridRunTest::transfer_writes_a_row_per_fine_node() {
    const Run run =
        here_.ameco({"transfer", "fine.meshb", "levels/level_1.meshb", "-o", "P.mtx", "--json"});
    QVERIFY2(run.code == 0, run.text());
    const auto check = run.json()["check"];
    QVERIFY(check["passed"].get<bool>());
    // 7 x 7 x 17 nodes and every other layer of them.
    QCOMPARE(check["nested"].get<int>(), 7 * 7 * 9);
    QCOMPARE(check["interpolated"].get<int>(), 7 * 7 * 8);
    QCOMPARE(check["projected"].get<int>(), 0);
    const QList<QByteArray> lines = here_.content("P.mtx").split('\n');
    QVERIFY(lines[0].startsWith("%%MatrixMarket matrix coordinate real general"));
    QVERIFY2(lines[1].startsWith("833 441 "), lines[1]);
}

void MultigridRunTest::transfer_fails_where_a_coarse_node_is_not_used() {
    const Run run = here_.ameco({"transfer", "cube.meshb", "fine.meshb", "-o", "Q.mtx"});
    QVERIFY2(run.code == 3, run.text());
    QVERIFY2(run.err.contains("coarse nodes that no fine node refers to"), run.text());
}

void MultigridRunTest::multigrid_reports_pairs_and_the_whole_hierarchy() {
    const Run json = here_.ameco({"multigrid", "levels", "--json"});
    QVERIFY2(json.code == 0, json.text());
    const auto result = json.json();
    QCOMPARE(result["pairs"].size(), std::size_t{2});
    for (const auto& pair : result["pairs"]) {
        QVERIFY(pair["two_grid_jacobi"].get<double>() <= 0.115);
        QVERIFY(pair["two_grid_gauss_seidel"].get<double>() <= 0.20);
        QCOMPARE(pair["invariants"]["gaps"].get<int>(), 0);
        QCOMPARE(pair["invariants"]["lineless_elements"].get<int>(), 0);
    }
    QVERIFY(result["factor"].get<double>() <= 0.21);
    QVERIFY(result["converged"].get<bool>());
    QVERIFY(result["iterations"].get<int>() <= 8);
    const Run text = here_.ameco({"multigrid", "levels"});
    QVERIFY2(text.code == 0 && text.out.contains("Jacobi(1,1)") &&
                 text.out.contains("of CG to 1e-8"),
             text.text());
}

void MultigridRunTest::every_method_converges_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("most_iterations");
    for (const char* smoother : {"jacobi", "gauss-seidel", "chebyshev", "line"}) {
        QTest::newRow(smoother) << QStringList{"--smoother", smoother} << 16;
    }
    for (const char* kind : {"rediscretised", "stiffened", "local-galerkin", "galerkin"}) {
        QTest::newRow(kind) << QStringList{"--operator", kind} << 8;
    }
    QTest::newRow("V(2,2)") << QStringList{"--steps", "2"} << 6;
    QTest::newRow("W-cycle") << QStringList{"--w-cycle"} << 8;
    QTest::newRow("one Dirichlet patch") << QStringList{"--dirichlet", "1"} << 16;
    QTest::newRow("diffusion across the layers only, almost")
        << QStringList{"--diffusion", "1e-6", "1e-6", "1"} << 8;
    QTest::newRow("a full tensor")
        << QStringList{"--diffusion", "1", "0.5", "0", "1", "0", "1"} << 12;
    QTest::newRow("convection, GMRES") << QStringList{"--velocity", "50", "0", "0"} << 16;
}

void MultigridRunTest::every_method_converges() {
    QFETCH(QStringList, options);
    QFETCH(int, most_iterations);
    const Run run = here_.ameco(QStringList{"multigrid", "levels", "--json"} + options);
    QVERIFY2(run.code == 0, run.text());
    const auto result = run.json();
    QVERIFY2(result["converged"].get<bool>(), run.text());
    QVERIFY2(result["iterations"].get<int>() <= most_iterations, run.text());
    QVERIFY2(result["residuals"].back().get<double>() <= 1e-8, run.text());
}

void MultigridRunTest::multigrid_writes_a_picture_and_matrices() {
    const Run run =
        here_.ameco({"multigrid", "levels", "--plot", "convergence.svg", "--matrices", "matrices"});
    QVERIFY2(run.code == 0, run.text());
    QVERIFY(here_.content("convergence.svg").contains("<polyline"));
    QCOMPARE(here_.files("matrices"),
             (QStringList{"A_0.petsc", "A_1.petsc", "A_2.petsc", "P_0.mtx", "P_0.petsc", "P_1.mtx",
                          "P_1.petsc", "b.petsc"}));
}

void MultigridRunTest::multigrid_writes_the_slowest_errors() {
    const Run run = here_.ameco({"multigrid", "levels", "--modes", "modes", "--json"});
    if (run.code == 8) {
        QSKIP("built without VTK");
    }
    QVERIFY2(run.code == 0, run.text());
    QCOMPARE(here_.files("modes"), (QStringList{"mode_0.vtu", "mode_1.vtu"}));
    QVERIFY(here_.content("modes/mode_0.vtu").contains("Name=\"slowest_error\""));
    // The mesh beside it is the fine one, as it was.
    QVERIFY(here_.ameco({"check", "modes/mode_0.vtu"}).code == 0);
}

void MultigridRunTest::refuses_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* what, const QStringList& arguments, int code,
                        const char* part) {
        QTest::newRow(what) << arguments << code << QString(part);
    };
    row("no folder", {"multigrid", "nowhere"}, 4, "nowhere");
    row("a patch that is not there", {"multigrid", "levels", "--dirichlet", "99"}, 2, "patch 99");
    row("a velocity of another dimension", {"multigrid", "levels", "--velocity", "1", "0"}, 2,
        "needs 3 numbers");
    row("diffusion of another dimension", {"multigrid", "levels", "--diffusion", "1", "1"}, 2,
        "needs 3 numbers, or 6");
    row("diffusion that is not positive", {"multigrid", "levels", "--diffusion", "1", "1", "0"}, 2,
        "positive definite");
    row("a folder that is a file", {"multigrid", "levels", "--modes", "fine.meshb"}, 4,
        "cannot be made a folder");
    row("a picture of an unknown kind", {"multigrid", "levels", "--plot", "plot.bmp"}, 2, ".svg");
    row("an unknown operator", {"multigrid", "levels", "--operator", "soft"}, 2, "rediscretised");
    row("a matrix of an unknown kind", {"transfer", "fine.meshb", "cube.meshb", "-o", "P.xyz"}, 2,
        ".mtx or .petsc");
}

void MultigridRunTest::refuses() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, part);
    const Run run = here_.ameco(arguments);
    QVERIFY2(run.code == code, run.text());
    QVERIFY2(run.err.contains(part), run.text());
    QCOMPARE(run.err.trimmed().count('\n'), 0);
    QVERIFY(!QFile::exists(here_.path("plot.bmp")) && !QFile::exists(here_.path("P.xyz")));
}

QTEST_GUILESS_MAIN(MultigridRunTest)
#include "multigrid_run_test.moc"
