// SPDX-License-Identifier: AGPL-3.0-or-later
// Each kind of broken Medit file: the error is an InputError that names the file and the place.
#include "core/io/gmf.h"
#include "tests/core/io/gmf_bytes.h"
#include "tests/core/io/io_support.h"

#include <limits>

using namespace ameco;
using namespace ameco::test;

class GmfBrokenTest : public QObject {
    Q_OBJECT
private slots:
    void names_the_place_in_a_binary_file_data();
    void names_the_place_in_a_binary_file();
    void names_the_place_in_a_text_file_data();
    void names_the_place_in_a_text_file();
    void never_takes_a_cut_binary_file_for_a_whole_one_data();
    void never_takes_a_cut_binary_file_for_a_whole_one();
    void names_the_first_of_many_broken_rows();
};

namespace {

/// A file with four vertices, the last of which has the coordinate `z`.
GmfBytes with_coordinate(int version, double z) {
    GmfBytes b = GmfBytes::of(version, 3);
    b.begin(4).integer(4);
    for (int i = 0; i < 4; ++i) {
        b.real(i == 1).real(i == 2).real(i == 3 ? z : 0).integer(0);
    }
    b.end();
    return b.begin(8).integer(1).integers({1, 2, 3, 4, 0}).end();
}

/// The four vertices of a good file, and nothing else.
GmfBytes vertices(int version) {
    GmfBytes b = GmfBytes::of(version, 3);
    b.begin(4).integer(4);
    for (int i = 0; i < 4; ++i) {
        b.real(i == 1).real(i == 2).real(i == 3).integer(0);
    }
    return b.end();
}

void row(const char* name, const std::string& bytes, const char* message) {
    QTest::newRow(name) << QByteArray::fromStdString(bytes) << message;
}

void row(const char* name, const GmfBytes& bytes, const char* message) {
    row(name, bytes.finish(), message);
}

void rows_about_records() {
    row("version 7", GmfBytes(7), "version 7");
    row("version -1", GmfBytes(-1), "version -1");
    row("nothing behind the header", GmfBytes(2).bytes(), "ends at byte 8 without an End");
    row("no Dimension", GmfBytes(2), "no Dimension");
    row("Dimension 4", GmfBytes::of(2, 4), "Dimension at byte 8 is 4");
    row("Dimension without a value", GmfBytes(2).begin(3).end(), "Dimension at byte 8 is 0");
    row("record that ends before it begins", GmfBytes::of(2, 3).int32(4).int32(3).integer(0),
        "Vertices at byte 20");
    row("negative position", GmfBytes::of(3, 3).int32(4).int64(-5).integer(0), "byte -5");
    row("position 0", GmfBytes::of(2, 3).int32(4).int32(0).integer(0), "byte 0");
    row("position into its own header", GmfBytes::of(2, 3).int32(4).int32(24).integer(0),
        "byte 24");
    row("position past the end", GmfBytes::of(2, 3).int32(4).int32(1000).integer(0),
        "Vertices at byte 20 ends at byte 1000, but the file has 40 bytes");
    row("position of 2^62", GmfBytes::of(4, 3).int32(4).int64(std::int64_t{1} << 62).integer(0),
        "Vertices at byte 24 ends at byte 4611686018427387904");
    row("no End", tetrahedron(2).bytes(), "without an End");
    row("Tetrahedra twice", tetrahedron(2).begin(8).integer(1).integers({1, 2, 3, 4, 2}).end(),
        "Tetrahedra occurs a second time at byte");
    row("no room for a count", GmfBytes::of(2, 3).begin(4).end(), "Vertices at byte 20");
    GmfBytes many = tetrahedron(2);
    for (int i = 0; i < 5000; ++i) {
        many.begin(99).end();
    }
    row("5000 records", many, "more than 4096 records");
}

void rows_about_counts() {
    row("count of 2^31 - 1", GmfBytes::of(2, 3).begin(4).integer(2147483647).real(0).end(),
        "Vertices at byte 20 announces 2147483647 rows of 28 bytes");
    row("count of 2^31", GmfBytes::of(4, 3).begin(4).integer(2147483648).real(0).end(),
        "announces 2147483648 rows");
    row("count of 2^62", GmfBytes::of(4, 3).begin(4).integer(std::int64_t{1} << 62).end(),
        "announces 4611686018427387904 rows");
    row("count of -1", GmfBytes::of(2, 3).begin(4).integer(-1).end(), "announces -1 rows");
    row("one row too many", vertices(2).begin(8).integer(2).integers({1, 2, 3, 4, 0}).end(),
        "Tetrahedra at byte 144 announces 2 rows of 20 bytes, but has room for 20");
    row("corners too many", tetrahedron(2).begin(13).integer(2).integers({1}).end(),
        "Corners at byte");
    row("prisms too many", tetrahedron(2).begin(9).integer(1000000).end(), "Prisms at byte");
}

void rows_about_nodes() {
    row("node 5 of 4", vertices(2).begin(8).integer(1).integers({1, 2, 3, 5, 0}).end(),
        "tetrahedron 1 uses node 5, but the file has 4 nodes");
    row("node 0", vertices(2).begin(8).integer(1).integers({0, 2, 3, 4, 0}).end(),
        "tetrahedron 1 uses node 0, but nodes are numbered from 1");
    row("smallest integer",
        vertices(2).begin(8).integer(1).integers({1, -2147483648LL, 3, 4, 0}).end(),
        "uses node -2147483648");
    row("node of 2^32 + 1",
        vertices(4).begin(8).integer(1).integers({(std::int64_t{1} << 32) + 1, 2, 3, 4, 0}).end(),
        "uses node 4294967297");
    row("smallest long integer",
        vertices(4)
            .begin(8)
            .integer(1)
            .integers({std::numeric_limits<std::int64_t>::min(), 2, 3, 4, 0})
            .end(),
        "uses node -9223372036854775808");
    row("node of a triangle",
        vertices(2)
            .begin(6)
            .integer(1)
            .integers({1, 2, 9, 0})
            .end()
            .begin(8)
            .integer(1)
            .integers({1, 2, 3, 4, 0})
            .end(),
        "triangle 1 uses node 9");
    row("node of an edge", vertices(2).begin(5).integer(1).integers({1, 9, 0}).end(),
        "edge 1 uses node 9");
    row("node of a triangle in 2-D",
        GmfBytes::of(2, 2)
            .begin(4)
            .integer(1)
            .real(0)
            .real(0)
            .integer(0)
            .end()
            .begin(6)
            .integer(1)
            .integers({1, 2, 1, 0})
            .end(),
        "triangle 1 uses node 2");
    row("corner 9 of 4", tetrahedron(2).begin(13).integer(2).integers({1, 9}).end(),
        "corner 2 is vertex 9, but the file has 4 vertices");
    row("corner 0", tetrahedron(2).begin(13).integer(2).integers({1, 0}).end(),
        "corner 2 is number 0");
    row("required vertex", tetrahedron(2).begin(15).integer(1).integers({5}).end(),
        "required vertex 1 is vertex 5");
    row("ridge", tetrahedron(2).begin(14).integer(1).integers({2}).end(),
        "ridge 1 is edge 2, but the file has 1 edges");
    row("required edge", tetrahedron(2).begin(16).integer(1).integers({2}).end(),
        "required edge 1 is edge 2");
    row("required triangle", tetrahedron(2).begin(17).integer(1).integers({2}).end(),
        "required triangle 1 is triangle 2");
    row("required tetrahedron", tetrahedron(2).begin(12).integer(1).integers({2}).end(),
        "required tetrahedron 1 is tetrahedron 2");
    row("required triangle in 2-D", triangle(2).begin(17).integer(1).integers({2}).end(),
        "required triangle 1 is triangle 2, but the file has 1 triangles");
    row("label of 2^40",
        vertices(4).begin(8).integer(1).integers({1, 2, 3, 4, std::int64_t{1} << 40}).end(),
        "tetrahedron 1 has the label 1099511627776");
}

void rows_about_content() {
    row("NaN", with_coordinate(2, std::numeric_limits<double>::quiet_NaN()),
        "vertex 4 has a coordinate that is not finite");
    row("infinity", with_coordinate(2, std::numeric_limits<double>::infinity()), "vertex 4");
    row("NaN in single precision", with_coordinate(1, std::numeric_limits<double>::quiet_NaN()),
        "vertex 4");
    row("no vertices", GmfBytes::of(2, 3), "holds no vertices");
    row("no elements", vertices(2), "holds no tetrahedra");
    row("no elements, 2-D", GmfBytes::of(2, 2).begin(4).integer(1).real(0).real(0).integer(0).end(),
        "holds no triangles");
    row("count of 0", vertices(2).begin(8).integer(0).end(), "holds no tetrahedra");
    row("curved elements only", vertices(2).begin(30).integer(0).end(), "it holds TetrahedraP2");
    row("a surface", vertices(2).begin(6).integer(1).integers({2, 3, 4, 0}).end(),
        "is a surface of 1 triangles without tetrahedra");
    row("tetrahedra in 2-D", triangle(2).begin(8).integer(1).integers({1, 2, 3, 1, 0}).end(),
        "1 tetrahedra, but its Dimension is 2");
    row("a solution", GmfBytes::of(2, 3).begin(62).integer(1).int32(1).int32(1).real(1).end(),
        "holds a solution and no mesh");
}

} // namespace

void GmfBrokenTest::names_the_place_in_a_binary_file_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message");
    rows_about_records();
    rows_about_counts();
    rows_about_nodes();
    rows_about_content();
}

void GmfBrokenTest::names_the_place_in_a_binary_file() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    const std::string text = message_of<InputError>(
        [&] { static_cast<void>(gmf::read_mesh(bytes.toStdString(), "wing.meshb")); });
    QVERIFY(contains(text, "wing.meshb: "));
    QVERIFY(contains(text, message));
    QVERIFY2(text.find('\n') == std::string::npos, "a message is one line");
}

void GmfBrokenTest::names_the_place_in_a_text_file_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message");
    const std::string head = "MeshVersionFormatted 2\nDimension 2\n";
    const std::string points = head + "Vertices\n3\n0 0 0\n1 0 0\n0 1 0\n";
    row("version 5", "MeshVersionFormatted 5\nDimension 2\n", "line 1: MeshVersionFormatted is 5");
    row("no version", "MeshVersionFormatted\nDimension 2\n", "line 2: expected an integer");
    row("end of file for a version", "MeshVersionFormatted", "line 1: the file ends");
    row("no Dimension", "MeshVersionFormatted 2\nVertices\n0\n", "line 2: expected Dimension");
    row("Dimension 1", "MeshVersionFormatted 2\n\nDimension 1\n", "line 3: Dimension is 1");
    row("letters for a coordinate", head + "Vertices\n3\n0 0 0\n0 x 0\n0 0 0\n",
        "line 6: Vertices, row 2 of 3: expected a number, found 'x'");
    row("a number with letters", head + "Vertices\n3\n0 0 0\n0 1.5abc 0\n0 0 0\n",
        "line 6: Vertices, row 2 of 3: expected a number, found '1.5abc'");
    row("too large for a double", head + "Vertices\n3\n0 0 0\n0 1e400 0\n0 0 0\n",
        "line 6: Vertices, row 2 of 3: expected a number in the range of double");
    row("a real for a label", head + "Vertices\n3\n0 0 0\n0 1 0.5\n0 0 0\n",
        "line 6: Vertices, row 2 of 3: expected an integer, found '0.5'");
    row("a row too few", head + "Vertices\n3\n0 0 0\n0 1 0\nTriangles\n1\n1 2 3 0\nEnd\n",
        "line 7: Vertices, row 3 of 3: expected a number, found 'Triangles'");
    row("a row too many", head + "Vertices\n2\n0 0 0\n0 1 0\n1 1 0\nEnd\n",
        "line 7: expected a keyword, found '1'");
    row("z in a 2-D file", head + "Vertices\n2\n0 0 0 0\n0 1 0 0\nEnd\n",
        "line 6: expected a keyword, found '0'; a row above has too many numbers");
    row("the file ends in a row", head + "Vertices\n3\n0 0 0\n0.000000 1.000000 0\n0.25",
        "line 7: Vertices, row 3 of 3: the file ends where a number is expected");
    row("count of 2^31", head + "Vertices\n2147483648\n0 0 0\n",
        "line 4: Vertices announces 2147483648 rows");
    row("count beyond the file", head + "Vertices\n1000\n0 0 0\n", "line 4: Vertices announces");
    row("negative count", head + "Vertices\n-1\n0 0 0\n", "Vertices announces -1 rows");
    row("count of 2^64", head + "Vertices\n18446744073709551616\n0 0 0\n", "expected an integer");
    row("no count", head + "Vertices\nTriangles\n", "line 4: Vertices: expected an integer");
    row("node 9 of 3", points + "Triangles\n2\n1 2 3 0\n1 2 9 0\nEnd\n",
        "triangle 2 uses node 9, but the file has 3 nodes");
    row("node 0", points + "Triangles\n1\n1 2 0 0\nEnd\n", "triangle 1 uses node 0");
    row("node of 2^33 before vertices", head + "Triangles\n1\n1 2 8589934592 0\n",
        "triangle 1 uses node 8589934592");
    row("NaN", head + "Vertices\n3\n0 0 0\nnan 0 0\n0 1 0\nTriangles\n1\n1 2 3 0\nEnd\n",
        "vertex 2 has a coordinate that is not finite");
    row("infinity", head + "Vertices\n3\n0 0 0\n1 0 0\n0 -inf 0\nTriangles\n1\n1 2 3 0\nEnd\n",
        "vertex 3 has");
    row("Vertices twice", points + "Vertices\n1\n0 0 0\nEnd\n", "second time at line 8");
    row("a large label", points + "Triangles\n1\n1 2 3 9999999999\nEnd\n",
        "triangle 1 has the label 9999999999");
    row("no elements", points + "End\n", "holds no triangles");
    row("no vertices", head + "End\n", "holds no vertices");
    row("a corner that does not exist", points + "Triangles\n1\n1 2 3 0\nCorners\n1\n4\nEnd\n",
        "corner 1 is vertex 4, but the file has 3 vertices");
    row("characters that no terminal should see", head + "\x1b[31mred\x1b[0m\n",
        "line 3: expected a keyword, found '?[31mred?[0m'");
}

void GmfBrokenTest::names_the_place_in_a_text_file() {
    names_the_place_in_a_binary_file();
}

void GmfBrokenTest::never_takes_a_cut_binary_file_for_a_whole_one_data() {
    QTest::addColumn<int>("version");
    for (const int version : {1, 2, 3, 4}) {
        QTest::addRow("version %d", version) << version;
    }
}

void GmfBrokenTest::never_takes_a_cut_binary_file_for_a_whole_one() {
    QFETCH(int, version);
    const std::string whole = tetrahedron(version).finish();
    for (std::size_t length = 8; length < whole.size(); ++length) {
        const std::string text = message_of<InputError>(
            [&] { static_cast<void>(gmf::read_mesh(whole.substr(0, length), "cut.meshb")); });
        QVERIFY(contains(text, "cut.meshb: "));
    }
}

/// Rows are read by several threads; the message is the same for any number of them.
void GmfBrokenTest::names_the_first_of_many_broken_rows() {
    GmfBytes b = vertices(2);
    const int n = 300000;
    b.begin(8).integer(n);
    for (int i = 0; i < n; ++i) {
        b.integers({1, 2, 3, i >= 200000 && i % 7 == 3 ? 77 : 4, 0});
    }
    b.end();
    const std::string text = message_of<InputError>(
        [&] { static_cast<void>(gmf::read_mesh(b.finish(), "wing.meshb")); });
    QVERIFY(contains(text, "tetrahedron 200001 uses node 77"));
}

QTEST_APPLESS_MAIN(GmfBrokenTest)
#include "gmf_broken_test.moc"
