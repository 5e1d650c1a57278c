// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/acceptance/run_ameco.h"

#include <QFileInfo>
#include <QRegularExpression>

using namespace ameco::test;

/// Runs the first page and pages of the manual: the commands after "$ " in their console
/// blocks, in order. What they print must be what stands below them, but for the numbers, which
/// change with the program and the machine. AMECO_UPDATE_DOCS=1 writes the pages anew.
class QuickstartTest : public QObject {
    Q_OBJECT
private slots:
    void prints_what_the_program_prints_data();
    void prints_what_the_program_prints();
};

namespace {

/// The words of a text, without numbers, bars and layout.
QString words_of(QString text) {
    text.replace(QRegularExpression("#+"), " ");
    text.replace(QRegularExpression("[0-9][0-9.,e+-]*"), "0");
    return text.simplified();
}

Run run_line(const Workspace& here, const QString& line) {
    const QString folder = QFileInfo(AMECO_PROGRAM).absolutePath();
    return here.shell("PATH=\"" + folder + ":$PATH\"; LC_ALL=C; " + line);
}

} // namespace

void QuickstartTest::prints_what_the_program_prints_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("first page") << "README.md";
    QTest::newRow("quick start") << "docs/user/quickstart.md";
    QTest::newRow("commands") << "docs/user/commands.md";
    QTest::newRow("surfaces") << "docs/user/surfaces.md";
}

void QuickstartTest::prints_what_the_program_prints() {
    QFETCH(QString, name);
    const QString path = QString(AMECO_SOURCE_DIR) + "/" + name;
    const QStringList lines = QString::fromUtf8(content_of(path)).split('\n');
    const Workspace here;
    if (name.contains("surfaces") &&
        run_line(here, "ameco case cube --n 1 -o c.mesh; ameco convert c.mesh c.stl && "
                       "ameco fill c.stl -o f.mesh")
                .code == 8) {
        QSKIP("built without OpenMesh or TetGen");
    }
    QVERIFY(QFile::link(QString(AMECO_SOURCE_DIR) + "/sample_meshes", here.path("sample_meshes")));
    QString page;
    bool in_block = false;
    for (int i = 0; i < lines.size(); ++i) {
        const QString& line = lines.at(i);
        if (line.startsWith("```")) {
            in_block = line == "```console";
        }
        if (!in_block || !line.startsWith("$ ")) {
            page += line + (i + 1 < lines.size() ? "\n" : "");
            continue;
        }
        const Run run = run_line(here, line.mid(2));
        QVERIFY2(run.code == 0, run.text());
        page += line + "\n" + run.out;
        QString expected;
        while (!lines.at(i + 1).startsWith("$ ") && !lines.at(i + 1).startsWith("```")) {
            expected += lines.at(++i) + "\n";
        }
        if (!qEnvironmentVariableIsSet("AMECO_UPDATE_DOCS")) {
            QCOMPARE(words_of(run.out), words_of(expected));
        }
    }
    if (qEnvironmentVariableIsSet("AMECO_UPDATE_DOCS")) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(page.toUtf8());
    }
}

QTEST_GUILESS_MAIN(QuickstartTest)
#include "quickstart_test.moc"
