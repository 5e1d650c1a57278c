// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/report/html.h"

#include <QTest>
#include <QXmlStreamReader>

using namespace ameco;

class HtmlTest : public QObject {
    Q_OBJECT
private slots:
    void reserved_characters_stay_text();
    void tables_have_a_cell_per_column();
    void values_for_programs_are_plain_numbers_data();
    void values_for_programs_are_plain_numbers();
};

namespace {

/// The text of all elements of a name, in order; empty when the text is not well formed.
QStringList texts_of(const std::string& html, const QString& element) {
    QXmlStreamReader xml(QString::fromStdString("<page>" + html + "</page>"));
    QStringList texts;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == element) {
            texts << xml.readElementText(QXmlStreamReader::IncludeChildElements);
        }
    }
    return xml.hasError() ? QStringList() : texts;
}

} // namespace

void HtmlTest::reserved_characters_stay_text() {
    const std::string nasty = "<script>\"a\" & 'b'</script>";
    const html::Table table{{{nasty, true, nasty}}, {{nasty}}};
    QCOMPARE(texts_of(html::text_of(table), "td"), QStringList(QString::fromStdString(nasty)));
    QCOMPARE(texts_of(html::text_of(table), "th"), QStringList(QString::fromStdString(nasty)));
    QVERIFY(texts_of(html::page(nasty, html::section("a", nasty, html::facts({{nasty, nasty}}))),
                     "script")
                .isEmpty());
}

void HtmlTest::tables_have_a_cell_per_column() {
    const html::Table table{{{"level"}, {"name", true}}, {{"0", "fine"}, {"1", "coarse"}}};
    QCOMPARE(texts_of(html::text_of(table), "td"), (QStringList{"0", "fine", "1", "coarse"}));
    QCOMPARE(html::csv_of(table), std::string("level,name\r\n0,fine\r\n1,coarse\r\n"));
}

void HtmlTest::values_for_programs_are_plain_numbers_data() {
    QTest::addColumn<QString>("cell");
    QTest::addColumn<QString>("value");
    QTest::newRow("grouped digits") << "67,455"
                                    << "67455";
    QTest::newRow("per cent") << "12.3 %"
                              << "12.3";
    QTest::newRow("small") << "1.2e-09"
                           << "1.2e-09";
    QTest::newRow("text with a comma") << "inlet, left"
                                       << "\"inlet, left\"";
    QTest::newRow("text with quotes") << "the \"wing\", tip"
                                      << "\"the \"\"wing\"\", tip\"";
    QTest::newRow("text with blanks") << "1 to 2"
                                      << "1 to 2";
}

void HtmlTest::values_for_programs_are_plain_numbers() {
    QFETCH(QString, cell);
    QFETCH(QString, value);
    const std::string csv = html::csv_of({{{"x"}}, {{cell.toStdString()}}});
    QCOMPARE(QString::fromStdString(csv), "x\r\n" + value + "\r\n");
}

QTEST_GUILESS_MAIN(HtmlTest)
#include "html_test.moc"
