// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/acceptance/run_ameco.h"

#include <nlohmann/json.hpp>

#include <cmath>

using namespace ameco::test;

class SurfaceRunTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void surface_describes_the_boundary_of_a_mesh();
    void surface_mends_what_is_harmless();
    void surface_refuses_to_write_what_it_cannot_mend();
    void surface_gives_patches_to_an_unlabelled_one();
    void surface_measures_distances_both_ways();
    void fill_gives_a_valid_mesh_data();
    void fill_gives_a_valid_mesh();
    void fill_keeps_patches_and_names();
    void fill_follows_a_metric();
    void fill_refuses_broken_surfaces_data();
    void fill_refuses_broken_surfaces();
    void each_broken_sample_is_refused_in_its_own_words_data();
    void each_broken_sample_is_refused_in_its_own_words();
    void fill_leaves_nothing_behind_when_it_fails();
    void layers_grow_on_a_surface();
    void layers_on_a_sharp_body_are_shortened_or_left_out();
    void levels_are_rebuilt();
    void wrong_usage_is_explained_data();
    void wrong_usage_is_explained();
    void the_wing_is_filled_again();
    void a_business_jet_gets_layers();

private:
    [[nodiscard]] bool has_tetgen() const;
    Workspace here_;
};

namespace {

/// An ASCII STL of an icosahedron with faces left out, turned or moved.
struct Icosahedron {
    bool open = false, turned = false, twice = false;
    double push = 0; ///< of one node, through the body [radius]

    [[nodiscard]] QByteArray stl() const {
        const double g = (1 + std::sqrt(5.0)) / 2;
        std::vector<std::array<double, 3>> x{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                             {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                             {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
        for (double& c : x[0]) {
            c *= 1 - push;
        }
        std::vector<std::array<int, 3>> faces{
            {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
            {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
            {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
        if (open) {
            faces.pop_back();
        }
        if (turned) {
            std::swap(faces[3][0], faces[3][1]);
        }
        if (twice) {
            faces.push_back(faces[2]);
        }
        QByteArray text = "solid a\n";
        for (const auto& f : faces) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int v : f) {
                const auto& p = x[static_cast<std::size_t>(v)];
                text += "vertex " + QByteArray::number(p[0], 'g', 9) + " " +
                        QByteArray::number(p[1], 'g', 9) + " " + QByteArray::number(p[2], 'g', 9) +
                        "\n";
            }
            text += "endloop\nendfacet\n";
        }
        return text + "endsolid a\n";
    }
};

} // namespace

bool SurfaceRunTest::has_tetgen() const {
    return here_.ameco({"fill", "ico.stl", "-o", "probe.meshb"}).code != 8;
}

void SurfaceRunTest::initTestCase() {
    if (here_.ameco({"formats"}).out.contains("STL") &&
        here_.ameco({"case", "cube", "--n", "3", "-o", "cube.meshb"}).code == 0) {
        here_.write("ico.stl", Icosahedron().stl());
    }
    const Run run = here_.ameco({"info", "cube.meshb"});
    QCOMPARE(run.code, 0);
    if (here_.ameco({"convert", "cube.meshb", "cube.stl"}).code == 8) {
        QSKIP("built without STL");
    }
}

void SurfaceRunTest::surface_describes_the_boundary_of_a_mesh() {
    const Run run = here_.ameco({"surface", "cube.meshb"});
    QCOMPARE(run.code, 0);
    for (const char* part : {"cube.meshb: sound\n", "faces         108\n", "volume        1\n",
                             "in 12 curves", "corners  8\n"}) {
        QVERIFY2(run.out.contains(part), run.text());
    }
    const auto json = here_.ameco({"surface", "ico.stl", "--json"}).json();
    QVERIFY(json.at("sound").get<bool>());
    QCOMPARE(json.at("parts").at(0).at("genus").get<int>(), 0);
    QCOMPARE(json.at("parts").at(0).at("edges").get<int>(), 30);
    QVERIFY(json.at("defects").at("open_edges").empty());
}

void SurfaceRunTest::surface_mends_what_is_harmless() {
    here_.write("harmless.stl", Icosahedron{.turned = true, .twice = true}.stl());
    QCOMPARE(here_.ameco({"surface", "harmless.stl"}).code, 3);
    const Run run = here_.ameco({"surface", "harmless.stl", "--repair", "-o", "mended.mesh"});
    QCOMPARE(run.code, 0);
    QVERIFY2(run.out.contains("mended: 1 face was left out"), run.text());
    QVERIFY2(run.out.contains("mended: 1 face was turned"), run.text());
    QCOMPARE(here_.ameco({"surface", "mended.mesh"}).code, 0);
}

void SurfaceRunTest::surface_refuses_to_write_what_it_cannot_mend() {
    here_.write("open.stl", Icosahedron{.open = true}.stl());
    const Run run = here_.ameco({"surface", "open.stl", "--repair", "-o", "never.mesh"});
    QCOMPARE(run.code, 5);
    QVERIFY2(run.err.contains("open.stl: does not bound a volume: 3 open edges"), run.text());
    QVERIFY(!here_.files(".").contains("never.mesh"));
}

void SurfaceRunTest::surface_gives_patches_to_an_unlabelled_one() {
    QCOMPARE(here_.ameco({"surface", "cube.stl", "--segment", "-o", "sides.mesh"}).code, 0);
    const auto json = here_.ameco({"surface", "sides.mesh", "--json"}).json();
    QCOMPARE(json.at("features").at("patches").get<int>(), 6);
    QCOMPARE(json.at("features").at("curves").size(), std::size_t{12});
}

void SurfaceRunTest::surface_measures_distances_both_ways() {
    QCOMPARE(here_.ameco({"case", "cube", "--n", "5", "-o", "finer.meshb"}).code, 0);
    const Run same = here_.ameco({"surface", "cube.meshb", "--distance", "finer.meshb"});
    QVERIFY2(same.out.contains("distance to finer.meshb  0 .. "), same.text());
    const auto json =
        here_.ameco({"surface", "ico.stl", "--distance", "cube.meshb", "--json"}).json();
    const auto& there = json.at("distance").at("there");
    QVERIFY(there.at("at_least").get<double>() > 1);
    QVERIFY(there.at("at_most").get<double>() - there.at("at_least").get<double>() < 1e-4);
}

void SurfaceRunTest::fill_gives_a_valid_mesh_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("inside") << QStringList{};
    QTest::newRow("finer") << QStringList{"--size", "0.3"};
    QTest::newRow("nodes on the faces") << QStringList{"--size", "0.3", "--boundary", "split"};
    QTest::newRow("around, box") << QStringList{"--farfield", "box"};
    QTest::newRow("around, sphere") << QStringList{"--farfield", "sphere:9"};
    QTest::newRow("no new nodes") << QStringList{"--radius-edge", "0"};
    QTest::newRow("region") << QStringList{"--farfield", "box:9", "--region", "0,0,0:4:0.2"};
}

void SurfaceRunTest::fill_gives_a_valid_mesh() {
    QFETCH(QStringList, options);
    if (!has_tetgen()) {
        QSKIP("built without TetGen");
    }
    const Run run = here_.ameco(QStringList{"fill", "ico.stl", "-o", "filled.meshb"} + options);
    QVERIFY2(run.code == 0, run.text());
    const Run check = here_.ameco({"check", "filled.meshb", "--strict", "-q"});
    QVERIFY2(check.code == 0, check.text());
}

void SurfaceRunTest::fill_keeps_patches_and_names() {
    if (!has_tetgen()) {
        QSKIP("built without TetGen");
    }
    QCOMPARE(here_.ameco({"fill", "cube.meshb", "-o", "again.meshb", "--farfield", "box:4"}).code,
             0);
    const Run run = here_.ameco({"info", "again.meshb"});
    for (const char* name : {"bottom", "top", "farfield-x0", "farfield-z1"}) {
        QVERIFY2(run.out.contains(name), run.text());
    }
}

/// A layer of 1e-3 on one side of a box, from a metric at its eight corners.
void SurfaceRunTest::fill_follows_a_metric() {
    if (!has_tetgen()) {
        QSKIP("built without TetGen");
    }
    here_.write(
        "box.mesh",
        "MeshVersionFormatted 2\nDimension 3\nVertices 8\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
        "0 0 1 0\n1 0 1 0\n1 1 1 0\n0 1 1 0\nTriangles 12\n1 3 2 1\n1 4 3 1\n5 6 7 2\n5 7 8 2\n"
        "1 2 6 3\n1 6 5 3\n2 3 7 4\n2 7 6 4\n3 4 8 5\n3 8 7 5\n4 1 5 6\n4 5 8 6\nEnd\n");
    QByteArray metric = "MeshVersionFormatted 2\nDimension 3\nSolAtVertices 8\n1 3\n";
    for (int corner = 0; corner < 8; ++corner) {
        metric += corner < 4 ? "4 0 4 0 0 1e6\n" : "4 0 4 0 0 9\n";
    }
    here_.write("box.sol", metric + "End\n");
    const Run run = here_.ameco({"fill", "box.mesh", "--metric", "box.sol", "--boundary", "split",
                                 "-o", "layers.meshb", "--json"});
    QVERIFY2(run.code == 0, run.text());
    const auto json = nlohmann::json::parse(run.out.toStdString());
    QVERIFY2(json["conformity"]["in_band"].get<double>() > 0.85, run.text());
    QVERIFY2(json["nodes"].get<int>() > 100, run.text());
    QCOMPARE(here_.ameco({"check", "layers.meshb"}).code, 0);
}

void SurfaceRunTest::fill_refuses_broken_surfaces_data() {
    QTest::addColumn<QByteArray>("stl");
    QTest::addColumn<QString>("words");
    QTest::newRow("open") << Icosahedron{.open = true}.stl() << "3 open edges, with one face only";
    QTest::newRow("turned") << Icosahedron{.turned = true}.stl()
                            << "--repair mends this without loss";
    QTest::newRow("twice") << Icosahedron{.twice = true}.stl()
                           << "1 pair of faces on the same nodes";
    QTest::newRow("pushed through")
        << Icosahedron{.push = 2.5}.stl() << "pairs of faces that intersect";
    QTest::newRow("pushed to the other side") << Icosahedron{.push = 2}.stl() << "";
    QTest::newRow("nothing") << QByteArray("solid a\nendsolid a\n") << "";
    QTest::newRow("one face") << QByteArray("solid a\nfacet normal 0 0 0\nouter loop\n"
                                            "vertex 0 0 0\nvertex 1 0 1\nvertex 0 1 0\nendloop\n"
                                            "endfacet\nendsolid a\n")
                              << "3 open edges";
    QTest::newRow("not a surface") << QByteArray("hello") << "";
}

void SurfaceRunTest::fill_refuses_broken_surfaces() {
    QFETCH(QByteArray, stl);
    QFETCH(QString, words);
    here_.write("broken.stl", stl);
    const Run run = here_.ameco({"fill", "broken.stl", "-o", "never.meshb"});
    QVERIFY2(run.code == 5, run.text());
    QVERIFY2(run.err.startsWith("ameco: broken.stl: ") && run.err.count('\n') == 1, run.text());
    QVERIFY2(run.err.contains(words), run.text());
    QVERIFY(!here_.files(".").contains("never.meshb"));
}

void SurfaceRunTest::each_broken_sample_is_refused_in_its_own_words_data() {
    QTest::addColumn<QString>("words");
    const auto row = [](const char* file, const char* words) { QTest::newRow(file) << words; };
    row("common_edge", "1 edge of more than two faces: 3-7; %1");
    row("common_node", "1 node where parts of the surface only touch: 7; %1");
    row("far_node", "vertex 8 has a coordinate that is not finite");
    row("flat_face", "1 face without area: 13; %2");
    row("one_sided", "24 open edges, with one face only: 0-2, 0-23, ");
    row("open", "3 open edges, with one face only: 1-5, 1-7, 5-7; %1");
    row("overlapping", "12 pairs of faces that intersect: ");
    row("own_nodes", "28 pairs of nodes at the same point: 0-3, ");
    row("pushed_onto", "8 pairs of faces that intersect: 0-6, ");
    row("pushed_through", "5 pairs of faces that intersect: 0-2, 0-3, 0-6, 1-2, 1-11; %1");
    row("turned", "3 edges whose two faces are turned differently: 4-6, 4-7, 6-7; %2");
    row("twice", "1 pair of faces on the same nodes: 2-12; %2");
    row("wall_inside", "4 edges of more than two faces: 0-3, 0-4, 3-7, 4-7; %1");
}

void SurfaceRunTest::each_broken_sample_is_refused_in_its_own_words() {
    QFETCH(QString, words);
    words.replace("%1", "mend it where it was made");
    words.replace("%2", "ameco surface --repair mends this without loss");
    const QDir samples(QString(AMECO_SOURCE_DIR) + "/sample_meshes/broken_surfaces");
    const QString file = samples.filePath(QString(QTest::currentDataTag()) + ".mesh");
    const Run run = here_.ameco({"fill", file, "-o", "never.meshb"});
    QVERIFY2(run.code == 5 && run.err.count('\n') == 1, run.text());
    QVERIFY2(run.err.startsWith("ameco: " + file + ": ") && run.err.contains(words), run.text());
    QVERIFY(!QFile::exists(here_.path("never.meshb")));
    if (words.endsWith("without loss")) {
        QVERIFY(here_.ameco({"surface", file, "--repair", "-o", "mended.mesh"}).code == 0);
    }
    QCOMPARE(samples.entryList({"*.mesh"}).size(), qsizetype{13}); // all of them are rows
}

void SurfaceRunTest::fill_leaves_nothing_behind_when_it_fails() {
    if (!has_tetgen()) {
        QSKIP("built without TetGen");
    }
    const QStringList before = here_.files(".");
    QVERIFY(here_.ameco({"fill", "ico.stl", "-o", "absent/a.meshb"}).code == 4);
    QVERIFY(here_.ameco({"fill", "ico.stl", "-o", "a.meshb", "--farfield", "box:1"}).code == 2);
    QCOMPARE(here_.files("."), before);
}

void SurfaceRunTest::layers_grow_on_a_surface() {
    if (!has_tetgen()) {
        QSKIP("built without TetGen");
    }
    QCOMPARE(
        here_.ameco({"fill", "ico.stl", "-o", "fine.meshb", "--size", "0.4", "--boundary", "split"})
            .code,
        0);
    const auto json = here_
                          .ameco({"case", "layer", "--surface", "fine.meshb", "--first-height",
                                  "1e-6", "--growth", "1.5", "--layers", "12", "--farfield",
                                  "sphere:20", "-o", "layers.meshb", "--json"})
                          .json();
    QCOMPARE(json.at("collapsed_columns").get<int>(), 0);
    QCOMPARE(json.at("shrunk_columns").get<int>(), 0);
    QCOMPARE(json.at("layer_nodes").get<int>(), 13 * json.at("columns").get<int>());
    const Run check = here_.ameco({"check", "layers.meshb", "--strict", "--json"});
    QVERIFY2(check.code == 0, check.text());
    // The body is outside.
    const double body = here_.ameco({"check", "fine.meshb", "--json"}).json().at("volume");
    const double sphere =
        here_.ameco({"surface", "layers.meshb", "--json"}).json().at("parts").at(1).at("volume");
    QVERIFY(std::abs(check.json().at("volume").get<double>() - (sphere - body)) < 1e-9 * sphere);
    const auto info = here_.ameco({"info", "layers.meshb", "--json"}).json().at(0);
    QVERIFY(info.at("aspect_ratio").at("max").get<double>() > 1e5);
}

void SurfaceRunTest::layers_on_a_sharp_body_are_shortened_or_left_out() {
    if (!has_tetgen()) {
        QSKIP("built without TetGen");
    }
    // Layers as high as the body: its columns fan out from edges of 42 degrees, and stay apart.
    const Run run =
        here_.ameco({"case", "layer", "--surface", "cube.meshb", "--first-height", "0.05",
                     "--layers", "5", "--farfield", "box:9", "-o", "high.meshb"});
    QVERIFY2(run.code == 0, run.text());
    QCOMPARE(here_.ameco({"check", "high.meshb", "--strict"}).code, 0);
}

void SurfaceRunTest::levels_are_rebuilt() {
    if (!has_tetgen()) {
        QSKIP("built without TetGen");
    }
    QCOMPARE(here_.ameco({"case", "cube", "--n", "8", "--displace", "0.2", "-o", "c8.meshb"}).code,
             0);
    const Run run = here_.ameco(
        {"coarsen", "c8.meshb", "-o", "rebuilt", "--levels", "2", "--rebuild", "tetgen"});
    QVERIFY2(run.code == 0 && !run.err.contains("warning"), run.text());
    QCOMPARE(broken_part_of(here_, "rebuilt"), QString());
    QVERIFY(here_.content("rebuilt/hierarchy.json").contains("\"rebuild\": \"tetgen\""));
    QCOMPARE(here_.ameco({"case", "cube", "--dim", "2", "-o", "flat.mesh"}).code, 0);
    for (const QStringList& more :
         {QStringList{"c8.meshb", "--factor", "4"}, QStringList{"c8.meshb", "--target-ratio", "3"},
          QStringList{"flat.mesh"}}) {
        const Run refused = here_.ameco(
            QStringList{"coarsen", "-o", "no" + more.last(), "--rebuild", "tetgen"} + more);
        QVERIFY2(refused.code == 2 && refused.err.contains("--rebuild: "), refused.text());
        QVERIFY(!QFile::exists(here_.path("no" + more.last())));
    }
}

void SurfaceRunTest::wrong_usage_is_explained_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("complaint");
    const auto row = [](const char* what, const QStringList& arguments, const char* complaint) {
        QTest::newRow(what) << arguments << complaint;
    };
    row("repair to where", {"surface", "ico.stl", "--repair"}, "name it with -o OUT");
    row("nothing to write", {"surface", "ico.stl", "-o", "a.stl"}, "nothing to write");
    row("over the input", {"surface", "ico.stl", "--repair", "-o", "ico.stl"}, "never overwritten");
    row("farfield", {"fill", "ico.stl", "-o", "a.meshb", "--farfield", "cube"},
        "cube is neither box nor sphere");
    row("hole", {"fill", "ico.stl", "-o", "a.meshb", "--hole", "1,2"}, "1,2 is not a point");
    row("region", {"fill", "ico.stl", "-o", "a.meshb", "--region", "1,2,3"}, "is not x,y,z:ID");
    row("radius", {"fill", "ico.stl", "-o", "a.meshb", "--radius-edge", "1"}, "below 1.1");
    row("boundary", {"fill", "ico.stl", "-o", "a.meshb", "--boundary", "kep"}, "keep");
    row("first height", {"case", "layer", "--surface", "ico.stl", "-o", "a.meshb"},
        "--first-height is missing");
    row("plate's", {"case", "layer", "--surface", "ico.stl", "--nx", "3", "-o", "a.meshb"},
        "--nx is a parameter of the plate");
    row("surface's", {"case", "layer", "--layers", "3", "-o", "a.meshb"}, "need --surface");
}

void SurfaceRunTest::wrong_usage_is_explained() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, complaint);
    const Run run = here_.ameco(arguments);
    QVERIFY2(run.code == 2, run.text());
    QVERIFY2(run.err.startsWith("ameco: ") && run.err.count('\n') == 1, run.text());
    QVERIFY2(run.err.contains(complaint), run.text());
}

void SurfaceRunTest::the_wing_is_filled_again() {
    if (!has_tetgen()) {
        QSKIP("built without TetGen");
    }
    QCOMPARE(here_
                 .ameco({"case", "onera-m6", "--chord-cells", "12", "--span-cells", "8", "--layers",
                         "20", "--growth-layers", "10", "-o", "m6.meshb"})
                 .code,
             0);
    const Run run = here_.ameco({"fill", "m6.meshb", "-o", "m6-filled.meshb"});
    QVERIFY2(run.code == 0, run.text());
    QCOMPARE(here_.ameco({"check", "m6-filled.meshb", "--strict"}).code, 0);
    const Run distance = here_.ameco({"surface", "m6-filled.meshb", "--distance", "m6.meshb"});
    QVERIFY2(distance.out.contains("distance to m6.meshb  0 .. "), distance.text());
}

void SurfaceRunTest::a_business_jet_gets_layers() {
    const QString jet = QString(AMECO_SHARED_DIR) + "/meshes/falcon_full_surface.msh";
    if (!QFile::exists(jet)) {
        QSKIP("falcon_full_surface.msh is not here");
    }
    if (!has_tetgen()) {
        QSKIP("built without TetGen");
    }
    const auto surface = here_.ameco({"surface", jet, "--json"}).json();
    QVERIFY(surface.at("sound").get<bool>());
    QCOMPARE(surface.at("parts").at(0).at("genus").get<int>(), 2);
    const Run run = here_.ameco({"case", "layer", "--surface", jet, "--first-height", "1.85e-5",
                                 "--growth", "1.5", "--layers", "3", "--farfield", "sphere:200",
                                 "-o", "jet.meshb", "--json"});
    QVERIFY2(run.code == 0, run.text());
    QVERIFY(run.json().at("collapsed_columns").get<int>() < 400); // of 37,375
    QCOMPARE(here_.ameco({"check", "jet.meshb", "--strict", "-q"}).code, 0);
}

QTEST_GUILESS_MAIN(SurfaceRunTest)
#include "surface_run_test.moc"
