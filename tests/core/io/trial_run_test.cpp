// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/trial_run.h"

#include "core/base/error.h"

#include <QTest>

#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

using namespace ameco;

class TrialRunTest : public QObject {
    Q_OBJECT
private slots:
    void a_good_read_changes_nothing();
    void a_crash_is_an_error_of_the_file();
    void an_error_of_the_trial_is_thrown_as_it_is();
    void memory_beyond_the_bound_is_refused_data();
    void memory_beyond_the_bound_is_refused();
};

namespace {

std::string message_of(const TrialMemory& memory, const std::function<void()>& read) {
    try {
        require_survival("a.vtu", "VTK", memory, read);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// Touches nothing: asking is what is bounded.
void ask_for(std::int64_t bytes) {
    std::vector<char> memory;
    memory.reserve(static_cast<std::size_t>(bytes));
}

} // namespace

void TrialRunTest::a_good_read_changes_nothing() {
    int reads = 0;
    QCOMPARE(message_of({1000}, [&] { ++reads; }), std::string());
    QCOMPARE(reads, 0); // it was another process
}

void TrialRunTest::a_crash_is_an_error_of_the_file() {
    const std::string expected = "a.vtu: VTK breaks down over it; the file is damaged";
    QCOMPARE(message_of({1000}, [] { std::abort(); }), expected);
    QCOMPARE(message_of({1000}, [] { std::raise(SIGSEGV); }), expected);
    QCOMPARE(message_of({1000}, [] { std::_Exit(3); }), expected);
}

void TrialRunTest::an_error_of_the_trial_is_thrown_as_it_is() {
    QCOMPARE(message_of({1000}, [] { throw InputError("a.vtu: is odd"); }),
             std::string("a.vtu: is odd"));
    QVERIFY_THROWS_EXCEPTION(FileError, require_survival("a.vtu", "VTK", {1000}, [] {
                                 throw FileError("b.vtu: is not there");
                             }));
}

void TrialRunTest::memory_beyond_the_bound_is_refused_data() {
    QTest::addColumn<int>("megabytes");
    QTest::addColumn<bool>("refused");
    QTest::newRow("4 times the file") << 40 << false;
    QTest::newRow("more") << 80 << true;
    QTest::newRow("a great deal") << 100000 << true;
}

void TrialRunTest::memory_beyond_the_bound_is_refused() {
#if defined(__SANITIZE_ADDRESS__)
    QSKIP("a sanitizer's memory is counted otherwise");
#endif
    QFETCH(int, megabytes);
    QFETCH(bool, refused);
    const std::string message = message_of(
        {std::int64_t{10} << 20}, [=] { ask_for(static_cast<std::int64_t>(megabytes) << 20); });
    QCOMPARE(message.empty(), !refused);
    if (refused) {
        QCOMPARE(message, std::string("a.vtu: asks for more memory than the 72 MiB that a file "
                                      "of this size can need; it is damaged"));
    }
}

QTEST_APPLESS_MAIN(TrialRunTest)
#include "trial_run_test.moc"
