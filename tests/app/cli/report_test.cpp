// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/report.h"

#include <cmath>
#include <limits>
#include <sstream>

#include <QtTest>

using namespace ameco;
using namespace ameco::cli;

class ReportTest : public QObject {
    Q_OBJECT
private slots:
    void writes_numbers_as_people_do_data();
    void writes_numbers_as_people_do();
    void writes_counts_bytes_and_shares();
    void aligns_columns_whatever_their_width();
    void shows_every_node_in_a_class();
    void draws_the_largest_share_of_all_levels_longest();
};

void ReportTest::writes_numbers_as_people_do_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("zero") << 0.0 << "0";
    QTest::newRow("whole") << 5.0 << "5";
    QTest::newRow("four digits") << 2.19244 << "2.192";
    QTest::newRow("thousands") << 532713.0 << "532,713";
    QTest::newRow("negative thousands") << -1234.5678 << "-1,235";
    QTest::newRow("small") << 0.00123456 << "0.001235";
    QTest::newRow("tiny") << 1.2346e-9 << "1.235e-09";
    QTest::newRow("huge") << 1.5e12 << "1.500e+12";
    QTest::newRow("nan") << std::numeric_limits<double>::quiet_NaN() << "nan";
    QTest::newRow("infinite") << -std::numeric_limits<double>::infinity() << "-inf";
}

void ReportTest::writes_numbers_as_people_do() {
    QFETCH(double, value);
    QFETCH(QString, text);
    QCOMPARE(QString::fromStdString(number_text(value)), text);
}

void ReportTest::writes_counts_bytes_and_shares() {
    QCOMPARE(count_text(0), std::string("0"));
    QCOMPARE(count_text(999), std::string("999"));
    QCOMPARE(count_text(1000), std::string("1,000"));
    QCOMPARE(count_text(-2008320), std::string("-2,008,320"));
    QCOMPARE(plural(1, "node"), std::string("1 node"));
    QCOMPARE(plural(2000, "node"), std::string("2,000 nodes"));
    QCOMPARE(percent_text(0.12345), std::string("12.3 %"));
    QCOMPARE(ratio_text(2.196), std::string("2.20"));
    QCOMPARE(bytes_text(999), std::string("999 B"));
    QCOMPARE(bytes_text(1.26e9), std::string("1.3 GB"));
    QCOMPARE(bytes_text(106e6), std::string("106 MB"));
}

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
