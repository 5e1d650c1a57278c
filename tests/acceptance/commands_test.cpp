// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/acceptance/run_ameco.h"

#include <cmath>

using namespace ameco::test;

class CommandsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void info_describes_a_mesh();
    void info_describes_a_metric();
    void info_goes_on_after_a_file_it_cannot_read();
    void info_says_the_same_in_json();
    void check_accepts_a_valid_mesh();
    void check_mends_first_unless_told_not_to();
    void check_measures_a_mesh_in_a_given_metric();
    void metric_predicts_the_coarser_level();
    void metric_has_a_tensor_for_unused_nodes_too();
    void metric_compares_all_means_at_a_node();
    void convert_gives_the_same_file_back_data();
    void convert_gives_the_same_file_back();
    void case_lists_what_there_is();
    void case_makes_the_same_mesh_every_time();
    void never_overwrites_an_input_data();
    void never_overwrites_an_input();
    void reports_that_standard_output_is_full();
    void describes_files_made_by_others_data();
    void describes_files_made_by_others();

private:
    Workspace here_;
};

void CommandsTest::initTestCase() {
    QCOMPARE(here_.ameco({"case", "cube", "--n", "4", "-o", "cube.meshb"}).code, 0);
    QCOMPARE(here_.ameco({"case", "cube", "--n", "4", "--dim", "2", "-o", "square.mesh"}).code, 0);
    QCOMPARE(here_.ameco({"metric", "cube.meshb", "-o", "cube.solb"}).code, 0);
    QCOMPARE(here_.ameco({"metric", "square.mesh", "-o", "square.sol"}).code, 0);
}

void CommandsTest::info_describes_a_mesh() {
    const Run run = here_.ameco({"info", "cube.meshb"});
    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QString());
    for (const char* part : {"nodes           125\n", "tets            384\n", "x 0 .. 1",
                             "volume          1\n", "bottom", "aspect ratio", "of memory\n"}) {
        QVERIFY2(run.out.contains(part), run.text());
    }
    const Run flat = here_.ameco({"info", "square.mesh"});
    QVERIFY2(flat.out.contains("triangles       32\n"), flat.text());
    QVERIFY2(flat.out.contains("area            1\n"), flat.text());
}

void CommandsTest::info_describes_a_metric() {
    const Run run = here_.ameco({"info", "cube.solb", "square.sol"});
    QCOMPARE(run.code, 0);
    QVERIFY2(run.out.contains("125, all symmetric positive definite, 3-D"), run.text());
    QVERIFY2(run.out.contains("25, all symmetric positive definite, 2-D"), run.text());
}

void CommandsTest::info_goes_on_after_a_file_it_cannot_read() {
    const Run run = here_.ameco({"info", "absent.meshb", "cube.meshb"});
    QCOMPARE(run.code, 4);
    QVERIFY2(run.err.startsWith("ameco: absent.meshb: ") && run.err.count('\n') == 1, run.text());
    QVERIFY2(run.out.contains("nodes           125"), run.text());
}

void CommandsTest::info_says_the_same_in_json() {
    const auto json = here_.ameco({"info", "cube.meshb", "cube.solb", "--json"}).json();
    QCOMPARE(json.size(), std::size_t{2});
    const auto& mesh = json.at(0);
    QCOMPARE(mesh.at("nodes").get<int>(), 125);
    QCOMPARE(mesh.at("elements").get<int>(), 384);
    QCOMPARE(mesh.at("patches").size(), std::size_t{6});
    QCOMPARE(mesh.at("patches").at(0).at("name").get<std::string>(), std::string("bottom"));
    QVERIFY(mesh.at("valid").get<bool>());
    QVERIFY(std::abs(mesh.at("volume").get<double>() - 1) < 1e-12);
    QVERIFY(json.at(1).at("sizes").at("smallest").get<double>() > 0);
    const double from_mesh = mesh.at("aspect_ratio").at("max").get<double>();
    const double from_metric = json.at(1).at("aspect_ratio").at("max").get<double>();
    QVERIFY(std::abs(from_mesh - from_metric) < 1e-9 * from_mesh); // by way of the tensor
}

void CommandsTest::check_accepts_a_valid_mesh() {
    const Run run = here_.ameco({"check", "cube.meshb"});
    QCOMPARE(run.code, 0);
    QVERIFY2(run.out.startsWith("cube.meshb: valid\n"), run.text());
    QCOMPARE(here_.ameco({"check", "cube.meshb", "-q"}).out, QString("cube.meshb: valid\n"));
}

void CommandsTest::check_mends_first_unless_told_not_to() {
    // One boundary face turned, as in half of the files there are.
    QStringList lines = QString::fromUtf8(here_.content("square.mesh")).split('\n');
    const auto at = lines.indexOf("Edges") + 2;
    const QStringList face = lines.at(at).split(' ');
    lines[at] = face.at(1) + " " + face.at(0) + " " + face.at(2);
    here_.write("turned.mesh", lines.join('\n').toUtf8());
    const Run mended = here_.ameco({"check", "turned.mesh"});
    QCOMPARE(mended.code, 0);
    QVERIFY2(mended.out.contains("mended: 1 boundary face pointed inwards"), mended.text());
    const Run strict = here_.ameco({"check", "turned.mesh", "--strict"});
    QCOMPARE(strict.code, 3);
    QVERIFY2(strict.out.startsWith("turned.mesh: NOT VALID\n"), strict.text());
}

void CommandsTest::check_measures_a_mesh_in_a_given_metric() {
    const auto json =
        here_.ameco({"check", "cube.meshb", "--metric", "cube.solb", "--json"}).json();
    const double natural = json.at("conformity_to_natural_metric").at("mean_quality").get<double>();
    const double given = json.at("conformity_to_given_metric").at("mean_quality").get<double>();
    QVERIFY(std::abs(natural - given) < 1e-6 * natural); // through the file's tensors
    const Run other = here_.ameco({"check", "cube.meshb", "--metric", "square.sol"});
    QCOMPARE(other.code, 5);
    QVERIFY2(other.err.contains("square.sol: has 25 tensors of another dimension"), other.text());
}

void CommandsTest::metric_predicts_the_coarser_level() {
    const Run natural = here_.ameco({"metric", "cube.meshb", "-o", "a.solb", "--json"});
    const Run coarse =
        here_.ameco({"metric", "cube.meshb", "-o", "b.sol", "--coarsen", "2", "--json"});
    QCOMPARE(coarse.code, 0);
    QCOMPARE(natural.json().at("predicted_nodes").get<double>(), 125.0);
    const double ratio = 125 / coarse.json().at("predicted_nodes").get<double>();
    QVERIFY2(ratio > 2 && ratio <= 8 + 1e-9, qPrintable(QString::number(ratio)));
    QVERIFY(QFile::exists(here_.path("b.sol")));
}

void CommandsTest::metric_has_a_tensor_for_unused_nodes_too() {
    QByteArray text = here_.content("square.mesh");
    const int at = static_cast<int>(text.indexOf("Vertices\n25\n"));
    QVERIFY(at > 0);
    text.replace("Vertices\n25\n", "Vertices\n26\n");
    text.replace("\nEdges\n", "\n5 5 0\n\nEdges\n");
    here_.write("orphan.mesh", text);
    QCOMPARE(here_.ameco({"metric", "orphan.mesh", "-o", "orphan.sol"}).code, 0);
    const auto json = here_.ameco({"info", "orphan.mesh", "orphan.sol", "--json"}).json();
    QCOMPARE(json.at(0).at("nodes").get<int>(), 26);
    QCOMPARE(json.at(1).at("nodes").get<int>(), 26);
}

void CommandsTest::metric_compares_all_means_at_a_node() {
    QCOMPARE(here_.ameco({"case", "model-layer", "-o", "strip.mesh"}).code, 0);
    const Run run =
        here_.ameco({"metric", "strip.mesh", "--compare", "12", "-o", "balls.svg", "--json"});
    QCOMPARE(run.code, 0);
    const auto means = run.json().at("means");
    QCOMPARE(means.size(), 6U);
    QCOMPARE(means.at(0).at("mean").get<std::string>(), std::string("corrected"));
    QVERIFY(std::abs(means.at(0).at("sizes").at(0).get<double>() - 1e-3) < 1e-5);
    QCOMPARE(means.at(5).at("failure").get<std::string>(), std::string("does not converge"));
    QVERIFY(here_.content("balls.svg").contains("Unit balls at node 12, 6 elements"));
    const Run none = here_.ameco({"metric", "strip.mesh", "--compare", "25"});
    QCOMPARE(none.code, 2);
    QVERIFY2(none.err.contains("strip.mesh has the nodes 0 to 24"), none.text());
    QCOMPARE(here_.ameco({"metric", "strip.mesh"}).code, 2);
    // The mean that fails says at which node.
    const Run fixed =
        here_.ameco({"metric", "strip.mesh", "--mean", "geodesic-fixed-step", "-o", "f.sol"});
    QCOMPARE(fixed.code, 3);
    QVERIFY2(fixed.err.contains("node 2: geodesic-fixed-step: no mean of 3 metrics"), fixed.text());
    QVERIFY(!QFile::exists(here_.path("f.sol")));
}

void CommandsTest::convert_gives_the_same_file_back_data() {
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::addColumn<QString>("again");
    QTest::newRow("mesh") << "cube.meshb"
                          << "c.mesh"
                          << "c.meshb";
    QTest::newRow("2-D mesh") << "square.mesh"
                              << "s.meshb"
                              << "s.mesh";
    QTest::newRow("metric") << "cube.solb"
                            << "c.sol"
                            << "c.solb";
    QTest::newRow("2-D metric") << "square.sol"
                                << "s.solb"
                                << "s.sol";
}

void CommandsTest::convert_gives_the_same_file_back() {
    QFETCH(QString, first);
    QFETCH(QString, second);
    QFETCH(QString, again);
    const Run run = here_.ameco({"convert", first, second});
    QVERIFY2(run.code == 0 && run.out.startsWith(second + ": "), run.text());
    QCOMPARE(here_.ameco({"convert", second, again, "-q"}).out, QString());
    QCOMPARE(here_.content(again), here_.content(first));
}

void CommandsTest::case_lists_what_there_is() {
    const Run run = here_.ameco({"case", "--list"});
    QCOMPARE(run.code, 0);
    const auto json = here_.ameco({"case", "--list", "--json"}).json();
    QVERIFY(json.size() >= 3);
    for (const auto& entry : json) {
        const QString name = QString::fromStdString(entry.at("name").get<std::string>());
        QVERIFY2(run.out.contains("  " + name + " "), run.text());
        const Run help = here_.ameco({"case", name, "--help"});
        QCOMPARE(help.code, 0);
        for (const auto& parameter : entry.at("parameters")) {
            const auto option = "--" + parameter.at("name").get<std::string>() + " ";
            QVERIFY2(help.out.contains(QString::fromStdString(option)), help.text());
        }
    }
}

void CommandsTest::case_makes_the_same_mesh_every_time() {
    for (const char* name : {"1.meshb", "2.meshb"}) {
        QCOMPARE(here_.ameco({"case", "layer", "--nx", "4", "--ny=3", "-o", name}).code, 0);
    }
    QCOMPARE(here_.content("1.meshb"), here_.content("2.meshb"));
    QCOMPARE(here_.ameco({"check", "1.meshb"}).code, 0);
}

void CommandsTest::never_overwrites_an_input_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("input");
    QTest::newRow("convert") << QStringList{"convert", "cube.meshb", "./cube.meshb"}
                             << "cube.meshb";
    QTest::newRow("convert a metric")
        << QStringList{"convert", "cube.solb", "cube.solb"} << "cube.solb";
    QTest::newRow("convert through a link")
        << QStringList{"convert", "cube.meshb", "link.meshb"} << "cube.meshb";
    QTest::newRow("metric") << QStringList{"metric", "input.solb", "-o", "input.solb"}
                            << "input.solb";
    QTest::newRow("coarsen") << QStringList{"coarsen", "levels/level_1.meshb", "-o", "levels",
                                            "--force"}
                             << "levels/level_1.meshb";
}

void CommandsTest::never_overwrites_an_input() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, input);
    QFile::link(here_.path("cube.meshb"), here_.path("link.meshb"));
    QDir().mkpath(here_.path("levels"));
    for (const char* copy : {"levels/level_1.meshb", "input.solb"}) { // recognised by content
        QFile::copy(here_.path("cube.meshb"), here_.path(copy));
    }
    const QByteArray before = here_.content(input);
    const Run run = here_.ameco(arguments);
    QVERIFY2(run.code == 2 && run.err.count('\n') == 1, run.text());
    QVERIFY2(run.err.contains("overwritten"), run.text());
    QCOMPARE(here_.content(input), before);
}

void CommandsTest::reports_that_standard_output_is_full() {
    if (!QFile::exists("/dev/full")) {
        QSKIP("this system has no /dev/full");
    }
    const Run run = here_.shell("\"$AMECO\" info cube.meshb > /dev/full");
    QCOMPARE(run.code, 4);
    QVERIFY2(run.err.startsWith("ameco: standard output: "), run.text());
}

void CommandsTest::describes_files_made_by_others_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("nodes");
    QTest::addColumn<int>("elements");
    QTest::newRow("cube-linear text") << "cube-linear-00.mesh" << 64 << 162;
    QTest::newRow("cube-linear binary") << "cube-linear-00.meshb" << 64 << 162;
    QTest::newRow("cube-cylinder") << "cube-cylinder.meshb" << 286 << 952;
    QTest::newRow("onera-m6") << "onera_m6_curv.meshb" << 1544 << 6495;
}

void CommandsTest::describes_files_made_by_others() {
    QFETCH(QString, file);
    QFETCH(int, nodes);
    QFETCH(int, elements);
    const QString path = QString(AMECO_SHARED_DIR) + "/meshes/" + file;
    if (!QFile::exists(path)) {
        QSKIP(qPrintable(file + " is not here"));
    }
    const auto info = here_.ameco({"info", path, "--json"}).json().at(0);
    QCOMPARE(info.at("nodes").get<int>(), nodes);
    QCOMPARE(info.at("elements").get<int>(), elements);
    QVERIFY(info.at("valid").get<bool>());
    QCOMPARE(here_.ameco({"check", path}).code, 0);
}

QTEST_GUILESS_MAIN(CommandsTest)
#include "commands_test.moc"
