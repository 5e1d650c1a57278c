// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/svg.h"

#include <QTest>

using namespace ameco;

class SvgTest : public QObject {
    Q_OBJECT
private slots:
    void numbers_have_a_point_and_the_decimals_asked_for();
    void text_may_hold_what_xml_reserves();
};

void SvgTest::numbers_have_a_point_and_the_decimals_asked_for() {
    QCOMPARE(svg::number(1.0 / 3), std::string("0.33"));
    QCOMPARE(svg::number(-12.06, 1), std::string("-12.1"));
    QCOMPARE(svg::short_number(123456), std::string("1.23e+05"));
}

void SvgTest::text_may_hold_what_xml_reserves() {
    const std::string text = svg::text_at(1, 2, "AR < 5 & h > 0", "end");
    QVERIFY(text.find("AR &lt; 5 &amp; h &gt; 0") != std::string::npos);
    QVERIFY(text.find("text-anchor=\"end\"") != std::string::npos);
}

QTEST_APPLESS_MAIN(SvgTest)
#include "svg_test.moc"
