// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/io/gmf_bytes.h"
#include "tests/core/io/io_support.h"

using namespace ameco;
using namespace ameco::test;

class GmfRoundTripTest : public QObject {
    Q_OBJECT
private slots:
    void keeps_every_bit_of_a_mesh_data();
    void keeps_every_bit_of_a_mesh();
    void reads_files_made_by_hand_data();
    void reads_files_made_by_hand();
    void writes_what_another_program_would_data();
    void writes_what_another_program_would();
    void keeps_a_mesh_as_it_stands();
    void leaves_version_1_when_digits_would_be_lost();
    void carries_unknown_records_data();
    void carries_unknown_records();
    void leaves_out_records_of_other_widths();
    void leaves_out_records_in_foreign_byte_order();
    void reads_names_of_either_width_data();
    void reads_names_of_either_width();
    void mends_names_that_the_format_cannot_hold();
    void takes_triangles_in_a_plane_as_a_2d_mesh();
};

namespace {

template <int D>
void check_round_trip(const Folder& folder, const std::string& suffix, int version, unsigned seed) {
    const Mesh<D> mesh = random_mesh<D>(seed, version == 1);
    const auto path = folder / ("mesh" + suffix);
    const auto notes = write_mesh(path, mesh, {.version = version});
    QVERIFY(notes.empty());
    const MeshFile file = read_mesh(path);
    QVERIFY2(same_bits(std::get<Mesh<D>>(file.mesh), mesh), qPrintable(QString::number(seed)));
    QVERIFY(file.notes.empty());
    QVERIFY(file.carried.empty());
    QCOMPARE(file.format_version, suffix == ".mesh" ? 2 : version);
}

} // namespace

void GmfRoundTripTest::keeps_every_bit_of_a_mesh_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<QString>("suffix");
    QTest::addColumn<int>("version");
    for (const int d : {2, 3}) {
        QTest::addRow("%d-D text", d) << d << ".mesh" << 2;
        for (const int version : {1, 2, 3, 4}) {
            QTest::addRow("%d-D binary %d", d, version) << d << ".meshb" << version;
        }
    }
}

void GmfRoundTripTest::keeps_every_bit_of_a_mesh() {
    QFETCH(int, dimension);
    QFETCH(QString, suffix);
    QFETCH(int, version);
    const Folder folder;
    for (unsigned seed = 0; seed < 30; ++seed) {
        if (dimension == 2) {
            check_round_trip<2>(folder, suffix.toStdString(), version, seed);
        } else {
            check_round_trip<3>(folder, suffix.toStdString(), version, seed);
        }
    }
}

void GmfRoundTripTest::reads_files_made_by_hand_data() {
    QTest::addColumn<int>("version");
    QTest::addColumn<bool>("swapped");
    for (const int version : {1, 2, 3, 4}) {
        QTest::addRow("version %d", version) << version << false;
        QTest::addRow("version %d, foreign byte order", version) << version << true;
    }
}

void GmfRoundTripTest::reads_files_made_by_hand() {
    QFETCH(int, version);
    QFETCH(bool, swapped);
    const Folder folder;
    const GmfBytes bytes = tetrahedron(version, swapped)
                               .begin(13)
                               .integer(2)
                               .integers({4, 1})
                               .end()
                               .begin(14)
                               .integer(1)
                               .integers({1})
                               .end()
                               .begin(15)
                               .integer(1)
                               .integers({2})
                               .end()
                               .begin(16)
                               .integer(1)
                               .integers({1})
                               .end()
                               .begin(17)
                               .integer(1)
                               .integers({1})
                               .end()
                               .begin(12)
                               .integer(1)
                               .integers({1})
                               .end();
    const MeshFile file = read_mesh(folder.file("tet.meshb", bytes.finish()));
    QCOMPARE(file.format_version, version);
    QVERIFY(contains(file.format, QString("Medit binary, version %1").arg(version)));
    const auto& mesh = std::get<Mesh<3>>(file.mesh);
    QCOMPARE(mesh.points.size(), 4U);
    QVERIFY(mesh.points[NodeId(0)] == Vec<3>(0, 0, 0));
    QVERIFY(mesh.points[NodeId(3)] == Vec<3>(0, 0, 1));
    QVERIFY(mesh.labels.raw() == std::vector<int>({9, 0, 0, 0}));
    QVERIFY(mesh.elements.raw() ==
            std::vector<Simplex<3>>({{NodeId(0), NodeId(1), NodeId(2), NodeId(3)}}));
    QVERIFY(mesh.region.raw() == std::vector<int>({2}));
    QVERIFY(mesh.faces.raw() == std::vector<Facet<3>>({{NodeId(0), NodeId(2), NodeId(1)}}));
    QVERIFY(mesh.patch.raw() == std::vector<int>({7}));
    QVERIFY(mesh.features.edges == std::vector<Edge>({{NodeId(0), NodeId(1)}}));
    QVERIFY(mesh.features.edge_labels == std::vector<int>({5}));
    QVERIFY(mesh.features.corners == std::vector<NodeId>({NodeId(3), NodeId(0)}));
    QVERIFY(mesh.features.ridges == std::vector<int>({0}));
    QVERIFY(mesh.features.required_nodes == std::vector<NodeId>({NodeId(1)}));
    QVERIFY(mesh.features.required_edges == std::vector<int>({0}));
    QVERIFY(mesh.features.required_faces == std::vector<int>({0}));
    QVERIFY(mesh.features.required_elements == std::vector<int>({0}));

    const GmfBytes flat = triangle(version, swapped)
                              .begin(14)
                              .integer(1)
                              .integers({1})
                              .end()
                              .begin(17)
                              .integer(1)
                              .integers({1})
                              .end();
    const MeshFile flat_file = read_mesh(folder.file("tria.meshb", flat.finish()));
    const auto& mesh_2d = std::get<Mesh<2>>(flat_file.mesh);
    QVERIFY(mesh_2d.points[NodeId(2)] == Vec<2>(0, 1));
    QVERIFY(mesh_2d.labels.empty());
    QVERIFY(mesh_2d.elements.raw() == std::vector<Simplex<2>>({{NodeId(0), NodeId(1), NodeId(2)}}));
    QVERIFY(mesh_2d.faces.raw() == std::vector<Facet<2>>({{NodeId(0), NodeId(1)}}));
    QVERIFY(mesh_2d.features.ridges == std::vector<int>({0}));
    QVERIFY(mesh_2d.features.required_elements == std::vector<int>({0}));
}

void GmfRoundTripTest::writes_what_another_program_would_data() {
    QTest::addColumn<int>("version");
    for (const int version : {1, 2, 3, 4}) {
        QTest::addRow("version %d", version) << version;
    }
}

/// The same bytes as a file made by hand, in 2-D and 3-D.
void GmfRoundTripTest::writes_what_another_program_would() {
    QFETCH(int, version);
    const Folder folder;
    for (const GmfBytes& bytes : {tetrahedron(version), triangle(version)}) {
        const auto path = folder.file("in.meshb", bytes.finish());
        const MeshFile file = read_mesh(path);
        std::visit(
            [&](const auto& mesh) {
                static_cast<void>(write_mesh(folder / "out.meshb", mesh, {.version = version}));
            },
            file.mesh);
        QVERIFY(content_of(folder / "out.meshb") == bytes.finish());
    }
}

/// Inverted elements, faces turned inwards and unused nodes are not the reader's business.
void GmfRoundTripTest::keeps_a_mesh_as_it_stands() {
    const Folder folder;
    Mesh<3> mesh;
    mesh.points.assign(5, Vec<3>::Zero());
    mesh.elements.push_back({NodeId(3), NodeId(2), NodeId(0), NodeId(2)});
    mesh.region.push_back(-4);
    static_cast<void>(write_mesh(folder / "a.meshb", mesh));
    QVERIFY(std::get<Mesh<3>>(read_mesh(folder / "a.meshb").mesh) == mesh);
}

void GmfRoundTripTest::leaves_version_1_when_digits_would_be_lost() {
    const Folder folder;
    Mesh<3> mesh = random_mesh<3>(1, true);
    mesh.points[NodeId(0)][1] = 0.1;
    const auto notes = write_mesh(folder / "a.meshb", mesh, {.version = 1});
    QCOMPARE(notes.size(), 1U);
    QVERIFY(contains(notes[0], "version 2"));
    const MeshFile file = read_mesh(folder / "a.meshb");
    QCOMPARE(file.format_version, 2);
    QVERIFY(same_bits(std::get<Mesh<3>>(file.mesh), mesh));
    QVERIFY(contains(message_of<UsageError>([&] {
                         static_cast<void>(write_mesh(folder / "a.meshb", mesh, {.version = 5}));
                     }),
                     "version 5"));
}

void GmfRoundTripTest::carries_unknown_records_data() {
    writes_what_another_program_would_data();
}

/// CAD association (40, 41), ByteFlow (126) and a code that nobody knows.
void GmfRoundTripTest::carries_unknown_records() {
    QFETCH(int, version);
    const Folder folder;
    GmfBytes bytes = tetrahedron(version);
    bytes.begin(40).integer(1).integers({1, 1}).end();
    bytes.begin(41).integer(1).integers({1, 1}).real(0.25).real(1).end();
    bytes.begin(126).integer(2).integers({5, 1234}).end();
    bytes.begin(4711).text("anything at all", 15).end();
    const MeshFile file = read_mesh(folder.file("in.meshb", bytes.finish()));
    QCOMPARE(file.carried.size(), 4U);
    QCOMPARE(file.carried[3].keyword, 4711);
    QCOMPARE(file.carried[3].bytes.size(), 15U);
    const auto notes = write_mesh(folder / "out.meshb", std::get<Mesh<3>>(file.mesh),
                                  {.version = version, .carried = &file.carried});
    QVERIFY(notes.empty());
    QVERIFY(content_of(folder / "out.meshb") == bytes.finish());
    const auto text_notes =
        write_mesh(folder / "out.mesh", std::get<Mesh<3>>(file.mesh), {.carried = &file.carried});
    QCOMPARE(text_notes.size(), 1U);
    QVERIFY(contains(text_notes[0], "VerticesOnGeometricEdges"));
}

void GmfRoundTripTest::leaves_out_records_of_other_widths() {
    const Folder folder;
    GmfBytes bytes = tetrahedron(2);
    bytes.begin(126).integer(1).integers({5}).end();
    const MeshFile file = read_mesh(folder.file("in.meshb", bytes.finish()));
    const auto& mesh = std::get<Mesh<3>>(file.mesh);
    for (const int version : {1, 3, 4}) {
        const auto notes =
            write_mesh(folder / "out.meshb", mesh, {.version = version, .carried = &file.carried});
        const MeshFile again = read_mesh(folder / "out.meshb");
        QCOMPARE(again.carried.size(), version == 3 ? 1U : 0U);
        QCOMPARE(notes.size(), version == 3 ? 0U : 1U);
    }
}

void GmfRoundTripTest::leaves_out_records_in_foreign_byte_order() {
    const Folder folder;
    GmfBytes bytes = tetrahedron(2, true);
    bytes.begin(126).integer(1).integers({5}).end();
    const MeshFile file = read_mesh(folder.file("in.meshb", bytes.finish()));
    QVERIFY(file.carried.empty());
    QCOMPARE(file.notes.size(), 1U);
    QVERIFY(contains(file.notes[0], "byte order"));
}

void GmfRoundTripTest::reads_names_of_either_width_data() {
    QTest::addColumn<int>("version");
    QTest::addColumn<int>("width");
    for (const int version : {1, 2, 3, 4}) {
        for (const int width : {64, 256}) {
            QTest::addRow("version %d, %d bytes", version, width) << version << width;
        }
    }
}

/// libMeshb's writer and reader disagree on the width: 64 and 256 bytes.
void GmfRoundTripTest::reads_names_of_either_width() {
    QFETCH(int, version);
    QFETCH(int, width);
    const Folder folder;
    const auto bytes_of_name = static_cast<std::size_t>(width);
    GmfBytes bytes = tetrahedron(version);
    bytes.begin(199).integer(3);
    bytes.integers({6, 7}).text("upper wing   ", bytes_of_name);
    bytes.integers({6, 8}).text(std::string(bytes_of_name, 'x'), bytes_of_name);
    bytes.integers({62, 1}).text("pressure", bytes_of_name).end();
    const MeshFile file = read_mesh(folder.file("in.meshb", bytes.finish()));
    const auto& names = std::get<Mesh<3>>(file.mesh).patch_names;
    QVERIFY(names ==
            (std::map<int, std::string>{{7, "upper wing"}, {8, std::string(bytes_of_name, 'x')}}));
    QCOMPARE(file.notes.size(), 1U);
    QVERIFY(contains(file.notes[0], "1 reference strings"));
}

void GmfRoundTripTest::mends_names_that_the_format_cannot_hold() {
    Mesh<3> mesh = random_mesh<3>(3, false);
    mesh.patch_names = {
        {1, " padded "}, {2, "two\nlines"}, {3, "Flügel"}, {4, " "}, {5, std::string(300, 'x')}};
    const Folder folder;
    for (const char* name : {"a.mesh", "a.meshb"}) {
        const auto notes = write_mesh(folder / name, mesh);
        QCOMPARE(notes.size(), 4U);
        QVERIFY(contains(notes[1], "patch 2 was changed to 'two_lines'"));
        const auto names = std::get<Mesh<3>>(read_mesh(folder / name).mesh).patch_names;
        QVERIFY(names ==
                (std::map<int, std::string>{
                    {1, "padded"}, {2, "two_lines"}, {3, "Flügel"}, {5, std::string(255, 'x')}}));
    }
}

void GmfRoundTripTest::takes_triangles_in_a_plane_as_a_2d_mesh() {
    const Folder folder;
    const auto path = folder.file("plane.mesh", "MeshVersionFormatted 2\nDimension 3\n"
                                                "Vertices 3\n0 0 5 1\n1 0 5 2\n0 1 5 3\n"
                                                "Edges 1\n1 2 7\n"
                                                "Triangles 1\n1 2 3 4\n"
                                                "RequiredTriangles 1\n1\nRidges 1\n1\nEnd\n");
    const MeshFile file = read_mesh(path);
    QCOMPARE(file.notes.size(), 1U);
    QVERIFY(contains(file.notes[0], "2-D"));
    const auto& mesh = std::get<Mesh<2>>(file.mesh);
    QVERIFY(mesh.points[NodeId(1)] == Vec<2>(1, 0));
    QVERIFY(mesh.labels.raw() == std::vector<int>({1, 2, 3}));
    QVERIFY(mesh.region.raw() == std::vector<int>({4}));
    QVERIFY(mesh.faces.raw() == std::vector<Facet<2>>({{NodeId(0), NodeId(1)}}));
    QVERIFY(mesh.patch.raw() == std::vector<int>({7}));
    QVERIFY(mesh.features.required_elements == std::vector<int>({0}));
    QVERIFY(mesh.features.ridges == std::vector<int>({0}));
}

QTEST_APPLESS_MAIN(GmfRoundTripTest)
#include "gmf_round_trip_test.moc"
