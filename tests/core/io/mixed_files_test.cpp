// SPDX-License-Identifier: AGPL-3.0-or-later
// One small mixed mesh, by hand in several formats: a cube of one hexahedron, a pyramid on top of
// it, a prism and a tetrahedron beside it.
#include "core/mesh/boundary.h"
#include "core/mesh/check.h"
#include "tests/core/io/io_support.h"

using namespace ameco;
using namespace ameco::test;

class MixedFilesTest : public QObject {
    Q_OBJECT
private slots:
    void reads_the_numbering_of_the_format_data();
    void reads_the_numbering_of_the_format();
    void reads_sparse_tags_and_second_order_from_gmsh();
};

namespace {

/// Nodes 1 ... 8 are the cube's, 9 the pyramid's apex, 10 and 11 the prism's edge at x = 2, 12 the
/// tetrahedron's top above 2, 3, 10.
const char* const points[] = {"0 0 0", "1 0 0", "1 1 0",     "0 1 0", "0 0 1", "1 0 1",
                              "1 1 1", "0 1 1", "0.5 0.5 2", "2 0 0", "2 0 1", "1.5 0 -1"};

std::string rows(const char* before, const char* after) {
    std::string text;
    int number = 0;
    for (const char* point : points) {
        text += (std::string(before) == "#" ? std::to_string(++number) + " " : before) + point +
                after + "\n";
    }
    return text;
}

} // namespace

void MixedFilesTest::reads_the_numbering_of_the_format_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    const auto row = [](const char* name, const std::string& content) {
        QTest::newRow(name) << QString(name) << QByteArray::fromStdString(content);
    };
    // The prism's triangles are 2 10 3 and 6 11 7; the tetrahedron has the nodes 2 3 10 12.
    row("a.ugrid", "12 0 1 1 1 1 1\n" + rows("", "") +
                       "1 4 3 2\n5\n2 3 10 12\n5 8 9 6 7\n2 10 3 6 11 7\n1 2 3 4 5 6 7 8\n");
    row("a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 12\n" + rows("", " 0") +
                      "Quadrilaterals 1\n1 4 3 2 5\nTetrahedra 1\n2 3 10 12 1\n"
                      "Pyramids 1\n5 6 7 8 9 1\nPrisms 1\n2 10 3 6 11 7 1\n"
                      "Hexahedra 1\n1 2 3 4 5 6 7 8 1\nEnd\n");
    row("a.su2", "NDIME= 3\nNELEM= 4\n10 1 2 9 11\n14 4 5 6 7 8\n13 1 9 2 5 10 6\n"
                 "12 0 1 2 3 4 5 6 7\nNPOIN= 12\n" +
                     rows("", "") + "NMARK= 1\nMARKER_TAG= 5\nMARKER_ELEMS= 1\n9 0 3 2 1\n");
    row("a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n12\n" + rows("#", "") +
                     "$EndNodes\n$Elements\n5\n1 3 2 5 1 1 4 3 2\n2 4 2 1 1 2 3 10 12\n"
                     "3 7 2 1 1 5 6 7 8 9\n4 6 2 1 1 2 10 3 6 11 7\n5 5 2 1 1 1 2 3 4 5 6 7 8\n"
                     "$EndElements\n");
}

/// Volumes 1 + 1/3 + 1/2 + 1/6: any other numbering gives another sum, or an invalid mesh.
void MixedFilesTest::reads_the_numbering_of_the_format() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    const Folder folder;
    const MeshFile file = read_mesh(folder.file(name.toStdString(), content.toStdString()));
    auto mesh = std::get<Mesh<3>>(file.mesh);
    QCOMPARE(mesh.faces.size(), 2U);
    QVERIFY(mesh.patch == (IdVector<FaceId, int>(2, 5)));
    complete_boundary(mesh);
    const CheckReport report = check(mesh);
    QVERIFY2(report.valid(), report.summary().c_str());
    QVERIFY2(std::abs(report.volume - 2) < 1e-14, std::to_string(report.volume).c_str());
    QCOMPARE(file.changes.size(), 1U);
    QCOMPARE(file.changes[0],
             std::string("1 prism, 1 pyramid and 1 hexahedron were split into 11 tetrahedra, "
                         "1 quadrilateral into triangles"));
}

void MixedFilesTest::reads_sparse_tags_and_second_order_from_gmsh() {
    const std::string content =
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"wall\"\n"
        "$EndPhysicalNames\n$Nodes\n11\n900 0 0 1\n3 0 0 0\n17 1 0 0\n8 0 1 0\n"
        "21 .5 0 0\n22 .5 .5 0\n23 0 .5 0\n24 0 0 .5\n25 0 .5 .5\n26 .5 0 .5\n1000 5 5 5\n"
        "$EndNodes\n$Elements\n3\n30 11 2 1 1 3 17 8 900 21 22 23 24 25 26\n"
        "12 2 2 7 1 3 8 17\n9 15 2 0 1 3\n$EndElements\n";
    const Folder folder;
    const MeshFile file = read_mesh(folder.file("a.msh", content));
    auto mesh = std::get<Mesh<3>>(file.mesh);
    QCOMPARE(mesh.points.size(), 11U);
    QCOMPARE(mesh.elements.size(), 1U);
    QCOMPARE(mesh.region[ElementId(0)], 1);
    QCOMPARE(mesh.patch_names.at(7), std::string("wall"));
    QVERIFY(contains(file.changes.at(0), "1 elements of second order"));
    QCOMPARE(complete_boundary(mesh).orphans_removed, std::int64_t{7});
    QVERIFY(check(mesh).valid());
}

QTEST_APPLESS_MAIN(MixedFilesTest)
#include "mixed_files_test.moc"
