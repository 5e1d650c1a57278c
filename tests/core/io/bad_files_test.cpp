// SPDX-License-Identifier: AGPL-3.0-or-later
// Damaged and odd files by hand, for every reader but Medit's (gmf_broken_test): one clear line.
#include "core/io/format.h"
#include "tests/core/io/io_support.h"
#include "tests/support/shapes.h"

using namespace ameco;
using namespace ameco::test;

class BadFilesTest : public QObject {
    Q_OBJECT
private slots:
    void says_what_is_wrong_in_one_line_data();
    void says_what_is_wrong_in_one_line();
    void says_it_of_metrics_data();
    void says_it_of_metrics();
    void notices_every_truncation_data();
    void notices_every_truncation();
    void names_the_part_that_is_missing();
    void says_that_names_of_regions_are_left_out();
};

namespace {

void row(const char* what, const char* name, const std::string& content, const char* message) {
    QTest::newRow((std::string(name) + ": " + what).c_str())
        << QString(name) << QByteArray::fromStdString(content) << QString(message);
}

void su2_rows() {
    const std::string points = "NPOIN= 3\n0 0\n1 0\n0 1\n";
    const char* const su2 = "a.su2";
    row("no dimension", su2, "NELEM= 1\n5 0 1 2\n" + points, "has no line NDIME=");
    row("dimension 4", su2, "NDIME= 4\n", "line 1: NDIME= is 4");
    row("no count", su2, "NDIME= 2\nNELEM= many\n", "line 2: NELEM= is followed by 'many'");
    row("large count", su2, "NDIME= 2\nNELEM= 2000000000\n5 0 1 2\n",
        "NELEM= announces 2000000000 rows");
    row("negative count", su2, "NDIME= 2\nNELEM= -1\n", "announces -1 rows");
    row("cell of another kind", su2, "NDIME= 2\nNELEM= 1\n10 0 1 2 3\n" + points,
        "line 3: NELEM, row 1 of 1: cells of the type 10 cannot stand here");
    row("short row", su2, "NDIME= 2\nNELEM= 1\n5 0 1\n" + points,
        "line 3: NELEM, row 1 of 1: the line ends where an integer is expected");
    row("missing row", su2, "NDIME= 2\nNELEM= 2\n5 0 1 2\n             ",
        "NELEM, row 2 of 2: the file ends where a row is expected");
    row("no number", su2, "NDIME= 2\nNELEM= 1\n5 0 x 2\n" + points,
        "expected an integer, found 'x'");
    row("negative node", su2, "NDIME= 2\nNELEM= 1\n5 0 -1 2\n" + points, "there is no node -1");
    row("node not there", su2, "NDIME= 2\nNELEM= 1\n5 0 1 3\n" + points,
        "triangle 0 uses node 3, but the file has 3 nodes");
    row("rows left", su2, "NDIME= 2\nNELEM= 1\n5 0 1 2\n5 0 1 2\n" + points,
        "line 4: expected a line KEY= value, found '5'");
    row("second section", su2, "NDIME= 2\nNELEM= 0\nNELEM= 0\n", "NELEM= occurs a second time");
    row("marker without tag", su2, "NDIME= 2\nMARKER_ELEMS= 0\n", "before any MARKER_TAG=");
    row("two zones", su2, "NZONE= 2\nNDIME= 2\n", "only files of one zone");
    row("no number of a point", su2, "NDIME= 2\nNPOIN= 1\n0 nan(\n", "expected a number");
    row("not finite", su2, "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0\n1 nan\n0 1\n",
        "vertex 1 has a coordinate that is not finite");
}

void ugrid_rows() {
    row("letters", "a.ugrid", "hello", "do not agree with the counts");
    row("short header", "a.ugrid", "1 2 3\n", "count 4: ");
    row("large counts", "a.ugrid", "2000000000 0 0 1 0 0 0\n0 0 0\n", "need more numbers");
    row("negative count", "a.ugrid", "4 -1 0 1 0 0 0\n0 0 0\n", "need more numbers");
    row("node 5 of 4", "a.ugrid", "4 0 0 1 0 0 0\n0 0 0 1 0 0 0 1 0 0 0 1\n1 2 3 5\n",
        "tetrahedron 1 uses node 5, but the file has 4 nodes");
    row("zeros", "a.lb8.ugrid", std::string(200, '\0'), "do not agree with the counts");
    row("noise", "a.b8.ugrid", "\x12\x34\x56\x78 and so on and so forth, not a mesh",
        "do not agree with the counts");
}

void gmsh_rows() {
    const char* const msh = "a.msh";
    const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    const std::string head4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    const std::string nodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
    row("version 1", msh, "$NOD\n1\n1 0 0 0\n$ENDNOD\n", "has no end");
    row("version 4.0", msh, "$MeshFormat\n4.0 0 8\n$EndMeshFormat\n", "the version is '4.0'");
    row("size 4", msh, "$MeshFormat\n2.2 0 4\n$EndMeshFormat\n", "sizes of numbers");
    row("damaged byte order", msh, "$MeshFormat\n2.2 1 8\nabcd\n$EndMeshFormat\n",
        "the mark of the byte order is damaged");
    row("no end", msh, head + "$Comments\nhello", "$Comments has no end");
    row("end of another section", msh, head + "$Nodes\n0\n$EndElements\n", "expected $EndNodes");
    row("no sections", msh, head + "x", "expected a section, found 'x'");
    row("large count", msh, head + "$Nodes\n2000000000\n", "$Nodes announces 2000000000 rows");
    row("node twice", msh, head + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n",
        "the node 1 occurs twice");
    row("node not there", msh, head + nodes + "$Elements\n1\n1 4 2 0 1 1 2 3 9\n$EndElements\n",
        "$Elements, row 1: there is no node 9");
    row("elements first", msh, head + "$Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n" + nodes,
        "before the section $Nodes");
    row("third order", msh, head + nodes + "$Elements\n1\n1 29 2 0 1 1 2 3 4\n$EndElements\n",
        "elements of the type 29 cannot be read");
    row("large tag", msh, head + nodes + "$Elements\n1\n1 4 2 9999999999 1 1 2 3 4\n$EndElements\n",
        "does not fit into 32 bits");
    row("many tags", msh, head + nodes + "$Elements\n1\n1 4 999999999 0 1\n$EndElements\n",
        "expected an integer");
    row("no elements", msh, head + nodes, "holds no tetrahedra");
    row("block too large", msh, head4 + "$Nodes\n1 4 1 4\n3 1 0 999999\n1\n2\n3\n4\n0 0 0\n1 0 0\n",
        "announces 999999 rows");
    row("many entities", msh, head4 + "$Entities\n0 0 0 99999999\n", "announces 99999999 rows");
    row("truncated binary", msh,
        "$MeshFormat\n4.1 1 8\n" + std::string("\1\0\0\0", 4) + "\n$EndMeshFormat\n$Nodes\n1234",
        "takes 8 bytes, but 4 follow");
}

void founding_rows() {
    row("counts only", "a.t", "4 3 1\n", "first line: ");
    row("dimension 4", "a.t", "4 4 1 5\n0 0 0\n", "it is no mesh of MTC");
    row("large count", "a.t", "2000000000 3 1 4\n0 0 0\n", "announces 2000000000 rows");
    row("node 0 first", "a.t", "3 2 1 3\n0 0 1 0 0 1\n0 1 2\n", "element 1: uses node 0");
    row("node 9", "a.t", "3 2 1 3\n0 0 1 0 0 1\n1 2 9\n", "uses node 9, but the file has 3 nodes");
    row("no mesh named", "a.mtc", "{ Metrique: M: }\n", "names no mesh");
    row("no colon", "a.mtc", "{ M: a.t }\n{ Metrique }\n", "expected { M: file }");
    row("mesh not there", "a.mtc", "{ M: absent.t }\n", "No such file");
    row("amount of numbers", "a.dassault", "3 1 0\n0 0 1 0 0 1\n1 2\n",
        "13 numbers in 3-D or 9 in 2-D, but 8 follow");
    row("impossible", "a.dassault", "-3 1 0\n0 0 1 0 0 1\n1 2 3\n", "an impossible mesh");
    row("node 0 and node n", "a.dassault", "3 1 1\n0 0 1 0 0 1\n0 1 2\n3 1 7\n",
        "uses both a node 0 and a node 3");
    row("large label", "a.dassault", "3 1 1\n0 0 1 0 0 1\n1 2 3\n3 1 7777777777\n",
        "the logical number 7777777777");
    row("zeros", "a.dimeco", std::string(64, '\0'), "do not agree with the counts");
    row("short", "a.dimeco", "abc", "do not agree with the counts");
}

void tetgen_rows() {
    row("no counts", "a.node", "# nothing\n", "first line: the file ends where counts");
    row("dimension", "a.node", "4 5 0 0\n", "the dimension is 5");
    row("count", "a.node", "400000 3 0 0\n1 0 0 0\n", "announces 400000 rows");
    row("order", "a.node", "2 3 0 0\n1 0 0 0\n3 0 0 0\n", "node 3 is out of order");
    row("first number", "a.node", "1 3 0 0\n7 0 0 0\n", "node 7 is out of order");
    row("short row", "a.node", "1 3 0 0\n1 0 0\n", "the line ends where a number is expected");
    row("large marker", "a.node", "1 2 0 1\n1 0 0 9e99\n", "does not fit into 32 bits");
    row("no elements", "a.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n", "a.ele: cannot be opened");
}

bool reads(const char* format) {
    return format_of_name(format)->reads();
}

void library_rows() {
    if (reads("cgns")) {
        row("head of ADF only", "a.cgns", "@(#)ADF Database Version A02011>", "a.cgns: ");
        row("head of HDF5 only", "a.cgns", "\x89HDF\r\n\x1a\n", "cannot be opened");
    }
    if (reads("vtu")) {
        const std::string head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
                                 "version=\"0.1\" byte_order=\"LittleEndian\">\n";
        row("empty grid", "a.vtu",
            head + "<UnstructuredGrid><Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/>"
                   "</UnstructuredGrid></VTKFile>",
            "a.vtu: ");
        row("not closed", "a.vtu", head + "<UnstructuredGrid>", "a.vtu: ");
        row("large count", "a.vtu",
            head + "<UnstructuredGrid><Piece NumberOfPoints=\"99999999999\" NumberOfCells=\"0\"/>"
                   "</UnstructuredGrid></VTKFile>",
            "NumberOfPoints=99999999999 is more than the file can hold");
        row("large count", "a.vtk",
            "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            "POINTS 99999999 double\n0 0 0\n",
            "more than the file can hold");
        row("other grid", "a.vtk",
            "# vtk DataFile Version 3.0\nx\nASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS 2 2 1\n"
            "X_COORDINATES 2 double\n0 1\nY_COORDINATES 2 double\n0 1\nZ_COORDINATES 1 double\n0\n",
            "holds no unstructured grid");
        row("names nothing", "a.pvd", "<VTKFile type=\"Collection\"></VTKFile>", "names no file");
    }
}

} // namespace

void BadFilesTest::says_what_is_wrong_in_one_line_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("message");
    su2_rows();
    ugrid_rows();
    gmsh_rows();
    founding_rows();
    tetgen_rows();
    library_rows();
}

void BadFilesTest::says_what_is_wrong_in_one_line() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(QString, message);
    const Folder folder;
    const auto path = folder.file(name.toStdString(), content.toStdString());
    const std::string text = message_of<Error>([&] { static_cast<void>(read_mesh(path)); });
    QVERIFY(text.find(folder.path().string()) == 0);
    QVERIFY2(text.find('\n') == std::string::npos, text.c_str());
    QVERIFY(contains(text, message));
}

void BadFilesTest::says_it_of_metrics_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("message");
    row("no count", "a.metrique", "x", "number of nodes: expected an integer");
    row("amount", "a.metrique", "2\n1 0 0 1\n1 0 0\n", "announces 2 nodes, but 7 numbers follow");
    row("large count", "a.metrique", "2000000000\n1 0 0 1\n", "announces 2000000000 nodes");
    row("not symmetric", "a.metrique", "1\n1 0.5 0 1\n", "node 1: the matrix is not symmetric");
    row("not finite", "a.metrique", "1\n1 inf inf 1\n", "is not finite");
    row("no metric named", "a.mtc", "{ M: a.t }\n", "names no metric");
}

void BadFilesTest::says_it_of_metrics() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(QString, message);
    const Folder folder;
    const auto path = folder.file(name.toStdString(), content.toStdString());
    const std::string text = message_of<Error>([&] { static_cast<void>(read_tensors(path)); });
    QVERIFY(text.find(folder.path().string()) == 0);
    QVERIFY(contains(text, message));
}

void BadFilesTest::notices_every_truncation_data() {
    QTest::addColumn<QString>("suffix");
    for (const char* suffix : {".lb8.ugrid", ".r8.ugrid", ".dimeco", ".msh", ".b8l.ugrid"}) {
        QTest::newRow(suffix) << QString(suffix);
    }
}

/// Cut anywhere, a binary file is an error: its size or its last section tells.
void BadFilesTest::notices_every_truncation() {
    QFETCH(QString, suffix);
    const Folder folder;
    const auto path = folder / ("whole" + suffix.toStdString());
    static_cast<void>(write_mesh(path, shapes::cube(1)));
    const std::string whole = content_of(path);
    const std::string end = "\n$EndElements\n";
    const std::size_t last = suffix == ".msh" ? whole.size() - end.size() : whole.size();
    for (std::size_t size = 0; size < last; ++size) {
        const auto cut = folder.file("cut" + suffix.toStdString(), whole.substr(0, size));
        const std::string text = message_of<InputError>([&] { static_cast<void>(read_mesh(cut)); });
        QVERIFY2(text.find(cut.string()) == 0, text.c_str());
    }
}

void BadFilesTest::names_the_part_that_is_missing() {
    const Folder folder;
    static_cast<void>(write_mesh(folder / "a.node", shapes::cube(1)));
    std::filesystem::remove(folder / "a.face");
    const MeshFile file = read_mesh(folder / "a.ele");
    QVERIFY(std::get<Mesh<3>>(file.mesh).faces.empty());
    QVERIFY(contains(file.notes.at(0), "there is no a.face"));
}

void BadFilesTest::says_that_names_of_regions_are_left_out() {
    const Folder folder;
    const std::string gmsh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                             "$PhysicalNames\n2\n2 1 \"wall\"\n3 7 \"fluid\"\n$EndPhysicalNames\n"
                             "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
                             "$Elements\n2\n1 2 2 1 1 1 2 3\n2 4 2 7 1 1 2 3 4\n$EndElements\n";
    const MeshFile file = read_mesh(folder.file("a.msh", gmsh));
    QVERIFY(contains(file.notes.at(0), "names of regions are left out: 7 fluid"));
    const auto& mesh = std::get<Mesh<3>>(file.mesh);
    QCOMPARE(mesh.region.raw().at(0), 7);
    QCOMPARE(mesh.patch_names.at(1), std::string("wall"));
}

QTEST_APPLESS_MAIN(BadFilesTest)
#include "bad_files_test.moc"
