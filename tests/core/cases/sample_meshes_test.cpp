// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/io.h"
#include "core/mesh/check.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using namespace ameco;

namespace {

const QString samples = QStringLiteral(AMECO_SOURCE_DIR "/sample_meshes");

QStringList mesh_files(const QString& folder) {
    return QDir(folder).entryList({"*.mesh", "*.meshb"}, QDir::Files, QDir::Name);
}

std::variant<Mesh<3>, Mesh<2>> read(const QString& folder, const QString& file) {
    return read_mesh((folder + "/" + file).toStdString()).mesh;
}

/// Largest distance between nodes of the same number, or infinity where the meshes differ
/// otherwise.
template <int D>
double difference(const Mesh<D>& a, const std::variant<Mesh<3>, Mesh<2>>& any) {
    const auto* b = std::get_if<Mesh<D>>(&any);
    if (b == nullptr || a.elements != b->elements || a.faces != b->faces || a.patch != b->patch ||
        a.points.size() != b->points.size()) {
        return std::numeric_limits<double>::infinity();
    }
    double largest = 0;
    for (const NodeId v : a.points.ids()) {
        largest = std::max(largest, (a.points[v] - b->points[v]).norm());
    }
    return largest;
}

} // namespace

class SampleMeshesTest : public QObject {
    Q_OBJECT
private slots:
    void are_valid_and_small();
    void are_what_the_script_writes();
};

void SampleMeshesTest::are_valid_and_small() {
    qint64 bytes = 0;
    const QStringList files = mesh_files(samples);
    QVERIFY(files.size() >= 7);
    for (const QString& file : files) {
        bytes += QFileInfo(samples + "/" + file).size();
        QVERIFY2(std::visit([](const auto& m) { return check(m).valid(); }, read(samples, file)),
                 qPrintable(file));
    }
    QVERIFY(bytes < 5'000'000);
}

void SampleMeshesTest::are_what_the_script_writes() {
    const QTemporaryDir folder;
    QProcess script;
    script.start(AMECO_SOURCE_DIR "/scripts/make-samples", {AMECO_PROGRAM, folder.path()});
    QVERIFY(script.waitForFinished(120'000));
    QVERIFY2(script.exitCode() == 0, script.readAllStandardError().constData());
    QCOMPARE(mesh_files(folder.path()), mesh_files(samples));
    for (const QString& file : mesh_files(samples)) {
        const auto made = read(folder.path(), file);
        const double distance =
            std::visit([&](const auto& m) { return difference(m, read(samples, file)); }, made);
        // Another mathematical library may round sines differently; nothing else may differ.
        QVERIFY2(distance < 1e-14, qPrintable(file));
    }
}

QTEST_GUILESS_MAIN(SampleMeshesTest)
#include "sample_meshes_test.moc"
