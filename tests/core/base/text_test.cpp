// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/text.h"

#include <limits>

#include <QtTest>

using namespace ameco;

class TextTest : public QObject {
    Q_OBJECT
private slots:
    void writes_numbers_as_people_do_data();
    void writes_numbers_as_people_do();
    void writes_counts_bytes_and_shares();
    void leaves_no_character_that_xml_reserves();
};

void TextTest::writes_numbers_as_people_do_data() {
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

void TextTest::writes_numbers_as_people_do() {
    QFETCH(double, value);
    QFETCH(QString, text);
    QCOMPARE(QString::fromStdString(number_text(value)), text);
}

void TextTest::writes_counts_bytes_and_shares() {
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

void TextTest::leaves_no_character_that_xml_reserves() {
    QCOMPARE(xml_escaped("a < b & \"c\" > d, fl\xc3\xbcgel"),
             std::string("a &lt; b &amp; &quot;c&quot; &gt; d, fl\xc3\xbcgel"));
    QCOMPARE(xml_escaped(""), std::string());
}

QTEST_APPLESS_MAIN(TextTest)
#include "text_test.moc"
