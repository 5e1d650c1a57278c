// SPDX-License-Identifier: AGPL-3.0-or-later
/// A real client: the script of docs/user/petsc.md drives PETSc's PCMG with our files.
#include "core/multigrid/matrix_file.h"
#include "core/multigrid/study.h"
#include "tests/core/multigrid/grids.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace ameco;

namespace {

/// The first block of Python in the manual's page.
QByteArray script() {
    QFile page(QStringLiteral(AMECO_SOURCE_DIR "/docs/user/petsc.md"));
    if (!page.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QByteArray text = page.readAll();
    const qsizetype begin = text.indexOf("```python\n") + 10;
    return text.mid(begin, text.indexOf("```", begin) - begin);
}

/// Debian's petsc4py looks for PETSC_DIR, unless PETSc's development packages made a link.
void set_petsc_dir() {
    const QDir root("/usr/lib/petscdir");
    for (const QString& version : root.entryList({"petsc3*"}, QDir::Dirs)) {
        const QDir build(root.filePath(version));
        const QStringList kinds = build.entryList({"*-real"}, QDir::Dirs);
        if (!qEnvironmentVariableIsSet("PETSC_DIR") && !kinds.isEmpty()) {
            qputenv("PETSC_DIR", build.filePath(kinds.front()).toLocal8Bit());
        }
    }
}

/// A Python that has petsc4py; empty if there is none. Another may come first in PATH than that of
/// the system, which has Debian's packages.
QString python_with_petsc() {
    for (const char* candidate : {"python3", "/usr/bin/python3"}) {
        QProcess python;
        python.start(candidate, {"-c", "from petsc4py import PETSc"});
        if (python.waitForFinished() && python.exitStatus() == QProcess::NormalExit &&
            python.exitCode() == 0) {
            return candidate;
        }
    }
    return {};
}

void write_equations(const QDir& folder, const LevelEquations& equations, const Vector& load) {
    const auto file = [&](const QString& name) {
        return std::filesystem::path(folder.filePath(name).toStdString());
    };
    for (std::size_t k = 0; k < equations.matrices.A.size(); ++k) {
        write_petsc_matrix(file(QString("A_%1.petsc").arg(k)), equations.matrices.A[k]);
    }
    for (std::size_t k = 0; k < equations.matrices.P.size(); ++k) {
        write_petsc_matrix(file(QString("P_%1.petsc").arg(k)), equations.matrices.P[k]);
    }
    write_petsc_vector(file("b.petsc"), load);
}

} // namespace

class PetscTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void the_manuals_script_needs_as_many_iterations_as_we_do_data();
    void the_manuals_script_needs_as_many_iterations_as_we_do();

private:
    QString python_;
};

void PetscTest::initTestCase() {
    set_petsc_dir();
    python_ = python_with_petsc();
    if (python_.isEmpty()) {
        QSKIP("petsc4py is not installed (Debian: python3-petsc4py)");
    }
}

void PetscTest::the_manuals_script_needs_as_many_iterations_as_we_do_data() {
    QTest::addColumn<double>("curvature");
    QTest::addColumn<double>("velocity");
    QTest::addColumn<CoarseOperator>("kind");
    QTest::newRow("flat layer, CG") << 0.0 << 0.0 << CoarseOperator::rediscretised;
    QTest::newRow("bent layer, CG, stiffened") << 2.0 << 0.0 << CoarseOperator::stiffened;
    QTest::newRow("flat layer, Galerkin") << 0.0 << 0.0 << CoarseOperator::galerkin;
    QTest::newRow("convection, GMRES") << 0.0 << 50.0 << CoarseOperator::rediscretised;
}

void PetscTest::the_manuals_script_needs_as_many_iterations_as_we_do() {
    QFETCH(double, curvature);
    QFETCH(double, velocity);
    QFETCH(CoarseOperator, kind);
    const auto g = grids::coarsened(grids::layer<3>({{"nx", "8"},
                                                     {"ny", "8"},
                                                     {"nz", "24"},
                                                     {"aspect-ratio", "1e4"},
                                                     {"curvature", std::to_string(curvature)}}),
                                    3);
    ModelProblem<3> problem;
    problem.velocity[0] = velocity;
    const LevelEquations equations = level_equations(g.meshes, g.transfers, problem, kind);
    const Vector load = restricted(unit_load(g.meshes[0]), equations.unknowns[0]);
    const QTemporaryDir folder;
    write_equations(QDir(folder.path()), equations, load);
    QFile out(folder.filePath("pcmg.py"));
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(script());
    out.close();

    QProcess python;
    python.start(python_, {out.fileName(), folder.path(), equations.symmetric ? "cg" : "gmres"});
    QVERIFY(python.waitForFinished(120000));
    const QString answer = QString::fromUtf8(python.readAllStandardOutput());
    const auto match = QRegularExpression("iterations (\\d+)").match(answer);
    QVERIFY2(match.hasMatch(), python.readAllStandardError().constData());
    QVERIFY2(answer.contains("converged True"), qPrintable(answer));
    const KrylovResult ours = study_cycle(equations, {}, load).krylov;
    QVERIFY(ours.converged);
    QVERIFY2(std::abs(match.captured(1).toInt() - ours.iterations) <= 1,
             qPrintable(QString("PETSc %1, ours %2").arg(match.captured(1)).arg(ours.iterations)));
}

QTEST_GUILESS_MAIN(PetscTest)
#include "petsc_test.moc"
