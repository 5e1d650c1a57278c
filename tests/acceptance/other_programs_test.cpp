// SPDX-License-Identifier: AGPL-3.0-or-later
// Files go to other people's programs and come back: meshio (Debian's python3-meshio) and Gmsh read
// what we write, and we read what they write.
#include "tests/acceptance/run_ameco.h"

using namespace ameco::test;

class OtherProgramsTest : public QObject {
    Q_OBJECT
private slots:
    void meshio_reads_what_we_write_data();
    void meshio_reads_what_we_write();
    void we_read_what_meshio_writes_data();
    void we_read_what_meshio_writes();
    void gmsh_reads_what_we_write_data();
    void gmsh_reads_what_we_write();
    void an_isotropic_mesh_of_gmsh_loses_six_of_seven_nodes();
    void we_read_what_gmsh_writes_data();
    void we_read_what_gmsh_writes();
};

namespace {

const char* const python = "/usr/bin/python3"; // Debian's, which sees Debian's packages

bool has_meshio() {
    return Workspace().shell(QString(python) + " -c 'import meshio'").code == 0;
}
bool has_gmsh() {
    return Workspace().shell("gmsh --version").code == 0;
}

/// A box of 2 x 1 x 1 that Gmsh fills with prisms, and its names.
const QByteArray box_of_prisms =
    "Point(1) = {0,0,0,0.4}; Point(2) = {2,0,0,0.4}; Point(3) = {2,1,0,0.4}; "
    "Point(4) = {0,1,0,0.4};\n"
    "Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1};\n"
    "Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1};\n"
    "out[] = Extrude {0,0,1} { Surface{1}; Layers{3}; Recombine; };\n"
    "Physical Surface(\"wall\", 7) = {1}; Physical Surface(\"lid\", 8) = {out[0]};\n"
    "Physical Surface(\"sides\", 9) = {out[2],out[3],out[4],out[5]};\n"
    "Physical Volume(\"fluid\", 3) = {out[1]};\n";

/// Prints tets, triangles, volume, and the smallest and largest label of the triangles.
const QByteArray count_with_meshio = R"(
import sys, meshio, numpy as np
m = meshio.read(sys.argv[1])
volume, tets, triangles, labels = 0.0, 0, 0, []
for i, c in enumerate(m.cells):
    if c.type == "tetra":
        tets += len(c.data)
        a, b, d, e = (m.points[c.data][:, k] for k in range(4))
        volume += np.einsum("ij,ij->i", np.cross(b - a, d - a), e - a).sum() / 6
    if c.type == "triangle":
        triangles += len(c.data)
        for name in sys.argv[2:]:
            labels += [int(x) for x in m.cell_data[name][i]]
print(len(m.points), tets, triangles, round(volume, 12), *([min(labels), max(labels)] if labels else []))
)";

/// Writes in.mesh in another format, with the labels under the names that Gmsh's format wants.
const QByteArray write_with_meshio = R"(
import sys, meshio
m = meshio.read("in.mesh")
if sys.argv[2].startswith("gmsh"):
    m.cell_data = {name: m.cell_data["medit:ref"] for name in ("gmsh:physical", "gmsh:geometrical")}
meshio.write(sys.argv[1], m, sys.argv[2])
)";

void rows(const std::vector<std::pair<const char*, const char*>>& list) {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("argument");
    for (const auto& [name, argument] : list) {
        QTest::newRow(name) << QString(name) << QString(argument);
    }
}

/// "a.msh --to x" names a file and options.
QString file_of(const QString& name) {
    return name.section(' ', 0, 0);
}

} // namespace

void OtherProgramsTest::meshio_reads_what_we_write_data() {
    rows({{"c.mesh", "medit:ref"},
          {"c.su2", "su2:tag"},
          {"c.ugrid", "ugrid:ref"},
          {"c.lb8.ugrid", "ugrid:ref"},
          {"c.b8.ugrid", "ugrid:ref"},
          {"c.msh", "gmsh:physical"},
          {"c.msh --to gmsh-text", "gmsh:physical"},
          {"c.msh --to gmsh22", "gmsh:physical"},
          {"c.msh --to gmsh22-text", "gmsh:physical"},
          {"c.vtu", "patch"}});
}

void OtherProgramsTest::meshio_reads_what_we_write() {
    QFETCH(QString, name);
    QFETCH(QString, argument);
    if (!has_meshio()) {
        QSKIP("python3-meshio is not installed");
    }
    const Workspace here;
    QCOMPARE(here.ameco({"case", "cube", "--n", "3", "-o", "in.meshb"}).code, 0);
    const Run run = here.ameco(QStringList{"convert", "-q", "in.meshb"} + name.split(' '));
    if (run.code == 8) {
        QSKIP("left out of this build");
    }
    QVERIFY2(run.code == 0, run.text());
    here.write("count.py", count_with_meshio);
    const Run count = here.shell(QString(python) + " count.py " + file_of(name) + " " + argument);
    QVERIFY2(count.out.trimmed().endsWith("64 162 108 1.0 1 6"), count.text());
}

void OtherProgramsTest::we_read_what_meshio_writes_data() {
    rows({{"w.mesh", "medit"},
          {"w.meshb", "medit"},
          {"w.msh", "gmsh22"},
          {"w.vtu", "vtu"},
          {"w.vtk", "vtk"}});
}

void OtherProgramsTest::we_read_what_meshio_writes() {
    QFETCH(QString, name);
    QFETCH(QString, argument);
    if (!has_meshio()) {
        QSKIP("python3-meshio is not installed");
    }
    const Workspace here;
    QCOMPARE(here.ameco({"case", "cube", "--n", "3", "-o", "in.mesh"}).code, 0);
    here.write("write.py", write_with_meshio);
    const Run write = here.shell(QString(python) + " write.py " + name + " " + argument);
    QVERIFY2(write.code == 0, write.text());
    const Run check = here.ameco({"check", "--json", name});
    if (check.code == 8) {
        QSKIP("left out of this build");
    }
    QVERIFY2(check.code == 0, check.text());
    const auto json = check.json();
    QCOMPARE(json.at("elements").get<int>(), 162);
    QCOMPARE(json.at("boundary_faces").get<int>(), 108);
    QVERIFY(std::abs(json.at("volume").get<double>() - 1) < 1e-12);
    const Run info = here.ameco({"info", "--json", name});
    QCOMPARE(info.json().at(0).at("patches").size(), 6U);
}

void OtherProgramsTest::gmsh_reads_what_we_write_data() {
    rows({{"c.mesh", ""},
          {"c.msh", ""},
          {"c.msh --to gmsh-text", ""},
          {"c.msh --to gmsh22", ""},
          {"c.msh --to gmsh22-text", ""}});
}

/// Gmsh writes what it read as Medit text, which we read.
void OtherProgramsTest::gmsh_reads_what_we_write() {
    QFETCH(QString, name);
    if (!has_gmsh()) {
        QSKIP("gmsh is not installed");
    }
    const Workspace here;
    QCOMPARE(here.ameco({"case", "cube", "--n", "3", "-o", "in.meshb"}).code, 0);
    const Run run = here.ameco(QStringList{"convert", "-q", "in.meshb"} + name.split(' '));
    QVERIFY2(run.code == 0, run.text());
    const Run gmsh = here.shell("gmsh " + file_of(name) + " -save -o back.mesh -format mesh");
    QVERIFY2(gmsh.code == 0 && !gmsh.out.contains("Error"), gmsh.text());
    const Run check = here.ameco({"check", "--json", "back.mesh"});
    QVERIFY2(check.code == 0, check.text());
    QCOMPARE(check.json().at("elements").get<int>(), 162);
    QCOMPARE(check.json().at("boundary_faces").get<int>(), 108);
    QCOMPARE(here.ameco({"info", "--json", "back.mesh"}).json().at(0).at("patches").size(), 6U);
}

void OtherProgramsTest::we_read_what_gmsh_writes_data() {
    rows({{"box.msh", "-format msh41"},
          {"binary.msh", "-bin -format msh41"},
          {"old.msh", "-format msh22"},
          {"oldbinary.msh", "-bin -format msh22"},
          {"box.su2", "-format su2"},
          {"box.vtk", "-format vtk"}});
}

void OtherProgramsTest::we_read_what_gmsh_writes() {
    QFETCH(QString, name);
    QFETCH(QString, argument);
    if (!has_gmsh()) {
        QSKIP("gmsh is not installed");
    }
    const Workspace here;
    here.write("box.geo", box_of_prisms);
    const Run gmsh = here.shell("gmsh -3 box.geo " + argument + " -o " + name);
    QVERIFY2(gmsh.code == 0, gmsh.text());
    const Run check = here.ameco({"check", "--json", name});
    if (check.code == 8) {
        QSKIP("left out of this build");
    }
    QVERIFY2(check.code == 0, check.text());
    QVERIFY2(check.err.contains("prisms were split into"), check.text());
    QCOMPARE(check.err.count('\n'), 1);
    QVERIFY(std::abs(check.json().at("volume").get<double>() - 2) < 1e-12);
    const auto patches = here.ameco({"info", "--json", name}).json().at(0).at("patches");
    QCOMPARE(patches.size(), 3U);
    if (name.endsWith(".msh")) {
        QCOMPARE(patches.at(0).at("id").get<int>(), 7);
    }
    if (!name.endsWith(".vtk")) {
        QCOMPARE(patches.at(0).at("name").get<std::string>(), std::string("wall"));
    }
}

/// Of 8 in theory; on the paper's Algorithm 1 see docs/theory/coarsening.md.
void OtherProgramsTest::an_isotropic_mesh_of_gmsh_loses_six_of_seven_nodes() {
    if (!has_gmsh()) {
        QSKIP("gmsh is not installed");
    }
    const Workspace here;
    here.write("cube.geo", "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\n"
                           "Mesh.CharacteristicLengthMin = 0.075;\n"
                           "Mesh.CharacteristicLengthMax = 0.075;\n");
    const Run gmsh = here.shell("gmsh -3 cube.geo -format mesh -o cube.mesh");
    QVERIFY2(gmsh.code == 0, gmsh.text());
    const Run run = here.ameco({"coarsen", "cube.mesh", "-o", "levels", "-n", "1", "--json"});
    QVERIFY2(run.code == 0, run.text());
    const auto level = run.json().at("hierarchy").at("levels").at(1);
    QCOMPARE_GE(level.at("ratio").get<double>(), 6.0);
    QCOMPARE_GE(level.at("nodes").get<double>(), 0.7 * level.at("predicted_nodes").get<double>());
}

QTEST_GUILESS_MAIN(OtherProgramsTest)
#include "other_programs_test.moc"
