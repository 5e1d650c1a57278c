// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/svg.h"

#include <QTest>

using namespace ameco;

class SvgTest : public QObject {
    Q_OBJECT
private slots:
    void numbers_have_a_point_and_the_decimals_asked_for();
    void numbers_of_an_axis_have_no_exponent_up_to_a_thousand_million_data();
    void numbers_of_an_axis_have_no_exponent_up_to_a_thousand_million();
    void text_may_hold_what_xml_reserves();
};

void SvgTest::numbers_have_a_point_and_the_decimals_asked_for() {
    QCOMPARE(svg::number(1.0 / 3), std::string("0.33"));
    QCOMPARE(svg::number(-12.06, 1), std::string("-12.1"));
    QCOMPARE(svg::short_number(123456), std::string("1.23e+05"));
}

void SvgTest::numbers_of_an_axis_have_no_exponent_up_to_a_thousand_million_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("small") << 1.37 << "1.37";
    QTest::newRow("below a thousand") << 999.4 << "999";
    QTest::newRow("rounds up to a thousand") << 999.6 << "1k";
    QTest::newRow("thousands") << 5491.0 << "5.49k";
    QTest::newRow("hundreds of thousands") << 351234.0 << "351k";
    QTest::newRow("rounds up to a million") << 999600.0 << "1M";
    QTest::newRow("millions") << 2008320.0 << "2.01M";
}

void SvgTest::numbers_of_an_axis_have_no_exponent_up_to_a_thousand_million() {
    QFETCH(double, value);
    QFETCH(QString, text);
    QCOMPARE(QString::fromStdString(svg::axis_number(value)), text);
}

void SvgTest::text_may_hold_what_xml_reserves() {
    const std::string text = svg::text_at(1, 2, "AR < 5 & h > 0", "end");
    QVERIFY(text.find("AR &lt; 5 &amp; h &gt; 0") != std::string::npos);
    QVERIFY(text.find("text-anchor=\"end\"") != std::string::npos);
}

QTEST_APPLESS_MAIN(SvgTest)
#include "svg_test.moc"
