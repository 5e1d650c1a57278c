// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/report/report_page.h"

#include "core/base/text.h"
#include "core/report/report_tables.h"
#include "tests/core/hierarchy/hierarchy_support.h"

#include <QRegularExpression>
#include <QTest>

using namespace ameco;
using namespace ameco::test;

class ReportPageTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void tables_have_a_row_per_level();
    void classes_count_every_node();
    void the_page_shows_what_was_measured();
    void the_page_needs_nothing_else();
    void parts_that_were_not_measured_are_left_out();

private:
    ReportContent content_;
    std::vector<Mesh<3>> meshes_;
};

void ReportPageTest::initTestCase() {
    Collected<3> made;
    HierarchyOptions options;
    options.levels = 2;
    (void)build_hierarchy<3>(small_mesh<3>(), options, made.sink());
    content_.folder = "levels";
    Hierarchy& h = content_.hierarchy;
    h.program = "ameco test";
    h.options = options;
    h.status = HierarchyStatus::complete;
    h.input.file.name = "../<cube>.meshb";
    for (const LevelStatistics& s : made.statistics) {
        h.levels.push_back({});
        h.levels.back().statistics = s;
    }
    content_.timings = made.timings;
    QCOMPARE(h.levels.size(), std::size_t{3});
}

void ReportPageTest::tables_have_a_row_per_level() {
    const Hierarchy& h = content_.hierarchy;
    for (const html::Table& table :
         {levels_table(h), conformity_table(h), geometry_table(h), times_table(content_.timings)}) {
        QCOMPARE(table.rows.size(), h.levels.size());
        for (const auto& row : table.rows) {
            QCOMPARE(row.size(), table.columns.size());
        }
    }
    const html::Table removals = removals_table(h);
    QCOMPARE(removals.columns.size(), h.levels.size());
    QCOMPARE(removals.rows[0][0], std::string("accepted"));
}

void ReportPageTest::classes_count_every_node() {
    const Hierarchy& h = content_.hierarchy;
    const html::Table table = classes_table(h);
    for (std::size_t k = 0; k < h.levels.size(); ++k) {
        std::int64_t nodes = 0;
        for (const auto& row : table.rows) {
            nodes += QString::fromStdString(row[2 + 2 * k]).remove(',').toLongLong();
        }
        QCOMPARE(nodes, h.levels[k].statistics.nodes);
    }
}

void ReportPageTest::the_page_shows_what_was_measured() {
    ReportContent content = content_;
    content.cycles.push_back({"V(2,2), a cycle", 1.5, {}});
    content.cycles.back().study.krylov.iterations = 4711;
    content.cycles.back().study.krylov.residuals = {1, 1e-9};
    const QString page = QString::fromStdString(report_page(content));
    for (const HierarchyLevel& level : content.hierarchy.levels) {
        QVERIFY(page.contains(">" + QString::fromStdString(count_text(level.statistics.nodes)) +
                              "</td>"));
    }
    QVERIFY(page.contains("&lt;cube&gt;.meshb") && !page.contains("<cube>"));
    QVERIFY(page.contains("4711") && page.contains("V(2,2), a cycle"));
    QVERIFY(page.contains("ameco coarsen"));
}

void ReportPageTest::the_page_needs_nothing_else() {
    QString page = QString::fromStdString(report_page(content_));
    page.remove("http://www.w3.org/2000/svg"); // the name of a language, never fetched
    QVERIFY(!page.contains("http"));
    QVERIFY(!page.contains("<script") && !page.contains("<link rel=\"stylesheet\"") &&
            !page.contains("url(") && !page.contains("@import"));
    // Every link leads to a place in the page.
    const QRegularExpression link("href=\"#([a-z-]+)\"");
    int links = 0;
    for (auto it = link.globalMatch(page); it.hasNext(); ++links) {
        QVERIFY(page.contains("id=\"" + it.next().captured(1) + "\""));
    }
    QVERIFY(links >= 6);
}

void ReportPageTest::parts_that_were_not_measured_are_left_out() {
    ReportContent bare = content_;
    bare.timings.clear();
    const QString page = QString::fromStdString(report_page(bare));
    QVERIFY(!page.contains("id=\"times\"") && !page.contains("id=\"multigrid\"") &&
            !page.contains("id=\"layers\""));
    QCOMPARE(report_page(bare), report_page(bare));
}

QTEST_GUILESS_MAIN(ReportPageTest)
#include "report_page_test.moc"
