// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/io/gmf_bytes.h"
#include "tests/core/io/io_support.h"
#include "tests/support/shapes.h"

#include <sys/stat.h>
#include <zlib.h>

using namespace ameco;
using namespace ameco::test;

class IoTest : public QObject {
    Q_OBJECT
private slots:
    void recognises_the_format_by_its_content();
    void refuses_what_is_no_mesh_data();
    void refuses_what_is_no_mesh();
    void reports_paths_that_cannot_be_read_data();
    void reports_paths_that_cannot_be_read();
    void unpacks_gz_data();
    void unpacks_gz();
    void reports_damaged_gz();
    void stops_unpacking_what_fills_memory();
    void says_that_compressed_cgns_is_to_be_unpacked();
    void refuses_unknown_suffixes();
};

namespace {

const std::string text_mesh = "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n"
                              "0 1 0\nTriangles\n1\n1 2 3 0\nEnd\n";

std::string packed(const std::filesystem::path& path, const std::string& content) {
    gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, content.data(), static_cast<unsigned>(content.size()));
    gzclose(file);
    return content_of(path);
}

} // namespace

void IoTest::recognises_the_format_by_its_content() {
    const Folder folder;
    const MeshFile text = read_mesh(folder.file("text.meshb", text_mesh));
    QCOMPARE(text.format, std::string("Medit text, version 2"));
    const MeshFile binary = read_mesh(folder.file("binary", tetrahedron(3).finish()));
    QCOMPARE(binary.format, std::string("Medit binary, version 3"));
}

void IoTest::refuses_what_is_no_mesh_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("message");
    QTest::newRow("empty") << QByteArray() << "is empty";
    QTest::newRow("one byte") << QByteArray("M") << "no known format";
    QTest::newRow("zeros") << QByteArray(100, '\0') << "no known format";
    QTest::newRow("noise") << QByteArray("\x8f\x01\xee\xff\x7f\x03\x11\xd2 \n\x9c", 11)
                           << "no known format";
    QTest::newRow("a letter") << QByteArray("Dear colleague,\n") << "no known format";
    QTest::newRow("comments only") << QByteArray("# nothing\n# at all") << "no known format";
    QTest::newRow("noise behind a good start")
        << QByteArray("\x01\0\0\0\x02\0\0\0\xff\xfe\xfd\xfc\xfb\xfa\xf9\xf8", 16) << "byte 8";
}

void IoTest::refuses_what_is_no_mesh() {
    QFETCH(QByteArray, content);
    QFETCH(QString, message);
    const Folder folder;
    const auto path = folder.file("x.mesh", content.toStdString());
    const std::string text = message_of<InputError>([&] { static_cast<void>(read_mesh(path)); });
    QVERIFY(contains(text, name_of(path)));
    QVERIFY(contains(text, message));
    const std::string metric_text =
        message_of<InputError>([&] { static_cast<void>(read_tensors(path)); });
    QVERIFY(contains(metric_text, message));
}

void IoTest::reports_paths_that_cannot_be_read_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("message");
    QTest::newRow("missing") << "missing"
                             << "No such file";
    QTest::newRow("folder") << "folder"
                            << "is a folder, not a file";
    QTest::newRow("pipe") << "pipe"
                          << "is not a regular file";
    QTest::newRow("forbidden") << "forbidden"
                               << "Permission denied";
    QTest::newRow("file taken for a folder") << "below a file"
                                             << "Not a directory";
}

void IoTest::reports_paths_that_cannot_be_read() {
    QFETCH(QString, kind);
    QFETCH(QString, message);
    const Folder folder;
    std::filesystem::path path = folder / "wing.meshb";
    if (kind == "folder") {
        path = folder.path();
    } else if (kind == "pipe") {
        QCOMPARE(::mkfifo(path.c_str(), 0644), 0);
    } else if (kind == "forbidden") {
        static_cast<void>(folder.file("wing.meshb", text_mesh));
        std::filesystem::permissions(path, std::filesystem::perms::none);
    } else if (kind == "below a file") {
        path = folder.file("a", "") / "wing.meshb";
    }
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
    const OrdinaryUser user;
    if (!user) {
        QSKIP("root may read everything, and cannot become another user here");
    }
    const std::string text = message_of<FileError>([&] { static_cast<void>(read_mesh(path)); });
    QVERIFY(contains(text, name_of(path)));
    QVERIFY(contains(text, message));
}

void IoTest::unpacks_gz_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("format");
    QTest::newRow("text") << QByteArray::fromStdString(text_mesh)
                          << "Medit text, version 2, gz-compressed";
    QTest::newRow("long text") << QByteArray::fromStdString(std::string(300000, ' ') + text_mesh)
                               << "Medit text, version 2, gz-compressed";
    QTest::newRow("binary") << QByteArray::fromStdString(triangle(2).finish())
                            << "Medit binary, version 2, gz-compressed";
}

void IoTest::unpacks_gz() {
    QFETCH(QByteArray, content);
    QFETCH(QString, format);
    const Folder folder;
    const std::string gz = packed(folder / "a.mesh.gz", content.toStdString());
    const MeshFile file = read_mesh(folder / "a.mesh.gz");
    QCOMPARE(file.format, format.toStdString());
    QCOMPARE(std::get<Mesh<2>>(file.mesh).elements.size(), 1U);
    // A file may be compressed in several pieces.
    const std::string first = packed(folder / "1.gz", content.toStdString().substr(0, 20));
    const std::string second = packed(folder / "2.gz", content.toStdString().substr(20));
    QCOMPARE(read_mesh(folder.file("both", first + second)).format, format.toStdString());
}

void IoTest::stops_unpacking_what_fills_memory() {
    const Folder folder;
    // Blanks shrink a thousand times.
    static_cast<void>(packed(folder / "a.mesh.gz", text_mesh + std::string(64 << 20, ' ')));
    QVERIFY(contains(
        message_of<InputError>([&] { static_cast<void>(read_mesh(folder / "a.mesh.gz")); }),
        "a.mesh.gz: the gz data holds more than 64 times its size"));
    // The first megabyte is free, so that nothing small is refused.
    static_cast<void>(packed(folder / "b.mesh.gz", text_mesh + std::string(900000, ' ')));
    static_cast<void>(read_mesh(folder / "b.mesh.gz"));
}

void IoTest::says_that_compressed_cgns_is_to_be_unpacked() {
    const Folder folder;
    const auto path = folder / "a.cgns";
    try {
        static_cast<void>(write_mesh(path, shapes::cube(1)));
    } catch (const Error& error) {
        QSKIP(error.what());
    }
    static_cast<void>(packed(folder / "a.cgns.gz", content_of(path)));
    QVERIFY(contains(
        message_of<InputError>([&] { static_cast<void>(read_mesh(folder / "a.cgns.gz")); }),
        "unpack it first"));
}

void IoTest::reports_damaged_gz() {
    const Folder folder;
    const std::string gz = packed(folder / "a.mesh.gz", text_mesh);
    const auto cut = folder.file("cut.mesh.gz", gz.substr(0, gz.size() / 2));
    QVERIFY(contains(message_of<InputError>([&] { static_cast<void>(read_mesh(cut)); }),
                     "cut.mesh.gz: the gz data is truncated"));
    std::string changed = gz;
    changed[gz.size() / 2] = static_cast<char>(~changed[gz.size() / 2]);
    const auto bad = folder.file("bad.mesh.gz", changed);
    QVERIFY(contains(message_of<InputError>([&] { static_cast<void>(read_mesh(bad)); }),
                     "bad.mesh.gz: the gz data is damaged"));
}

void IoTest::refuses_unknown_suffixes() {
    const Folder folder;
    const Mesh<3> mesh = random_mesh<3>(1, false);
    for (const char* name : {"a", "a.step", "a.mesh.gz", "a.sol"}) {
        const std::string text =
            message_of<UsageError>([&] { static_cast<void>(write_mesh(folder / name, mesh)); });
        QVERIFY(contains(text, name_of(folder / name)));
        QVERIFY(contains(text, ".meshb"));
    }
    QCOMPARE(folder.entries(), 0U);
    static_cast<void>(write_mesh(folder / "A.MESHB", mesh));
    QVERIFY(contains(read_mesh(folder / "A.MESHB").format, "binary"));
}

QTEST_APPLESS_MAIN(IoTest)
#include "io_test.moc"
