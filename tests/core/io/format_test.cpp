// SPDX-License-Identifier: AGPL-3.0-or-later
// The table of formats as a table, and in the manual.
#include "core/io/format.h"
#include "tests/core/io/io_support.h"

#include <set>

using namespace ameco;
using namespace ameco::test;

class FormatTest : public QObject {
    Q_OBJECT
private slots:
    void has_a_name_of_its_own_for_each_format();
    void finds_the_longest_suffix_data();
    void finds_the_longest_suffix();
    void is_the_same_in_the_manual();
};

namespace {

const char* yes(bool value) {
    return value ? "yes" : "";
}

/// Meshes, or metrics.
std::string markdown_table(bool metrics) {
    std::string text = "| format | name | suffixes | read | write |";
    std::string rule = "|---|---|---|---|---|";
    for (const KeepsColumn& column : keeps_columns) {
        if (!metrics || column.what == keeps_2d || column.what == keeps_3d) {
            text += " " + std::string(column.heading) + " |";
            rule += "---|";
        }
    }
    text += " remarks |\n" + rule + "---|\n";
    for (const Format& format : formats()) {
        if (format.is_metric() != metrics) {
            continue;
        }
        text += "| " + std::string(format.title) + " | `" + std::string(format.name) + "` |";
        for (const std::string_view suffix : format.suffixes) {
            text += " `" + std::string(suffix) + "`";
        }
        text += std::string(" | ") + yes(format.reads()) + " | " + yes(format.writes()) + " |";
        for (const KeepsColumn& column : keeps_columns) {
            if (!metrics || column.what == keeps_2d || column.what == keeps_3d) {
                text += (format.keeps & column.what) != 0 ? " x |" : " |";
            }
        }
        text += " " + std::string(format.remark) + " |\n";
    }
    return text;
}

} // namespace

void FormatTest::has_a_name_of_its_own_for_each_format() {
    std::set<std::string_view> names;
    for (const Format& format : formats()) {
        QVERIFY(names.insert(format.name).second);
        QVERIFY(!format.suffixes.empty());
        QCOMPARE(format_of_name(format.name), &format);
    }
    QVERIFY(format_of_name("step") == nullptr);
}

void FormatTest::finds_the_longest_suffix_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<bool>("metric");
    QTest::addColumn<QString>("format");
    const auto row = [](const char* path, bool metric, const char* format) {
        QTest::newRow(path) << path << metric << format;
    };
    row("a.mesh", false, "medit-text");
    row("A.MESHB", false, "medit");
    row("a.mesh.gz", false, "medit-text");
    row("a.lb8.ugrid", false, "ugrid");
    row("a.msh", false, "gmsh");
    row("M6.mtc", false, "mtc");
    row("M6.mtc", true, "mtc-meta-metric");
    row("M6__metrique", true, "mtc-metric");
    row(".mesh", false, "");
    row("a.sol", false, "");
    row("a.txt", false, "");
}

void FormatTest::finds_the_longest_suffix() {
    QFETCH(QString, path);
    QFETCH(bool, metric);
    QFETCH(QString, format);
    const Format* found = format_of_suffix(path.toStdString(), metric);
    QCOMPARE(found == nullptr ? std::string() : std::string(found->name), format.toStdString());
}

void FormatTest::is_the_same_in_the_manual() {
    for (const Format& format : formats()) {
        if (!format.reads()) {
            QSKIP(("this build leaves out " + std::string(format.title)).c_str());
        }
    }
    const std::filesystem::path path =
        std::filesystem::path(AMECO_SOURCE_DIR) / "docs/user/formats.md";
    const std::string manual = content_of(path);
    const std::string begin = "<!-- begin -->\n";
    const std::string end = "<!-- end -->";
    const std::size_t from = manual.find(begin) + begin.size();
    const std::size_t to = manual.find(end);
    QVERIFY(from < manual.size() && to != std::string::npos);
    const std::string expected = manual.substr(0, from) + "\n" + markdown_table(false) +
                                 "\nMetrics:\n\n" + markdown_table(true) + "\n" + manual.substr(to);
    if (qEnvironmentVariableIsSet("AMECO_UPDATE_DOCS")) {
        std::ofstream(path, std::ios::binary) << expected;
        return;
    }
    QVERIFY2(manual == expected,
             "docs/user/formats.md is out of date: run this test with AMECO_UPDATE_DOCS=1");
}

QTEST_APPLESS_MAIN(FormatTest)
#include "format_test.moc"
