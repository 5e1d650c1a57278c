// SPDX-License-Identifier: AGPL-3.0-or-later
// Files that other programs wrote. Their counts were read from the files' headers by hand.
#include "core/io/format.h"
#include "core/io/patch_names.h"
#include "tests/core/io/io_support.h"

using namespace ameco;
using namespace ameco::test;

class RealFilesTest : public QObject {
    Q_OBJECT
private slots:
    void keeps_a_mesh_data();
    void keeps_a_mesh();
    void keeps_tensors_data();
    void keeps_tensors();
    void reads_the_same_from_text_and_binary();
    void reads_other_formats_data();
    void reads_other_formats();
};

namespace {

std::filesystem::path shared(const QString& name) {
    return std::filesystem::path(AMECO_SHARED_DIR) / "meshes" / name.toStdString();
}

} // namespace

void RealFilesTest::keeps_a_mesh_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("nodes");
    QTest::addColumn<int>("elements");
    QTest::addColumn<int>("faces");
    QTest::addColumn<int>("edges");
    QTest::addColumn<int>("carried");
    QTest::newRow("cube, binary") << "cube-linear-00.meshb" << 64 << 162 << 108 << 0 << 0;
    QTest::newRow("cube, text") << "cube-linear-00.mesh" << 64 << 162 << 108 << 0 << 0;
    QTest::newRow("cylinder, binary") << "cube-cylinder.meshb" << 286 << 952 << 418 << 62 << 4;
    QTest::newRow("cylinder, text") << "cube-cylinder.mesh" << 286 << 952 << 418 << 0 << 0;
    QTest::newRow("M6, curved") << "onera_m6_curv.meshb" << 1544 << 6495 << 1670 << 189 << 3;
    QTest::newRow("M6, layers") << "m6_67k.meshb" << 67455 << 387024 << 11496 << 0 << 0;
}

/// Binary files come back byte for byte; text files by their values, in both forms.
void RealFilesTest::keeps_a_mesh() {
    QFETCH(QString, name);
    QFETCH(int, nodes);
    QFETCH(int, elements);
    QFETCH(int, faces);
    QFETCH(int, edges);
    QFETCH(int, carried);
    const auto path = shared(name);
    if (!std::filesystem::exists(path)) {
        QSKIP(qPrintable("AMECO_SHARED_DIR has no meshes/" + name));
    }
    const MeshFile file = read_mesh(path);
    const auto& mesh = std::get<Mesh<3>>(file.mesh);
    QCOMPARE(mesh.points.size(), static_cast<std::size_t>(nodes));
    QCOMPARE(mesh.elements.size(), static_cast<std::size_t>(elements));
    QCOMPARE(mesh.faces.size(), static_cast<std::size_t>(faces));
    QCOMPARE(mesh.features.edges.size(), static_cast<std::size_t>(edges));
    QCOMPARE(file.carried.size(), static_cast<std::size_t>(carried));
    const Folder folder;
    for (const char* out : {"out.mesh", "out.meshb"}) {
        static_cast<void>(write_mesh(folder / out, mesh,
                                     {.version = file.format_version, .carried = &file.carried}));
        QVERIFY(same_bits(std::get<Mesh<3>>(read_mesh(folder / out).mesh), mesh));
    }
    if (path.extension() == ".meshb") {
        QVERIFY(content_of(folder / "out.meshb") == content_of(path));
    }
}

void RealFilesTest::keeps_tensors_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("nodes");
    QTest::newRow("cube, binary") << "cube-linear-00.solb" << 64;
    QTest::newRow("cube, text") << "cube-linear-00.sol" << 64;
    QTest::newRow("M6") << "onera_m6_curv-metric.solb" << 1544;
}

/// Every tensor is positive definite, which it would not be in another order of components.
void RealFilesTest::keeps_tensors() {
    QFETCH(QString, name);
    QFETCH(int, nodes);
    const auto path = shared(name);
    if (!std::filesystem::exists(path)) {
        QSKIP(qPrintable("AMECO_SHARED_DIR has no meshes/" + name));
    }
    const TensorFile file = read_tensors(path);
    const auto& tensors = std::get<IdVector<NodeId, Tensor<3>>>(file.tensors);
    QCOMPARE(tensors.size(), static_cast<std::size_t>(nodes));
    const Folder folder;
    for (const char* out : {"out.sol", "out.solb"}) {
        write_tensors<3>(folder / out, tensors, {.version = file.format_version});
        QVERIFY(std::get<0>(read_tensors(folder / out).tensors) == tensors);
    }
    if (path.extension() == ".solb") {
        QVERIFY(content_of(folder / "out.solb") == content_of(path));
    }
    const MetricFile metric = read_metric(path);
    QCOMPARE(std::get<MetricField<3>>(metric.field).size(), static_cast<std::size_t>(nodes));
}

void RealFilesTest::reads_the_same_from_text_and_binary() {
    if (!std::filesystem::exists(shared("cube-linear-00.mesh"))) {
        QSKIP("AMECO_SHARED_DIR has no meshes/cube-linear-00.mesh");
    }
    const auto text = std::get<Mesh<3>>(read_mesh(shared("cube-linear-00.mesh")).mesh);
    const auto binary = std::get<Mesh<3>>(read_mesh(shared("cube-linear-00.meshb")).mesh);
    QVERIFY(text.elements == binary.elements);
    QVERIFY(text.faces == binary.faces);
    QVERIFY(text.patch == binary.patch);
    for (const NodeId node : text.points.ids()) {
        // The text has 15 digits.
        QVERIFY((text.points[node] - binary.points[node]).norm() < 1e-14);
    }
}

void RealFilesTest::reads_other_formats_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("nodes");
    QTest::addColumn<int>("elements");
    QTest::addColumn<int>("faces");
    QTest::addColumn<int>("patches");
    QTest::addColumn<QString>("first_name");
    // 7950 prisms in 3 tets each, 318 pyramids in 2, 312 tets; 192 quadrilaterals in 2 triangles.
    QTest::newRow("sphere, mixed")
        << "sphere_slice_mixed.su2" << 5750 << 24798 << 6116 << 4 << "symmetry_left";
    QTest::newRow("brick, tabs") << "brick_tets.su2" << 11703 << 59156 << 7372 << 6 << "x_m";
    QTest::newRow("cylinder") << "cube-cylinder.ugrid" << 395 << 1937 << 296 << 7 << "";
    QTest::newRow("wedge, ADF") << "wedge2d.cgns" << 3750 << 2 * 3626 << 246 << 4 << "inlet";
    QTest::newRow("jet, surface") << "falcon_full_surface.msh" << 37375 << 0 << 74754 << 29 << "";
}

/// Read, converted into three other formats, and read again: nothing is lost.
void RealFilesTest::reads_other_formats() {
    QFETCH(QString, name);
    QFETCH(int, nodes);
    QFETCH(int, elements);
    QFETCH(int, faces);
    QFETCH(int, patches);
    QFETCH(QString, first_name);
    const auto path = shared(name);
    if (!std::filesystem::exists(path)) {
        QSKIP(qPrintable("AMECO_SHARED_DIR has no meshes/" + name));
    }
    if (!format_of_suffix(path, false)->reads()) {
        QSKIP(qPrintable("this build does not read " + name));
    }
    std::visit(
        [&](const auto& mesh) {
            QCOMPARE(mesh.points.size(), static_cast<std::size_t>(nodes));
            QCOMPARE(mesh.elements.size(), static_cast<std::size_t>(elements));
            QCOMPARE(mesh.faces.size(), static_cast<std::size_t>(faces));
            QCOMPARE(distinct(mesh.patch.raw()).size(), static_cast<std::size_t>(patches));
            if (!first_name.isEmpty()) {
                QCOMPARE(mesh.patch_names.at(1), first_name.toStdString());
            }
            const Folder folder;
            for (const char* out : {"out.meshb", "out.msh", "out.mesh"}) {
                static_cast<void>(write_mesh(folder / out, mesh));
                const auto back = read_mesh(folder / out, {.surfaces = true});
                QVERIFY(same_bits(std::get<std::decay_t<decltype(mesh)>>(back.mesh), mesh));
            }
        },
        read_mesh(path, {.surfaces = true}).mesh);
}

QTEST_APPLESS_MAIN(RealFilesTest)
#include "real_files_test.moc"
