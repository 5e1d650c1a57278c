// SPDX-License-Identifier: AGPL-3.0-or-later
// Thousands of damaged Medit files, the same ones in every run: an Error or a mesh, never a crash,
// never more memory than the size of the file justifies.
#include "core/io/gmf.h"
#include "tests/core/io/gmf_bytes.h"
#include "tests/core/io/io_support.h"
#include "tests/fuzz/allocations.h"
#include "tests/fuzz/damage.h"

using namespace ameco;
using namespace ameco::test;

class GmfMutationTest : public QObject {
    Q_OBJECT
private slots:
    void ends_in_an_error_or_a_mesh_data();
    void ends_in_an_error_or_a_mesh();
};

namespace {

std::string solution(int version, int dimension, bool swapped) {
    GmfBytes b = GmfBytes::of(version, dimension, swapped);
    b.begin(62).integer(3).int32(1).int32(3);
    for (int i = 0; i < 3; ++i) {
        b.real(4).real(0).real(9);
        if (dimension == 3) {
            b.real(0).real(0).real(16);
        }
    }
    return b.end().finish();
}

std::string rich_binary(int version, bool swapped) {
    GmfBytes b = tetrahedron(version, swapped);
    b.begin(13).integer(2).integers({4, 1}).end();
    b.begin(14).integer(1).integers({1}).end();
    b.begin(17).integer(1).integers({1}).end();
    b.begin(41).integer(1).integers({1, 1}).real(0.25).real(1).end();
    b.begin(199).integer(1).integers({6, 7}).text("wing", 64).end();
    return b.finish();
}

const std::string rich_text =
    "MeshVersionFormatted 2\nDimension 3\n# ameco patch 7 wing\nVertices\n4\n0 0 0 1\n"
    "1.5e-9 0 0 0\n0 -1 0 0\n0 0 1D0 0\nEdges\n1\n1 2 5\nTriangles\n1\n1 3 2 7\n"
    "Tetrahedra\n1\n1 2 3 4 2\nCorners\n2\n4 1\nRidges\n1\n1\nRequiredTriangles\n1\n1\n"
    "Normals\n1\n0 0 1\nReferenceStrings\n1\n6 8 far field\nEnd\n";
const std::string plane_text =
    "MeshVersionFormatted 1\nDimension\n3\nVertices\n3\n0 0 0 1\n1 0 0 0\n0 1 0 0\nEdges\n1\n"
    "1 2 5\nTriangles\n1\n1 3 2 7\nEnd\n";
const std::string solution_text =
    "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n3\n1 3\n1 0 1\n2 0.5 2\n1e9 0 1\nEnd\n";

/// Whatever was read can be written, and read again as the same.
void check_second_trip(const Folder& folder, const MeshFile& file) {
    std::visit(
        [&](const auto& mesh) {
            for (const char* name : {"again.mesh", "again.meshb"}) {
                static_cast<void>(
                    write_mesh(folder / name, mesh,
                               {.version = file.format_version, .carried = &file.carried}));
                const MeshFile again = read_mesh(folder / name);
                auto copy = std::get<std::decay_t<decltype(mesh)>>(again.mesh);
                // Names may lose control characters.
                copy.patch_names = mesh.patch_names;
                QVERIFY(same_bits(copy, mesh));
            }
        },
        file.mesh);
}

} // namespace

void GmfMutationTest::ends_in_an_error_or_a_mesh_data() {
    QTest::addColumn<QByteArray>("seed");
    QTest::addColumn<bool>("text");
    const auto row = [](const QString& name, const std::string& seed, bool text) {
        QTest::newRow(qPrintable(name)) << QByteArray::fromStdString(seed) << text;
    };
    for (const int version : {1, 2, 3, 4}) {
        const QString suffix = QString(", version %1").arg(version);
        row("3-D" + suffix, rich_binary(version, false), false);
        row("2-D" + suffix, triangle(version).finish(), false);
        row("solution" + suffix, solution(version, 2 + version % 2, false), false);
        row("3-D, foreign order" + suffix, rich_binary(version, true), false);
    }
    row("text", rich_text, true);
    row("plane in text", plane_text, true);
    row("solution in text", solution_text, true);
}

void GmfMutationTest::ends_in_an_error_or_a_mesh() {
    QFETCH(QByteArray, seed);
    QFETCH(bool, text);
    const Folder folder;
    Random random(20);
    const std::string whole = seed.toStdString();
    int successes = 0;
    int failures = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::string bytes = i == 0 ? whole : damaged(whole, random, text);
        const auto size = static_cast<std::int64_t>(bytes.size());
        std::optional<MeshFile> mesh;
        const std::int64_t before = allocations.live;
        allocations.reset();
        for (const bool as_mesh : {true, false}) {
            try {
                if (as_mesh) {
                    mesh = gmf::read_mesh(bytes, "damaged");
                } else {
                    static_cast<void>(gmf::read_tensors(bytes, "damaged"));
                }
                ++successes;
            } catch (const Error& error) {
                QVERIFY(std::string(error.what()).find("damaged: ") == 0);
                ++failures;
            }
        }
        // A few hundred bytes for messages and bookkeeping, whatever the size of the file.
        const std::int64_t largest = allocations.largest;
        const std::int64_t peak = allocations.peak - before;
        QVERIFY2(largest <= 4 * size + 512, qPrintable(QString::number(largest)));
        QVERIFY2(peak <= 6 * size + 4096, qPrintable(QString::number(peak)));
        if (mesh && i % 50 == 0) {
            check_second_trip(folder, *mesh);
        }
    }
    QVERIFY(successes > 0);
    QVERIFY(failures > 1000);
}

QTEST_APPLESS_MAIN(GmfMutationTest)
#include "gmf_mutation_test.moc"
