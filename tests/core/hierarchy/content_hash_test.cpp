// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/content_hash.h"

#include "core/base/error.h"

#include <fstream>

#include <QTemporaryDir>
#include <QtTest>

using namespace ameco;

namespace {

std::uint64_t hash_of(std::string_view text) {
    return content_hash(std::as_bytes(std::span(text.data(), text.size())));
}

} // namespace

class ContentHashTest : public QObject {
    Q_OBJECT
private slots:
    /// Expected values: `xxhsum -H3`, which users can compare with.
    void agrees_with_xxhsum();
    void of_a_file_is_that_of_its_bytes();
    void is_the_same_after_writing_and_reading_it();
    void refuses_what_is_no_hash_data();
    void refuses_what_is_no_hash();
    void names_the_file_it_cannot_read();
};

void ContentHashTest::agrees_with_xxhsum() {
    QCOMPARE(hash_of(""), std::uint64_t{0x2d06800538d394c2u});
    QCOMPARE(hash_of("a"), std::uint64_t{0xe6c632b61e964e1fu});
    QCOMPARE(hash_of("foobar"), std::uint64_t{0xd78fda63144c5c84u});
}

void ContentHashTest::of_a_file_is_that_of_its_bytes() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("data").toStdString();
    std::string content(3'000'017, 'x'); // more than one buffer of the reader
    content[2'999'999] = '\0';
    std::ofstream(path, std::ios::binary) << content;
    QCOMPARE(content_hash_of_file(path), hash_of(content));
}

void ContentHashTest::is_the_same_after_writing_and_reading_it() {
    for (const std::uint64_t hash : {std::uint64_t{0}, std::uint64_t{0x1f}, ~std::uint64_t{0}}) {
        QCOMPARE(parse_hash(hash_text(hash)), hash);
    }
    QCOMPARE(hash_text(0xaf63dc4c8601ec8cu), std::string("xxh3:af63dc4c8601ec8c"));
}

void ContentHashTest::refuses_what_is_no_hash_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("empty") << "";
    QTest::newRow("another kind") << "sha1:af63dc4c8601ec8c0";
    QTest::newRow("too short") << "xxh3:af63";
    QTest::newRow("no number") << "xxh3:af63dc4c8601ecxx";
}

void ContentHashTest::refuses_what_is_no_hash() {
    QFETCH(QString, text);
    QVERIFY_THROWS_EXCEPTION(InputError, (void)parse_hash(text.toStdString()));
}

void ContentHashTest::names_the_file_it_cannot_read() {
    try {
        (void)content_hash_of_file("/no/such/file");
        QFAIL("no exception");
    } catch (const FileError& error) {
        QVERIFY(std::string(error.what()).starts_with("/no/such/file: "));
    }
}

QTEST_APPLESS_MAIN(ContentHashTest)
#include "content_hash_test.moc"
