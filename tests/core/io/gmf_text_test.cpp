// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf.h"
#include "tests/core/io/io_support.h"

#include <clocale>

using namespace ameco;
using namespace ameco::test;

class GmfTextTest : public QObject {
    Q_OBJECT
private slots:
    void reads_the_numbers_people_write_data();
    void reads_the_numbers_people_write();
    void reads_the_layouts_people_write_data();
    void reads_the_layouts_people_write();
    void checks_cells_that_stand_before_their_vertices();
    void notes_what_it_skips();
    void reads_reference_strings();
    void writes_the_text_that_other_readers_expect();
    void does_not_care_about_the_locale();
};

namespace {

const std::string tail = "\nTriangles\n1\n1 2 3 0\nEnd\n";

Mesh<2> parse(const std::string& text) {
    return std::get<Mesh<2>>(gmf::read_mesh(text, "text.mesh").value().mesh);
}

} // namespace

void GmfTextTest::reads_the_numbers_people_write_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");
    QTest::newRow("integer") << "3" << 3.0;
    QTest::newRow("no leading digit") << ".5" << 0.5;
    QTest::newRow("no trailing digit") << "5." << 5.0;
    QTest::newRow("plus sign") << "+2.5" << 2.5;
    QTest::newRow("plus sign in the exponent") << "1e+02" << 100.0;
    QTest::newRow("capital E") << "-1.5E-3" << -1.5e-3;
    QTest::newRow("Fortran's D") << "1.25D+02" << 125.0;
    QTest::newRow("Fortran's d") << "-1d-3" << -1e-3;
    QTest::newRow("more digits than a double has") << "0.1000000000000000055511151231257827" << 0.1;
    QTest::newRow("too small for a double") << "1e-400" << 0.0;
    QTest::newRow("too small, Fortran") << "1.0D-400" << 0.0;
    QTest::newRow("subnormal") << "5e-324" << 5e-324;
    QTest::newRow("a comment at once behind") << "7#seven\n" << 7.0;
}

void GmfTextTest::reads_the_numbers_people_write() {
    QFETCH(QString, text);
    QFETCH(double, value);
    const Mesh<2> mesh = parse("MeshVersionFormatted 2\nDimension 2\nVertices\n3\n" +
                               text.toStdString() + " 8 +1\n0 0 0\n0 1 0" + tail);
    QCOMPARE(mesh.points[NodeId(0)].x(), value);
    QCOMPARE(mesh.points[NodeId(0)].y(), 8.0);
    QVERIFY(mesh.labels.raw() == std::vector<int>({1, 0, 0}));
}

void GmfTextTest::reads_the_layouts_people_write_data() {
    QTest::addColumn<QString>("head");
    QTest::newRow("one line each") << "MeshVersionFormatted 2\nDimension 2\n";
    QTest::newRow("two lines each") << "MeshVersionFormatted\n2\n\nDimension\n2\n";
    QTest::newRow("all in one line") << "MeshVersionFormatted 1 Dimension 2 ";
    QTest::newRow("Windows line ends") << "MeshVersionFormatted 2\r\nDimension\r\n2\r\n";
    QTest::newRow("tabs") << "\tMeshVersionFormatted\t2\tDimension\t2\t";
    QTest::newRow("comments") << "# made by hand\nMeshVersionFormatted 2 # two\nDimension 2\n#\n";
    QTest::newRow("byte order mark")
        << QString::fromUtf8("\xef\xbb\xbfMeshVersionFormatted 2\n") + "Dimension 2\n";
    QTest::newRow("version 4") << "MeshVersionFormatted 4\nDimension 2\n";
}

void GmfTextTest::reads_the_layouts_people_write() {
    QFETCH(QString, head);
    const Mesh<2> mesh = parse(head.toStdString() + "Vertices 3 0 0 0\n1 0 0 0 1 0" + tail);
    QCOMPARE(mesh.points.size(), 3U);
    QVERIFY(mesh.points[NodeId(1)] == Vec<2>(1, 0));
    QVERIFY(mesh.points[NodeId(2)] == Vec<2>(0, 1));
    QCOMPARE(mesh.elements.size(), 1U);
}

void GmfTextTest::checks_cells_that_stand_before_their_vertices() {
    const std::string head = "MeshVersionFormatted 2\nDimension 2\nTriangles 1\n1 2 ";
    const std::string vertices = " 5\nVertices 3\n0 0 0\n1 0 0\n0 1 0\nEnd\n";
    QCOMPARE(parse(head + "3" + vertices).region.raw(), std::vector<int>({5}));
    QVERIFY(contains(message_of<InputError>([&] { parse(head + "4" + vertices); }),
                     "text.mesh: triangle 1 uses node 4, but the file has 3 nodes"));
}

void GmfTextTest::notes_what_it_skips() {
    const std::string text =
        "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 0\n1 0 0\n0 1 0\n"
        "Normals\n2\n0 1\n1 0\nNormalAtVertices\n1\n1 1\n"
        "Triangles 1\n1 2 3 0\n";
    const MeshFile file = gmf::read_mesh(text, "text.mesh").value();
    QCOMPARE(file.notes.size(), 2U);
    QVERIFY(contains(file.notes[0], "'Normals' (line 7) 'NormalAtVertices' (line 11)"));
    QVERIFY(contains(file.notes[1], "End"));
    QCOMPARE(std::get<Mesh<2>>(file.mesh).elements.size(), 1U);
}

void GmfTextTest::reads_reference_strings() {
    const std::string text =
        "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 0\n1 0 0\n0 1 0\n"
        "ReferenceStrings\n2\n5 7 End of the wing \n5 8 far field\n" +
        tail;
    QVERIFY(parse(text).patch_names ==
            (std::map<int, std::string>{{7, "End of the wing"}, {8, "far field"}}));
}

void GmfTextTest::writes_the_text_that_other_readers_expect() {
    const Folder folder;
    Mesh<2> mesh;
    mesh.points = IdVector<NodeId, Vec<2>>({Vec<2>(0, 0.1), Vec<2>(1e-9, 0), Vec<2>(-1.5e300, 2)});
    mesh.elements.push_back({NodeId(0), NodeId(1), NodeId(2)});
    mesh.region.push_back(1);
    mesh.faces.push_back({NodeId(0), NodeId(1)});
    mesh.patch.push_back(7);
    mesh.patch_names[7] = "wing";
    mesh.features.corners.push_back(NodeId(2));
    static_cast<void>(write_mesh(folder / "a.mesh", mesh));
    QCOMPARE(content_of(folder / "a.mesh"),
             std::string("MeshVersionFormatted 2\n\nDimension 2\n\nVertices\n3\n0 0.1 0\n"
                         "1e-09 0 0\n-1.5e+300 2 0\n\nEdges\n1\n1 2 7\n\nTriangles\n1\n1 2 3 1\n"
                         "\nCorners\n1\n3\n\n# ameco patch 7 wing\n\nEnd\n"));
}

void GmfTextTest::does_not_care_about_the_locale() {
    const char* const comma_locale = std::setlocale(LC_ALL, "de_DE.UTF-8");
    if (!comma_locale) {
        QSKIP("the machine has no locale with a decimal comma (de_DE.UTF-8)");
    }
    const Folder folder;
    const Mesh<3> mesh = random_mesh<3>(5, false);
    static_cast<void>(write_mesh(folder / "a.mesh", mesh));
    const MeshFile file = read_mesh(folder / "a.mesh");
    std::setlocale(LC_ALL, "C");
    QVERIFY(same_bits(std::get<Mesh<3>>(file.mesh), mesh));
}

QTEST_APPLESS_MAIN(GmfTextTest)
#include "gmf_text_test.moc"
