// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/acceptance/run_ameco.h"

#include <functional>
#include <random>

using namespace ameco::test;

/// Each broken input: one clear line that names the file, the right exit code, nothing left behind.
class BrokenInputTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void is_named_in_one_line_data();
    void is_named_in_one_line();
    void fails_the_check_data();
    void fails_the_check();
    void leaves_nothing_where_it_cannot_write_data();
    void leaves_nothing_where_it_cannot_write();

private:
    void add_files_with_wrong_numbers();
    void add_files_with_wrong_bytes();
    void add_meshes_that_are_not_valid();

    Workspace here_;
};

namespace {

/// The unit tet, with the nodes of more of them and their elements appended.
QByteArray tets(const QByteArray& nodes, const QByteArray& elements) {
    const auto count = [](const QByteArray& rows) { return QByteArray::number(rows.count('\n')); };
    return "MeshVersionFormatted 2\nDimension 3\n\nVertices\n" + count(nodes) + "\n" + nodes +
           "\nTetrahedra\n" + count(elements) + "\n" + elements + "\nEnd\n";
}

const QByteArray unit_nodes = "0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";

QByteArray random_bytes(int count) {
    std::mt19937 random(1);
    QByteArray bytes(count, '\0');
    for (char& byte : bytes) {
        byte = static_cast<char>(random());
    }
    return bytes;
}

} // namespace

void BrokenInputTest::initTestCase() {
    QCOMPARE(here_.ameco({"case", "cube", "--n", "3", "-o", "cube.meshb"}).code, 0);
    here_.write("good.mesh", tets(unit_nodes, "1 2 3 4 0\n"));
    QCOMPARE(here_.ameco({"check", "good.mesh"}).code, 0);
}

void BrokenInputTest::add_files_with_wrong_numbers() {
    const auto row = [this](const char* what, const QByteArray& bytes, const char* complaint) {
        const QString file = QString(what).replace(' ', '-') + ".mesh";
        here_.write(file, bytes);
        QTest::newRow(what) << file << 5 << complaint;
    };
    row("NaN", tets("0 0 0 0\n1 nan 0 0\n0 1 0 0\n0 0 1 0\n", "1 2 3 4 0\n"), "");
    row("infinite", tets("0 0 0 0\n1 0 1e999 0\n0 1 0 0\n0 0 1 0\n", "1 2 3 4 0\n"), "");
    row("hanging index", tets(unit_nodes, "1 2 3 5 0\n"), "5");
    row("index zero", tets(unit_nodes, "0 1 2 3 0\n"), "0");
    row("negative index", tets(unit_nodes, "-1 1 2 3 0\n"), "-1");
    row("no elements", tets(unit_nodes, ""), "");
    row("count of 2 to the 31",
        tets(unit_nodes, "1 2 3 4 0\n").replace("Tetrahedra\n1\n", "Tetrahedra\n2147483648\n"), "");
    row("count of 2 to the 63",
        tets(unit_nodes, "1 2 3 4 0\n")
            .replace("Tetrahedra\n1\n", "Tetrahedra\n9223372036854775808\n"),
        "");
    row("negative count",
        tets(unit_nodes, "1 2 3 4 0\n").replace("Tetrahedra\n1\n", "Tetrahedra\n-1\n"), "");
    row("a word for a number", tets("0 0 zero 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n", "1 2 3 4 0\n"), "");
}

void BrokenInputTest::add_files_with_wrong_bytes() {
    const auto row = [this](const char* what, const QString& file, const QByteArray& bytes) {
        here_.write(file, bytes);
        QTest::newRow(what) << file << 5 << "";
    };
    const QByteArray cube = here_.content("cube.meshb");
    row("half a binary file", "half.meshb", cube.left(cube.size() / 2));
    row("a binary file without its last byte", "almost.meshb", cube.left(cube.size() - 13));
    row("half a text file", "half.mesh", tets(unit_nodes, "1 2 3 4 0\n").left(60));
    row("binary garbage", "garbage.meshb", random_bytes(4096));
    row("binary garbage called text", "garbage.mesh", random_bytes(4096));
    row("an empty file", "empty.meshb", "");
    QByteArray huge = cube;
    const QByteArray count = QByteArray::fromHex("40000000"); // 64 nodes
    huge.replace(static_cast<int>(huge.indexOf(count)), 4, QByteArray::fromHex("ffffff7f"));
    row("a binary count of 2 to the 31 less 1", "huge.meshb", huge);
}

void BrokenInputTest::add_meshes_that_are_not_valid() {
    const auto row = [this](const char* what, const QByteArray& bytes, const char* complaint) {
        const QString file = QString(what).replace(' ', '-') + ".mesh";
        here_.write(file, bytes);
        QTest::newRow(what) << file << 5 << complaint;
    };
    const QByteArray two = unit_nodes + "1 1 1 0\n";
    row("inverted element", tets(two, "1 2 3 4 0\n2 3 5 4 0\n"), "inverted");
    row("flat element", tets(unit_nodes + "1 1 0 0\n", "1 2 3 4 0\n2 5 3 1 0\n"), "");
    row("duplicate element", tets(unit_nodes, "1 2 3 4 0\n1 2 3 4 0\n"), "");
    row("repeated node", tets(unit_nodes, "1 2 3 3 0\n"), "");
    // Two tets that meet in an edge only: four boundary faces there.
    row("non-manifold boundary",
        tets(unit_nodes + "-1 0 0 0\n0 -1 0 0\n", "1 2 3 4 0\n1 5 6 4 0\n"), "");
    row("three elements on a face",
        tets(unit_nodes + "1 1 1 0\n2 2 2 0\n", "1 2 3 4 0\n2 3 4 5 0\n2 3 4 6 0\n"), "");
}

void BrokenInputTest::is_named_in_one_line_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("complaint");
    add_files_with_wrong_numbers();
    add_files_with_wrong_bytes();
    add_meshes_that_are_not_valid();
    QTest::newRow("a file that is not there") << "absent.meshb" << 4 << "";
    QTest::newRow("a folder") << "." << 4 << "";
    QTest::newRow("a device") << "/dev/null" << 4 << "";
    QTest::newRow("a metric") << "cube.solb" << 5 << "";
    QCOMPARE(here_.ameco({"metric", "cube.meshb", "-o", "cube.solb"}).code, 0);
}

void BrokenInputTest::is_named_in_one_line() {
    QFETCH(QString, file);
    QFETCH(int, code);
    QFETCH(QString, complaint);
    const Run run = here_.ameco({"coarsen", file, "-o", "out"});
    QVERIFY2(run.code == code, run.text());
    QCOMPARE(run.out, QString());
    QVERIFY2(run.err.startsWith("ameco: " + file + ": ") && run.err.count('\n') == 1, run.text());
    QVERIFY2(run.err.contains(complaint), run.text());
    QVERIFY2(!QFile::exists(here_.path("out")), "a folder was made for nothing");
}

void BrokenInputTest::fails_the_check_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("complaint");
    add_meshes_that_are_not_valid();
}

void BrokenInputTest::fails_the_check() {
    QFETCH(QString, file);
    const Run run = here_.ameco({"check", file});
    QVERIFY2(run.code == 3, run.text());
    QVERIFY2(run.out.startsWith(file + ": NOT VALID\n  error: "), run.text());
    const auto json = here_.ameco({"check", file, "--json"}).json();
    QVERIFY(!json.at("valid").get<bool>());
    QVERIFY(!json.at("errors").empty());
    const Run info = here_.ameco({"info", file});
    QVERIFY2(info.code == 0 && info.out.contains("NOT VALID: "), info.text());
}

void BrokenInputTest::leaves_nothing_where_it_cannot_write_data() {
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("target");
    QTest::newRow("no such folder") << "convert cube.meshb absent/a.meshb"
                                    << "absent/a.meshb";
    QTest::newRow("folder is a file") << "convert cube.meshb good.mesh/a.meshb"
                                      << "good.mesh/a.meshb";
    QTest::newRow("target is a folder") << "metric cube.meshb -o folder.solb"
                                        << "folder.solb";
    QTest::newRow("read-only file system") << "convert cube.meshb /proc/a.meshb"
                                           << "/proc/a.meshb";
    QTest::newRow("levels into a file") << "coarsen cube.meshb -o good.mesh"
                                        << "good.mesh";
    QTest::newRow("levels below a file") << "coarsen cube.meshb -o good.mesh/out"
                                         << "good.mesh/out";
    QTest::newRow("levels into a read-only file system") << "coarsen cube.meshb -o /proc/out"
                                                         << "/proc/out";
    QTest::newRow("case") << "case cube -o absent/a.meshb"
                          << "absent/a.meshb";
    // No file may grow beyond 4 KiB, as on a full disk; the limit's signal is ignored.
    QTest::newRow("disk full") << "case cube --n 20 -o full.meshb"
                               << "full.meshb";
}

void BrokenInputTest::leaves_nothing_where_it_cannot_write() {
    QFETCH(QString, command);
    QFETCH(QString, target);
    QDir().mkpath(here_.path("folder.solb"));
    const QStringList before = here_.files(".");
    const QString limit = target == "full.meshb" ? "trap '' XFSZ; ulimit -f 8; " : "";
    const Run run = here_.shell(limit + "exec \"$AMECO\" " + command);
    QVERIFY2(run.code == 4, run.text());
    QVERIFY2(run.err.startsWith("ameco: " + target) && run.err.count('\n') == 1, run.text());
    QCOMPARE(here_.files("."), before);
}

QTEST_GUILESS_MAIN(BrokenInputTest)
#include "broken_input_test.moc"
