// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/report.h"

#include <sstream>

#include <QtTest>

using namespace ameco;
using namespace ameco::cli;

class ReportTest : public QObject {
    Q_OBJECT
private slots:
    void aligns_columns_whatever_their_width();
    void shows_every_node_in_a_class();
    void draws_the_largest_share_of_all_levels_longest();
};

void ReportTest::aligns_columns_whatever_their_width() {
    Table table({{"n"}, {"name", Table::Align::left}, {"x"}});
    table.add_row({"1", "a", "2.5"});
    table.add_row({"1,000", "flügel", ""});
    std::ostringstream out;
    table.print(out);
    QCOMPARE(QString::fromStdString(out.str()), QString("    n  name      x\n"
                                                        "    1  a       2.5\n"
                                                        "1,000  flügel\n"));
}

void ReportTest::shows_every_node_in_a_class() {
    AspectRatioClasses classes;
    classes.max = 12;
    classes.counts = {10, 0, 30, 60};
    std::ostringstream out;
    print_aspect_ratio_classes(out, classes);
    const QString text = QString::fromStdString(out.str());
    QCOMPARE(text.count('\n'), 5); // a heading and four classes
    QVERIFY2(text.contains("6 - 12     10  10.0 %  #####\n"), qPrintable(text));
    QVERIFY2(text.contains("1 - 1.5     60  60.0 %  ##############################\n"),
             qPrintable(text));
}

void ReportTest::draws_the_largest_share_of_all_levels_longest() {
    AspectRatioClasses fine;
    fine.max = 4;
    fine.counts = {90, 10};
    AspectRatioClasses coarse = fine;
    coarse.counts = {0, 10};
    std::ostringstream out;
    print_aspect_ratio_histogram(out, {fine, coarse});
    const QStringList lines = QString::fromStdString(out.str()).split('\n');
    QCOMPARE(lines.at(1).count('#'), 8);     // 90 % of the fine level's nodes
    QCOMPARE(lines.at(2).count('#'), 1 + 9); // 10 % of the fine, all of the coarse level's
}

QTEST_APPLESS_MAIN(ReportTest)
#include "report_test.moc"
