// SPDX-License-Identifier: AGPL-3.0-or-later
// The formats from outside: what a user has goes in, what a solver reads comes out.
#include "tests/acceptance/run_ameco.h"

#include <cmath>

using namespace ameco::test;

class FormatsRunTest : public QObject {
    Q_OBJECT
private slots:
    void lists_the_formats();
    void coarsens_a_mixed_mesh_and_keeps_its_names();
    void coarsens_quads_and_triangles_in_2d();
    void keeps_names_from_one_solver_to_another();
    void hands_all_levels_to_a_solver();
    void says_in_one_line_what_is_left_out();
    void converts_mesh_and_metric_for_mtc_and_back();
    void writes_a_metric_into_vtu();
    void takes_names_from_a_mapbc_file();
    void converts_surfaces_but_does_not_coarsen_them();
    void explains_formats_it_does_not_know();
};

namespace {

/// A viscous mesh in 2-D for SU2: a strip of flat quadrilaterals at the wall y = 0, and triangles
/// above it. 20 x (8 + 4) cells.
QByteArray viscous_strip() {
    constexpr int n = 20, layers = 8, rows = 12;
    QByteArray points, quads, triangles;
    const auto node = [](int i, int j) { return QByteArray::number(i + j * (n + 1)); };
    double y = 0, h = 1e-3;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= n; ++i) {
            points += QByteArray::number(i / double(n), 'g', 17) + " " +
                      QByteArray::number(y, 'g', 17) + "\n";
        }
        y += j < layers ? h : 0.05;
        h *= j < layers ? 1.4 : 1;
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < n; ++i) {
            const QByteArray a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1),
                             d = node(i, j + 1);
            if (j < layers) {
                quads += "9\t" + a + "\t" + b + "\t" + c + "\t" + d + "\n";
            } else {
                triangles += "5 " + a + " " + b + " " + c + "\n5 " + a + " " + c + " " + d + "\n";
            }
        }
    }
    const auto marker = [&](const char* tag, int count, auto first, auto second) {
        QByteArray text = QByteArray("MARKER_TAG= ") + tag +
                          "\nMARKER_ELEMS= " + QByteArray::number(count) + "\n";
        for (int i = 0; i < count; ++i) {
            text += "3 " + first(i) + " " + second(i) + "\n";
        }
        return text;
    };
    const auto along = [&](int j) {
        return std::pair([=](int i) { return node(i, j); }, [=](int i) { return node(i + 1, j); });
    };
    const auto up = [&](int i) {
        return std::pair([=](int j) { return node(i, j); }, [=](int j) { return node(i, j + 1); });
    };
    return "NDIME= 2\nNELEM= " + QByteArray::number(n * layers + 2 * n * (rows - layers)) + "\n" +
           quads + triangles + "NPOIN= " + QByteArray::number((n + 1) * (rows + 1)) + "\n" +
           points + "NMARK= 4\n" + marker("wall", n, along(0).first, along(0).second) +
           marker("far_field", n, along(rows).first, along(rows).second) +
           marker("inlet", rows, up(0).first, up(0).second) +
           marker("outlet", rows, up(n).first, up(n).second);
}

/// Names of the patches, in the order of their numbers.
QStringList patch_names(const Workspace& here, const QString& file) {
    QStringList names;
    const auto json = here.ameco({"info", "--json", file}).json();
    for (const auto& patch : json.at(0).at("patches")) {
        names << QString::fromStdString(patch.at("name").get<std::string>());
    }
    return names;
}

} // namespace

void FormatsRunTest::lists_the_formats() {
    const Workspace here;
    const Run table = here.ameco({"formats"});
    QCOMPARE(table.code, 0);
    for (const char* suffix : {".meshb", ".su2", ".lb8.ugrid", ".msh", ".dimeco", ".cgns"}) {
        QVERIFY2(table.out.contains(suffix), table.text());
    }
    const auto json = here.ameco({"formats", "--json"}).json();
    QVERIFY(json.size() > 15);
    bool all_there = true;
    for (const auto& format : json) {
        const bool absent = !format.at("reads").get<bool>() && !format.at("writes").get<bool>();
        all_there = all_there && !absent;
    }
    QCOMPARE(table.out.contains("left out of this build: "), !all_there);
    QCOMPARE(json.at(0).at("name").get<std::string>(), std::string("medit"));
}

void FormatsRunTest::coarsens_a_mixed_mesh_and_keeps_its_names() {
    const QString mesh = QString(AMECO_SHARED_DIR) + "/meshes/sphere_slice_mixed.su2";
    if (!QFile::exists(mesh)) {
        QSKIP("AMECO_SHARED_DIR has no meshes/sphere_slice_mixed.su2");
    }
    const Workspace here;
    const Run run = here.ameco({"coarsen", mesh, "-o", "levels", "--levels", "2"});
    QVERIFY2(run.code == 0, run.text());
    QVERIFY2(run.err.contains("7950 prisms and 318 pyramids were split into 24486 tetrahedra, "
                              "192 quadrilaterals into triangles"),
             run.text());
    QCOMPARE(broken_part_of(here, "levels"), QString());
    QCOMPARE(patch_names(here, "levels/level_2.meshb"),
             (QStringList{"symmetry_left", "symmetry_right", "farfield", "wall"}));
    // And back to the solver.
    QCOMPARE(here.ameco({"convert", "levels/level_2.meshb", "coarse.su2"}).code, 0);
    QVERIFY(here.content("coarse.su2").contains("MARKER_TAG= symmetry_right\n"));
}

void FormatsRunTest::coarsens_quads_and_triangles_in_2d() {
    const Workspace here;
    here.write("strip.su2", viscous_strip());
    const Run check = here.ameco({"check", "strip.su2"});
    QVERIFY2(check.code == 0, check.text());
    QVERIFY2(check.err.contains("160 quadrilaterals were split into 320 triangles"), check.text());
    const Run run = here.ameco({"coarsen", "strip.su2", "-o", "levels", "--levels", "1"});
    QVERIFY2(run.code == 0, run.text());
    QCOMPARE(patch_names(here, "levels/level_1.meshb"),
             (QStringList{"wall", "far_field", "inlet", "outlet"}));
}

void FormatsRunTest::keeps_names_from_one_solver_to_another() {
    const Workspace here;
    here.write("strip.su2", viscous_strip());
    QString last = "strip.su2";
    for (const char* name : {"a.msh", "b.node", "c.mesh", "d.su2", "e.vtu", "f.cgns", "g.meshb"}) {
        const Run run = here.ameco({"convert", last, name});
        if (QString(name).contains(QRegularExpression("vtu|cgns")) && run.code != 0) {
            continue; // left out of this build
        }
        QVERIFY2(run.code == 0, run.text());
        last = name;
    }
    QCOMPARE(patch_names(here, last), (QStringList{"wall", "far_field", "inlet", "outlet"}));
}

void FormatsRunTest::hands_all_levels_to_a_solver() {
    const Workspace here;
    here.write("strip.su2", viscous_strip());
    QCOMPARE(here.ameco({"coarsen", "strip.su2", "-o", "levels", "--levels", "1"}).code, 0);
    const Run run = here.ameco({"convert", "levels", "su2", "--to", "su2"});
    QVERIFY2(run.code == 0, run.text());
    QCOMPARE(here.files("su2"), (QStringList{"level_0.su2", "level_1.su2"}));
    QCOMPARE(patch_names(here, "su2/level_1.su2"),
             (QStringList{"wall", "far_field", "inlet", "outlet"}));
    QCOMPARE(here.ameco({"convert", "levels", "su2"}).code, 2);
    const Run vtu = here.ameco({"convert", "levels", "paraview", "--to", "vtu"});
    if (vtu.code != 0) {
        QSKIP("this build leaves out VTK");
    }
    QCOMPARE(here.files("paraview"), (QStringList{"hierarchy.pvd", "level_0.vtu", "level_1.vtu"}));
    QCOMPARE(here.ameco({"check", "paraview/hierarchy.pvd"}).code, 0);
}

void FormatsRunTest::says_in_one_line_what_is_left_out() {
    const Workspace here;
    QCOMPARE(here.ameco({"case", "cube", "--n", "2", "-o", "cube.meshb"}).code, 0);
    const Run run = here.ameco({"convert", "cube.meshb", "cube.dassault"});
    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QString("ameco: warning: cube.dassault: left out, since Dassault cannot hold "
                              "them: names of patches\n"));
    QCOMPARE(here.ameco({"convert", "-q", "cube.meshb", "cube.dassault"}).err, QString());
}

void FormatsRunTest::converts_mesh_and_metric_for_mtc_and_back() {
    const Workspace here;
    QCOMPARE(here.ameco({"case", "cube", "--n", "2", "-o", "cube.meshb"}).code, 0);
    QCOMPARE(here.ameco({"metric", "cube.meshb", "-o", "cube.solb"}).code, 0);
    const Run run = here.ameco({"convert", "cube.meshb", "M6.mtc", "--metric", "cube.solb"});
    QVERIFY2(run.code == 0, run.text());
    QCOMPARE(here.content("M6.mtc"),
             QByteArray("{ M:          M6.t }\n{ Metrique:   M6.metrique }\n"));
    QCOMPARE(here.ameco({"convert", "M6.mtc", "back.solb"}).code, 0);
    QCOMPARE(here.content("back.solb"), here.content("cube.solb"));
    QCOMPARE(here.ameco({"convert", "M6.mtc", "back.dimeco"}).code, 0);
    QCOMPARE(here.ameco({"convert", "cube.meshb", "cube.dimeco"}).code, 0);
    QCOMPARE(here.content("back.dimeco"), here.content("cube.dimeco"));
    QCOMPARE(here.ameco({"convert", "cube.meshb", "a.mesh", "--metric", "cube.solb"}).code, 2);
}

void FormatsRunTest::writes_a_metric_into_vtu() {
    const Workspace here;
    QCOMPARE(here.ameco({"case", "cube", "--n", "2", "-o", "cube.meshb"}).code, 0);
    QCOMPARE(here.ameco({"metric", "cube.meshb", "-o", "cube.solb"}).code, 0);
    const Run run = here.ameco({"convert", "cube.meshb", "cube.vtu", "--metric", "cube.solb"});
    if (run.code == 8) {
        QSKIP("this build leaves out VTK");
    }
    QVERIFY2(run.code == 0, run.text());
    const QByteArray content = here.content("cube.vtu");
    for (const char* name : {"\"metric\"", "\"sizes\"", "\"aspect_ratio\"", "\"patch\""}) {
        QVERIFY2(content.contains(name), name);
    }
    QCOMPARE(here.ameco({"check", "-q", "cube.vtu"}).code, 0);
    QCOMPARE(here.ameco({"case", "cube", "--n", "3", "-o", "other.meshb"}).code, 0);
    const Run other = here.ameco({"convert", "other.meshb", "o.vtu", "--metric", "cube.solb"});
    QCOMPARE(other.code, 2);
    QVERIFY2(other.err.contains("the metric does not belong to the mesh"), other.text());
}

void FormatsRunTest::takes_names_from_a_mapbc_file() {
    const Workspace here;
    QCOMPARE(here.ameco({"case", "cube", "--n", "1", "-o", "cube.meshb"}).code, 0);
    here.write("names.mapbc", "2\n1 3000 solid wall\n2 5000 inflow\n\n");
    QCOMPARE(here.ameco({"convert", "cube.meshb", "named.meshb", "--names", "names.mapbc"}).code,
             0);
    QCOMPARE(patch_names(here, "named.meshb").mid(0, 2), (QStringList{"solid wall", "inflow"}));
}

void FormatsRunTest::converts_surfaces_but_does_not_coarsen_them() {
    const Workspace here;
    here.write("tent.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n"
                            "0 1 0 0\n0 0 1 0\nTriangles\n4\n1 3 2 1\n1 2 4 2\n2 3 4 2\n"
                            "1 4 3 3\nEnd\n");
    QCOMPARE(here.ameco({"convert", "tent.mesh", "tent.msh"}).code, 0);
    QCOMPARE(here.ameco({"convert", "tent.msh", "back.mesh"}).code, 0);
    QVERIFY(here.content("back.mesh").contains("Triangles\n4\n"));
    const Run run = here.ameco({"coarsen", "tent.msh", "-o", "levels"});
    QCOMPARE(run.code, 5);
    QVERIFY2(run.err.contains("is a surface of 4 triangles without tetrahedra"), run.text());
    const Run stl = here.ameco({"convert", "tent.mesh", "tent.stl"});
    if (stl.code != 0) {
        QSKIP("this build leaves out STL");
    }
    QVERIFY2(stl.err.contains("coordinates were rounded to single precision"), stl.text());
    for (const char* name : {"tent.obj", "tent.ply", "tent.off"}) {
        QCOMPARE(here.ameco({"convert", "tent.stl", name}).code, 0);
        const Run run_back = here.ameco({"convert", name, "back.meshb"});
        QVERIFY2(run_back.out.contains("4 nodes"), run_back.text());
    }
}

void FormatsRunTest::explains_formats_it_does_not_know() {
    const Workspace here;
    QCOMPARE(here.ameco({"case", "cube", "--n", "1", "-o", "cube.meshb"}).code, 0);
    const Run suffix = here.ameco({"convert", "cube.meshb", "cube.step"});
    QCOMPARE(suffix.code, 2);
    QVERIFY2(suffix.err.contains("cube.step: cannot be written as a mesh; choose a name that ends "
                                 "in one of .meshb, "),
             suffix.text());
    const Run name = here.ameco({"convert", "cube.meshb", "cube.msh", "--to", "gmsh23"});
    QCOMPARE(name.code, 2);
    QVERIFY2(name.err.contains("gmsh22"), name.text());
}

QTEST_GUILESS_MAIN(FormatsRunTest)
#include "formats_run_test.moc"
