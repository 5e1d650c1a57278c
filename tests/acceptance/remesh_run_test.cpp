// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/acceptance/run_ameco.h"

#include <nlohmann/json.hpp>

using namespace ameco::test;
using Json = nlohmann::json;

class RemeshRunTest : public QObject {
    Q_OBJECT

    Workspace here_;

private slots:
    void initTestCase() {
        QCOMPARE(here_
                     .ameco({"case", "layer", "--nx", "6", "--ny", "6", "--nz", "12", "-o",
                             "layer.meshb"})
                     .code,
                 0);
        QCOMPARE(here_.ameco({"case", "cube", "--n", "4", "-o", "cube.meshb"}).code, 0);
    }

    void makes_a_mesh_unit_in_the_metric_of_a_coarser_level() {
        QCOMPARE(here_.ameco({"metric", "layer.meshb", "--coarsen", "2", "-o", "coarse.solb"}).code,
                 0);
        const Run run = here_.ameco({"remesh", "layer.meshb", "--metric", "coarse.solb", "-o",
                                     "out.meshb", "--metric-out", "out.solb", "--json"});
        QVERIFY2(run.code == 0, run.text());
        const Json json = Json::parse(run.out.toStdString());
        QVERIFY(json["conformity"]["in_band"].get<double>() > 0.9);
        QVERIFY(json["nodes"].get<int>() < json["nodes_before"].get<int>());
        QCOMPARE(here_.ameco({"check", "out.meshb", "--metric", "out.solb"}).code, 0);
    }

    void refines_to_a_size() {
        const Run run = here_.ameco({"remesh", "cube.meshb", "--size", "0.1", "-o", "fine.mesh"});
        QVERIFY2(run.code == 0, run.text());
        QVERIFY2(run.out.contains("from 125 nodes"), run.text());
        QCOMPARE(here_.ameco({"check", "fine.mesh"}).code, 0);
    }

    void runs_the_papers_engine() {
        const Run run = here_.ameco({"remesh", "cube.meshb", "--size", "0.4", "--engine", "mtc",
                                     "--quality", "original", "-o", "mtc.meshb", "--json"});
        QVERIFY2(run.code == 0, run.text());
        const Json json = Json::parse(run.out.toStdString());
        QVERIFY(json["engine"] == "mtc" && json["quality"] == "original");
        QVERIFY(json["nodes"].get<int>() < json["nodes_before"].get<int>());
        QCOMPARE(here_.ameco({"check", "mtc.meshb"}).code, 0);
    }

    void prints_verdicts_when_asked() {
        const Run run =
            here_.ameco({"remesh", "cube.meshb", "--size", "0.2", "-o", "v.meshb", "-v"});
        QVERIFY2(run.out.contains("accepted"), run.text());
        QVERIFY2(run.out.contains("no improvement"), run.text());
    }

    void gives_the_same_bytes_for_any_number_of_threads() {
        for (const char* threads : {"1", "2"}) {
            QCOMPARE(here_
                         .ameco({"remesh", "cube.meshb", "--size", "0.15", "-o",
                                 QString("t") + threads + ".meshb", "--threads", threads})
                         .code,
                     0);
        }
        QCOMPARE(here_.content("t1.meshb"), here_.content("t2.meshb"));
    }

    void says_what_is_wrong_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("words");
        QTest::newRow("neither metric nor size")
            << QStringList{"remesh", "cube.meshb", "-o", "x.meshb"} << 2 << "--metric or --size";
        QTest::newRow("both") << QStringList{"remesh", "cube.meshb", "-o",       "x.meshb",
                                             "--size", "1",          "--metric", "a.solb"}
                              << 2 << "--metric";
        QTest::newRow("size 0") << QStringList{"remesh",  "cube.meshb", "-o",
                                               "x.meshb", "--size",     "0"}
                                << 2 << "--size";
        QTest::newRow("more nodes than numbers")
            << QStringList{"remesh", "cube.meshb", "-o", "x.meshb", "--size", "1e-9"} << 5
            << "make its sizes larger";
        QTest::newRow("an engine that needs sizes")
            << QStringList{"remesh", "cube.meshb", "-o",  "x.meshb",   "--size",
                           "1",      "--engine",   "mtc", "--quality", "shape"}
            << 2 << "knows no sizes";
        QTest::newRow("the metric of another mesh")
            << QStringList{"remesh", "cube.meshb", "-o", "x.meshb", "--metric", "coarse.solb"} << 5
            << "give the metric that was made for this mesh";
        QTest::newRow("over its input")
            << QStringList{"remesh", "cube.meshb", "-o", "cube.meshb", "--size", "1"} << 2
            << "cube.meshb";
        QTest::newRow("no such patch") << QStringList{"remesh", "cube.meshb", "-o",       "x.meshb",
                                                      "--size", "1",          "--freeze", "nobody"}
                                       << 2 << "nobody";
    }

    void says_what_is_wrong() {
        QFETCH(QStringList, arguments);
        QFETCH(int, code);
        QFETCH(QString, words);
        const Run run = here_.ameco(arguments);
        QCOMPARE(run.code, code);
        QVERIFY2(run.err.contains(words), run.text());
        QVERIFY(!here_.files(".").contains("x.meshb"));
    }
};

QTEST_GUILESS_MAIN(RemeshRunTest)
#include "remesh_run_test.moc"
