// SPDX-License-Identifier: AGPL-3.0-or-later
// Thousands of damaged Medit files, the same ones in every run: an Error or a mesh, never a crash,
// never more memory than the size of the file justifies.
#include "core/io/gmf.h"
#include "tests/core/io/gmf_bytes.h"
#include "tests/core/io/io_support.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {

/// What operator new was asked for since the last `reset`.
struct Allocations {
    std::atomic<std::int64_t> live{0};
    std::atomic<std::int64_t> peak{0};
    std::atomic<std::int64_t> largest{0};

    void reset() {
        peak = live.load();
        largest = 0;
    }
};
Allocations allocations;

void raise_to(std::atomic<std::int64_t>& maximum, std::int64_t value) {
    std::int64_t seen = maximum.load();
    while (value > seen && !maximum.compare_exchange_weak(seen, value)) {
    }
}

void* counted_allocation(std::size_t bytes, std::size_t alignment) {
    void* p = alignment == 0
                  ? std::malloc(bytes == 0 ? 1 : bytes)
                  : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (!p) {
        throw std::bad_alloc();
    }
    const auto usable = static_cast<std::int64_t>(malloc_usable_size(p));
    raise_to(allocations.largest, static_cast<std::int64_t>(bytes));
    raise_to(allocations.peak, allocations.live += usable);
    return p;
}

void counted_release(void* p) {
    if (p) {
        allocations.live -= static_cast<std::int64_t>(malloc_usable_size(p));
        std::free(p);
    }
}

} // namespace

void* operator new(std::size_t bytes) {
    return counted_allocation(bytes, 0);
}
void* operator new[](std::size_t bytes) {
    return counted_allocation(bytes, 0);
}
void* operator new(std::size_t bytes, std::align_val_t a) {
    return counted_allocation(bytes, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t bytes, std::align_val_t a) {
    return counted_allocation(bytes, static_cast<std::size_t>(a));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    return counted_allocation(bytes, 0);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
    return counted_allocation(bytes, 0);
}
void operator delete(void* p) noexcept {
    counted_release(p);
}
void operator delete[](void* p) noexcept {
    counted_release(p);
}
void operator delete(void* p, std::size_t) noexcept {
    counted_release(p);
}
void operator delete[](void* p, std::size_t) noexcept {
    counted_release(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
    counted_release(p);
}
void operator delete[](void* p, std::align_val_t) noexcept {
    counted_release(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
    counted_release(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept {
    counted_release(p);
}

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

/// Random damage of the kinds that happen to files, and of the kinds that hurt readers.
std::string damaged(std::string bytes, Random& random, bool text) {
    constexpr std::int64_t values[] = {
        0,  1,   -1,  2,          54,        0x7fffffff, -0x80000000LL,
        64, 255, 199, 0x10000000, 0x1000000, 1LL << 40,  -(1LL << 62)};
    const char* const tokens[] = {"0",        "-1",          "nan",  "1e999",   "99999999999",
                                  "Vertices", "End",         "\n",   "#",       "+",
                                  "2e",       "Triangles 9", "-0.0", "Prisms 1"};
    for (int i = 1 + random.below(4); i > 0 && !bytes.empty(); --i) {
        const auto at = static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())));
        const auto length = std::min<std::size_t>(bytes.size() - at,
                                                  1 + static_cast<std::size_t>(random.below(16)));
        switch (random.below(7)) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
            break;
        case 1:
            bytes[at] = static_cast<char>(random.below(256));
            break;
        case 2:
            bytes.resize(at);
            break;
        case 3:
            bytes.erase(at, length);
            break;
        case 4:
            bytes.insert(at, bytes.substr(at, length));
            break;
        default:
            if (text) {
                bytes.replace(at, length, tokens[random.below(std::size(tokens))]);
            } else {
                const std::int64_t value = values[random.below(std::size(values))];
                const std::size_t width = random.below(2) ? 4 : 8;
                const std::size_t begin = at / 4 * 4;
                std::memcpy(bytes.data() + begin, &value, std::min(width, bytes.size() - begin));
            }
        }
    }
    return bytes;
}

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
