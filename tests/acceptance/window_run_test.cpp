// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/acceptance/run_ameco.h"

using namespace ameco::test;

/// What the program does about its window where there is no screen.
class WindowRunTest : public QObject {
    Q_OBJECT
private slots:
    void without_a_screen_it_says_so();
    void a_screen_that_is_not_there_is_told_in_one_line();
    void a_missing_file_is_told_before_any_window();
    void files_alone_need_a_screen();
    void the_batch_program_needs_no_window_library();
};

void WindowRunTest::without_a_screen_it_says_so() {
    const Run run = Workspace().ameco({"window"});
    QCOMPARE(run.code, 8);
    QVERIFY2(run.err.contains("there is no screen"), run.text());
    QCOMPARE(run.err.count('\n'), 1);
}

void WindowRunTest::a_screen_that_is_not_there_is_told_in_one_line() {
    const Run run = Workspace().shell("DISPLAY=:987 \"$AMECO\" window");
    QCOMPARE(run.code, 8);
    QVERIFY2(run.err.contains("the window cannot be opened") ||
                 run.err.contains("was built without it"),
             run.text());
}

void WindowRunTest::a_missing_file_is_told_before_any_window() {
    const Run run = Workspace().ameco({"window", "nowhere.meshb"});
    QCOMPARE(run.code, 4);
    QVERIFY2(run.err.contains("nowhere.meshb: there is no such file"), run.text());
}

void WindowRunTest::files_alone_need_a_screen() {
    const Workspace here;
    here.write("wing.meshb", "not even read");
    const Run run = here.ameco({"wing.meshb"});
    QCOMPARE(run.code, 2);
    QVERIFY2(run.err.contains("is a file, not a command"), run.text());
}

void WindowRunTest::the_batch_program_needs_no_window_library() {
    const Run run = Workspace().shell("ldd \"$AMECO\"");
    if (run.code != 0) {
        QSKIP("no ldd here");
    }
    for (const char* library :
         {"libQt", "libvtkRendering", "libGL", "libEGL", "libX11", "libxcb"}) {
        QVERIFY2(!run.out.contains(library), library);
    }
}

QTEST_GUILESS_MAIN(WindowRunTest)
#include "window_run_test.moc"
