// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/acceptance/run_ameco.h"

#include <QRegularExpression>

using namespace ameco::test;

class HelpTest : public QObject {
    Q_OBJECT
private slots:
    void is_printed_when_nothing_is_asked_for();
    void begins_with_examples_data();
    void begins_with_examples();
    void fits_a_narrow_terminal_data();
    void fits_a_narrow_terminal();
    void tells_the_version();
    void explains_wrong_usage_in_one_line_data();
    void explains_wrong_usage_in_one_line();
    void takes_common_options_before_and_after_the_command();
    void uses_no_colour_outside_a_terminal();
    /// docs/user/cli.md holds the help texts; AMECO_UPDATE_DOCS=1 writes it anew.
    void is_the_same_in_the_manual();
    void is_the_same_in_the_man_page();
};

namespace {

const QStringList commands{"info",   "check",   "surface",  "metric",    "coarsen",
                           "remesh", "fill",    "transfer", "multigrid", "render",
                           "report", "convert", "formats",  "case",      "window"};

constexpr const char* conduct =
    "Results go to standard output, everything else to standard error. `--json` gives the same\n"
    "results for programs. On a terminal a line shows progress; elsewhere a line is printed every "
    "10 %.\nThe first Ctrl-C asks a run to stop at the next safe place, the second one stops it at "
    "once.\nMessages are coloured on a terminal unless `NO_COLOR` is set. No input file is ever "
    "overwritten,\nand an output file appears whole or not at all.\n";

struct ExitMeaning {
    int code;
    const char* meaning;
};
constexpr ExitMeaning exit_codes[] = {
    {0, "done"},
    {1, "a bug of ours: please report it"},
    {2, "wrong usage: the message says what and where to look"},
    {3, "a check failed: not a valid mesh (`check`), an operator that is not what it must be "
        "(`transfer`), nothing could be coarsened (`coarsen`)"},
    {4, "a file cannot be read or written"},
    {5, "a file was read, but what it holds is not a usable mesh or metric"},
    {6, "stopped early; the levels that were finished are kept"},
    {7, "not enough memory"},
    {8, "the feature was left out of this build, or the machine cannot do it"},
    {130, "stopped before there was a result"}};

/// As text of a man page: nothing in it is an instruction.
QString roff(QString text) {
    text.replace('\\', "\\e").replace('-', "\\-").replace("\n.", "\n\\&.").replace("\n'", "\n\\&'");
    return text.endsWith('\n') || text.isEmpty() ? text : text + '\n';
}

/// Compares a page of the documentation with what it should be, or writes it when asked to.
void compare_or_update(const QString& name, const QString& text) {
    const QString path = QString(AMECO_SOURCE_DIR) + "/" + name;
    if (qEnvironmentVariableIsSet("AMECO_UPDATE_DOCS")) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text.toUtf8());
        return;
    }
    QVERIFY2(QString::fromUtf8(content_of(path)) == text,
             qPrintable(name + " is out of date: run this test with AMECO_UPDATE_DOCS=1"));
}

void add_command_rows() {
    QTest::addColumn<QString>("command");
    for (const QString& command : commands) {
        QTest::newRow(qPrintable(command)) << command;
    }
}

} // namespace

void HelpTest::is_printed_when_nothing_is_asked_for() {
    const Run run = Workspace().ameco({});
    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QString());
    for (const QString& command : commands) {
        QVERIFY2(run.out.contains("\n  " + command + " "), run.text());
    }
    QCOMPARE(Workspace().ameco({"--help"}).out, run.out);
    // No command is left out of these tests, nor of the manual.
    QStringList listed;
    const QRegularExpression line("^  ([a-z]+)  +[A-Z]");
    for (const QString& text : run.out.split('\n')) {
        if (const auto match = line.match(text); match.hasMatch()) {
            listed << match.captured(1);
        }
    }
    QCOMPARE(listed, commands);
}

void HelpTest::begins_with_examples_data() {
    add_command_rows();
}

void HelpTest::begins_with_examples() {
    QFETCH(QString, command);
    const Run run = Workspace().ameco({command, "-h"});
    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QString());
    const auto examples = run.out.indexOf("\nExamples:\n  ameco " + command);
    QVERIFY2(examples > 0 && examples < run.out.indexOf("\nUsage:\n"), run.text());
    QVERIFY2(run.out.contains("\n      --json "), run.text());
}

void HelpTest::fits_a_narrow_terminal_data() {
    add_command_rows();
}

void HelpTest::fits_a_narrow_terminal() {
    QFETCH(QString, command);
    for (const QString& line : Workspace().ameco({command, "-h"}).out.split('\n')) {
        QVERIFY2(line.size() <= 80, qPrintable(line));
    }
}

void HelpTest::tells_the_version() {
    const Run run = Workspace().ameco({"--version"});
    QCOMPARE(run.code, 0);
    QVERIFY2(QRegularExpression("^ameco \\d+\\.\\d+\\.\\d+\\n$").match(run.out).hasMatch(),
             run.text());
}

void HelpTest::explains_wrong_usage_in_one_line_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("complaint");
    const auto row = [](const char* what, const QStringList& arguments, const char* complaint) {
        QTest::newRow(what) << arguments << complaint;
    };
    row("command", {"corsen", "a.mesh", "-o", "b"},
        "unknown command corsen, did you mean coarsen? (see ameco --help)");
    row("strange command", {"frobnicate"}, "unknown command frobnicate (see ameco --help)");
    row("a file as command", {"/etc/hostname"}, "/etc/hostname is a file, not a command: try");
    row("option", {"coarsen", "a.mesh", "-o", "b", "--levles", "3"},
        "unknown option --levles, did you mean --levels? (see ameco coarsen --help)");
    row("option with =", {"info", "a.mesh", "--thread=3"}, "did you mean --threads?");
    row("option before what is missing", {"coarsen", "--levles"}, "did you mean --levels?");
    row("missing argument", {"coarsen"}, "is missing (see ameco coarsen --help)");
    row("missing output", {"metric", "a.mesh"}, "--output is missing");
    row("too many", {"check", "a.mesh", "b.mesh"}, "one argument too many: b.mesh");
    row("not a number", {"coarsen", "a.mesh", "-o", "b", "--levels", "x"},
        "--levels: x is not a whole number from 1 to 100");
    row("factor", {"coarsen", "a.mesh", "-o", "b", "--factor", "1"},
        "--factor: 1 is not a number greater than 1");
    row("slack", {"coarsen", "a.mesh", "-o", "b", "--slack", "0.5"}, "--slack: 0.5 is not");
    row("threads", {"info", "a.mesh", "--threads", "-1"}, "--threads: -1 is not");
    row("mean", {"metric", "a.mesh", "-o", "b.solb", "--mean", "log-euclid"},
        "did you mean log-euclidean?");
    row("case", {"case", "bxo", "-o", "a.mesh"}, "unknown case bxo, did you mean box?");
    row("no case", {"case"}, "which case?");
    row("parameter", {"case", "cube", "-o", "a.mesh", "--sed", "1"}, "did you mean --seed?");
    row("parameter's value", {"case", "cube", "-o", "a.mesh", "--n", "0"}, "n");
    row("suffix", {"case", "cube", "-o", "a.stl"}, "a.stl: its name must end in .meshb or .mesh");
}

void HelpTest::explains_wrong_usage_in_one_line() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, complaint);
    const Run run = Workspace().ameco(arguments);
    QCOMPARE(run.code, 2);
    QCOMPARE(run.out, QString());
    QVERIFY2(run.err.startsWith("ameco: ") && run.err.count('\n') == 1, run.text());
    QVERIFY2(run.err.contains(complaint), run.text());
}

void HelpTest::takes_common_options_before_and_after_the_command() {
    const Workspace here;
    QCOMPARE(here.ameco({"case", "cube", "--n", "1", "-o", "a.meshb"}).code, 0);
    const Run before = here.ameco({"--json", "info", "a.meshb"});
    const Run after = here.ameco({"info", "a.meshb", "--json"});
    QCOMPARE(before.code, 0);
    QCOMPARE(before.out, after.out);
    QVERIFY(before.json().is_array());
}

void HelpTest::uses_no_colour_outside_a_terminal() {
    const Run run = Workspace().ameco({"info", "absent.mesh"});
    QVERIFY2(!run.err.contains('\033'), run.text());
}

void HelpTest::is_the_same_in_the_manual() {
    const Workspace here;
    QString manual = "# The command line\n\n"
                     "This page is written by `tests/acceptance/help_test.cpp` from the program's "
                     "own help.\n\n" +
                     QString(conduct) + "\n## Exit codes\n\n| code | meaning |\n|---|---|\n";
    for (const auto& [code, meaning] : exit_codes) {
        manual += QString("| %1 | %2 |\n").arg(code).arg(meaning);
    }
    manual += "\n## ameco\n\n```\n" + here.ameco({}).out + "```\n";
    for (const QString& command : commands) {
        manual += "\n## ameco " + command + "\n\n```\n" + here.ameco({command, "-h"}).out + "```\n";
    }
    compare_or_update("docs/user/cli.md", manual);
}

void HelpTest::is_the_same_in_the_man_page() {
    const Workspace here;
    QString page = ".\\\" Written by tests/acceptance/help_test.cpp from the program's own help.\n"
                   ".TH AMECO 1 \"\" \"ameco\" \"User Commands\"\n"
                   ".SH NAME\nameco \\- make mesh hierarchies for geometric multigrid\n"
                   ".SH SYNOPSIS\n.B ameco\n.I COMMAND\n[arguments] [options]\n"
                   ".SH DESCRIPTION\n.nf\n" +
                   roff(here.ameco({}).out) + ".fi\n.PP\n" + roff(QString(conduct).remove('`')) +
                   ".SH COMMANDS\n";
    for (const QString& command : commands) {
        page +=
            ".SS ameco " + command + "\n.nf\n" + roff(here.ameco({command, "-h"}).out) + ".fi\n";
    }
    page += ".SH EXIT STATUS\n";
    for (const auto& [code, meaning] : exit_codes) {
        page += QString(".TP\n.B %1\n%2\n").arg(code).arg(roff(QString(meaning).remove('`')));
    }
    compare_or_update("docs/man/ameco.1", page);
}

QTEST_GUILESS_MAIN(HelpTest)
#include "help_test.moc"
