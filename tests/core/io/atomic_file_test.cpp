// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/atomic_file.h"
#include "tests/core/io/io_support.h"

#include <csignal>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace ameco;
using namespace ameco::test;

class AtomicFileTest : public QObject {
    Q_OBJECT
private slots:
    void puts_the_whole_file_in_place();
    void leaves_no_trace_without_commit();
    void leaves_the_old_file_when_the_process_is_killed();
    void leaves_the_old_file_when_the_disk_is_full();
    void follows_a_link_to_the_file_it_stands_for();
    void reports_targets_that_cannot_be_written_data();
    void reports_targets_that_cannot_be_written();
    void serves_several_writers_of_one_target();
};

void AtomicFileTest::puts_the_whole_file_in_place() {
    const Folder folder;
    const auto target = folder.file("a.meshb", "old");
    const std::string large(3000000, 'x');
    AtomicFile file(target);
    file.write("begin", 5);
    file.write(large.data(), large.size());
    std::memcpy(file.room(4), "1234", 4);
    file.used(3);
    QCOMPARE(file.position(), std::int64_t{3000008});
    QCOMPARE(content_of(target), std::string("old"));
    file.commit();
    QVERIFY(content_of(target) == "begin" + large + "123");
    QCOMPARE(folder.entries(), 1U);
}

void AtomicFileTest::leaves_no_trace_without_commit() {
    const Folder folder;
    const auto target = folder.file("a.meshb", "old");
    {
        AtomicFile file(target);
        file.write("new", 3);
        QCOMPARE(folder.entries(), 2U);
    }
    QCOMPARE(folder.entries(), 1U);
    QCOMPARE(content_of(target), std::string("old"));
}

void AtomicFileTest::leaves_the_old_file_when_the_process_is_killed() {
    const Folder folder;
    const auto target = folder.file("a.meshb", "old");
    const pid_t child = ::fork();
    if (child == 0) {
        AtomicFile file(target);
        const std::string large(3000000, 'x');
        file.write(large.data(), large.size());
        ::raise(SIGKILL);
    }
    int status = 0;
    QCOMPARE(::waitpid(child, &status, 0), child);
    QVERIFY(WIFSIGNALED(status));
    QCOMPARE(content_of(target), std::string("old"));
    AtomicFile file(target); // the remainder of the killed process is not in the way
    file.write("new", 3);
    file.commit();
    QCOMPARE(content_of(target), std::string("new"));
}

/// A limit on the size of files stands in for a full disk.
void AtomicFileTest::leaves_the_old_file_when_the_disk_is_full() {
    const Folder folder;
    const auto target = folder.file("a.meshb", "old");
    const Mesh<3> mesh = random_mesh<3>(2, false);
    rlimit old_limit{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100, old_limit.rlim_max};
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    const std::string text =
        message_of<FileError>([&] { static_cast<void>(write_mesh(target, mesh)); });
    ::setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_handler);
    QVERIFY(contains(text, name_of(target) + "cannot be written: File too large"));
    QCOMPARE(content_of(target), std::string("old"));
    QCOMPARE(folder.entries(), 1U);
}

void AtomicFileTest::follows_a_link_to_the_file_it_stands_for() {
    const Folder folder;
    const auto target = folder.file("a.meshb", "old");
    std::filesystem::create_symlink("a.meshb", folder / "link.meshb");
    AtomicFile file(folder / "link.meshb");
    file.write("new", 3);
    file.commit();
    QVERIFY(std::filesystem::is_symlink(folder / "link.meshb"));
    QCOMPARE(content_of(target), std::string("new"));
}

void AtomicFileTest::reports_targets_that_cannot_be_written_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("message");
    QTest::newRow("folder missing") << "missing"
                                    << "create its folder first";
    QTest::newRow("folder is a file") << "below a file"
                                      << "create its folder first";
    QTest::newRow("is a folder") << "folder"
                                 << "is a folder; name a file in it";
    QTest::newRow("is a device") << "device"
                                 << "is not a regular file";
    QTest::newRow("read-only folder") << "read-only"
                                      << "choose a folder you may write to";
    QTest::newRow("long name") << "long"
                               << "choose a shorter name";
}

void AtomicFileTest::reports_targets_that_cannot_be_written() {
    QFETCH(QString, kind);
    QFETCH(QString, message);
    const Folder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0777));
    std::filesystem::path target = folder / "missing" / "a.meshb";
    if (kind == "below a file") {
        target = folder.file("a", "") / "a.meshb";
    } else if (kind == "folder") {
        target = folder.path();
    } else if (kind == "device") {
        target = "/dev/null";
    } else if (kind == "long") {
        target = folder / std::string(254, 'a');
    }
    if (kind == "read-only") {
        target = folder / "a.meshb";
        std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
    }
    std::string text;
    {
        const OrdinaryUser user;
        if (!user) {
            QSKIP("root may write everywhere, and cannot become another user here");
        }
        text = message_of<FileError>([&] { const AtomicFile file(target); });
    }
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0700));
    QVERIFY(contains(text, name_of(target)));
    QVERIFY(contains(text, message));
}

void AtomicFileTest::serves_several_writers_of_one_target() {
    const Folder folder;
    AtomicFile first(folder / "a.meshb");
    AtomicFile second(folder / "a.meshb");
    first.write("first", 5);
    second.write("second", 6);
    second.commit();
    first.commit();
    QCOMPARE(content_of(folder / "a.meshb"), std::string("first"));
    QCOMPARE(folder.entries(), 1U);
}

QTEST_APPLESS_MAIN(AtomicFileTest)
#include "atomic_file_test.moc"
