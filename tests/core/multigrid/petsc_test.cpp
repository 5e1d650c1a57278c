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

} // namespace

class PetscTest : public QObject {
    Q_OBJECT
private slots:
    void the_manuals_script_needs_as_many_iterations_as_we_do();
};

void PetscTest::the_manuals_script_needs_as_many_iterations_as_we_do() {
    QProcess python;
    QString program;
    // Debian's petsc4py looks for this, unless its development packages made a link.
    const QStringList builds = QDir("/usr/lib/petscdir").entryList({"petsc3*"}, QDir::Dirs);
    if (!qEnvironmentVariableIsSet("PETSC_DIR") && !builds.isEmpty()) {
        const QDir build("/usr/lib/petscdir/" + builds.front());
        const QStringList kinds = build.entryList({"*-real"}, QDir::Dirs);
        if (!kinds.isEmpty()) {
            qputenv("PETSC_DIR", build.filePath(kinds.front()).toLocal8Bit());
        }
    }
    // Another Python may come first in PATH than that of the system, which has Debian's packages.
    for (const char* candidate : {"python3", "/usr/bin/python3"}) {
        python.start(candidate, {"-c", "import petsc4py"});
        if (program.isEmpty() && python.waitForFinished() && python.exitCode() == 0) {
            program = candidate;
        }
        python.waitForFinished();
    }
    if (program.isEmpty()) {
        QSKIP("petsc4py is not installed (Debian: python3-petsc4py)");
    }
    const auto g = grids::coarsened(
        grids::layer<3>({{"nx", "8"}, {"ny", "8"}, {"nz", "24"}, {"aspect-ratio", "1e4"}}), 3);
    const LevelEquations equations =
        level_equations(g.meshes, g.transfers, ModelProblem<3>(), CoarseOperator::rediscretised);
    const Vector load = restricted(unit_load(g.meshes[0]), equations.unknowns[0]);
    const QTemporaryDir folder;
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
    QFile out(folder.filePath("pcmg.py"));
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(script());
    out.close();
    python.start(program, {folder.filePath("pcmg.py"), folder.path()});
    QVERIFY(python.waitForFinished(120000));
    const QString answer = QString::fromUtf8(python.readAllStandardOutput());
    const auto match = QRegularExpression("iterations (\\d+)").match(answer);
    QVERIFY2(match.hasMatch(), python.readAllStandardError().constData());
    QVERIFY(answer.contains("converged True"));
    const int ours = study_cycle(equations, {}, load).krylov.iterations;
    QVERIFY2(std::abs(match.captured(1).toInt() - ours) <= 1,
             qPrintable(QString("PETSc %1, ours %2").arg(match.captured(1)).arg(ours)));
}

QTEST_APPLESS_MAIN(PetscTest)
#include "petsc_test.moc"
