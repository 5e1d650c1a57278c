// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/panels/chart_panel.h"

#include "tests/support/picture.h"

#include <QCheckBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

using namespace ameco;
using namespace ameco::gui;

namespace {

const QColor blue(31, 78, 121);
const QColor orange(217, 95, 2);

/// Two series in four classes; the second has half the numbers of the first.
Chart two_levels() {
    Chart chart;
    chart.x_title = "aspect ratio";
    chart.y_title = "nodes";
    chart.edges = {"1", "2", "4", "8", "16"};
    chart.series = {{"level 0", blue, {100, 40, 40, 20}, false},
                    {"level 1", orange, {50, 20, 20, 10}, false}};
    return chart;
}

/// Pixels of a colour.
qint64 count(const QImage& image, const QColor& colour) {
    return qRound64(test::share_of_pixels(
                        image, [&](const QColor& c) { return test::near_colour(c, colour, 8); }) *
                    image.width() * image.height());
}

QByteArray content(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class ChartTest : public QObject {
    Q_OBJECT
private slots:
    void bars_are_as_high_as_the_numbers();
    void per_cent_makes_levels_comparable();
    void a_logarithmic_axis_shows_small_classes();
    void hovering_tells_counts_and_shares();
    void a_click_selects_a_class_and_a_drag_several();
    void classes_are_selected_with_the_keyboard();
    void writes_pictures_and_tables();
    void bars_of_next_to_nothing_stay_above_the_axis();
    void says_why_a_file_cannot_be_written();
};

void ChartTest::bars_are_as_high_as_the_numbers() {
    ChartWidget widget;
    widget.resize(600, 300);
    widget.setChart(two_levels());
    const QImage image = widget.grab().toImage();
    const double all_blue = static_cast<double>(count(image, blue));
    QVERIFY(all_blue > 1000);
    // Twice the number, twice the area; the keys of the legend add a little to both.
    const double quotient = all_blue / static_cast<double>(count(image, orange));
    QVERIFY2(quotient > 1.8 && quotient < 2.2, qPrintable(QString::number(quotient)));
}

void ChartTest::per_cent_makes_levels_comparable() {
    ChartWidget widget;
    widget.resize(600, 300);
    widget.setChart(two_levels());
    widget.setPercent(true);
    const QImage image = widget.grab().toImage();
    const double quotient =
        static_cast<double>(count(image, blue)) / static_cast<double>(count(image, orange));
    QVERIFY2(quotient > 0.9 && quotient < 1.1, qPrintable(QString::number(quotient)));
}

void ChartTest::a_logarithmic_axis_shows_small_classes() {
    Chart chart = two_levels();
    chart.series[0].values = {100000, 0, 0, 2};
    chart.series.pop_back();
    ChartWidget widget;
    widget.resize(600, 300);
    widget.setChart(chart);
    const auto last = [&] {
        return count(widget.grab(widget.classBox(3).toAlignedRect()).toImage(), blue);
    };
    QCOMPARE(last(), 0);
    widget.setLogarithmic(true);
    QVERIFY(last() > 100);
}

void ChartTest::hovering_tells_counts_and_shares() {
    ChartWidget widget;
    widget.resize(600, 300);
    widget.setChart(two_levels());
    const QString text = widget.hoverText(widget.classBox(1).center());
    QVERIFY2(text.contains("2 to 4") && text.contains("level 1") && text.contains("20.00 %"),
             qPrintable(text));
    QVERIFY(widget.hoverText({1, 1}).isEmpty());
}

void ChartTest::a_click_selects_a_class_and_a_drag_several() {
    ChartWidget widget;
    widget.resize(600, 300);
    widget.setChart(two_levels());
    widget.show();
    std::set<int> selected;
    connect(&widget, &ChartWidget::selectionChanged, this,
            [&](const std::set<int>& classes) { selected = classes; });
    const auto place = [&](int k) { return widget.classBox(k).center().toPoint(); };
    QTest::mouseClick(&widget, Qt::LeftButton, {}, place(2));
    QCOMPARE(selected, std::set<int>{2});
    QTest::mousePress(&widget, Qt::LeftButton, {}, place(0));
    QTest::mouseMove(&widget, place(1));
    QTest::mouseRelease(&widget, Qt::LeftButton, {}, place(1));
    QCOMPARE(selected, (std::set<int>{0, 1}));
    QTest::mouseClick(&widget, Qt::LeftButton, Qt::ControlModifier, place(3));
    QCOMPARE(selected, (std::set<int>{0, 1, 3}));
    QTest::keyClick(&widget, Qt::Key_Escape);
    QCOMPARE(selected, std::set<int>{});
}

void ChartTest::classes_are_selected_with_the_keyboard() {
    ChartWidget widget;
    widget.setChart(two_levels());
    QTest::keyClick(&widget, Qt::Key_Right);
    QTest::keyClick(&widget, Qt::Key_Right);
    QTest::keyClick(&widget, Qt::Key_Space);
    QCOMPARE(widget.chart().selected, std::set<int>{1});
}

void ChartTest::writes_pictures_and_tables() {
    const QTemporaryDir folder;
    ChartPanel panel("test");
    panel.resize(600, 300);
    panel.setChart(two_levels());
    QSignalSpy exported(&panel, &ChartPanel::exported);
    for (const char* name : {"a.png", "a.svg", "a.csv"}) {
        panel.exportTo(folder.filePath(name));
    }
    QCOMPARE(exported.count(), 3);

    const QImage image(folder.filePath("a.png"));
    QVERIFY(image.width() >= 1200);
    QVERIFY(count(image, blue) > 2000);

    const QByteArray svg = content(folder.filePath("a.svg"));
    QXmlStreamReader xml(svg);
    int rectangles = 0;
    while (!xml.atEnd()) {
        rectangles += xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"rect" &&
                              xml.attributes().value("fill") == u"#1f4e79"
                          ? 1
                          : 0;
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(rectangles, 5); // four bars and the legend's key
    QVERIFY(svg.contains(">aspect ratio</text>"));

    QCOMPARE(content(folder.filePath("a.csv")),
             QByteArray("from,to,\"level 0\",\"level 1\"\n\"1\",\"2\",100,50\n\"2\",\"4\",40,20\n"
                        "\"4\",\"8\",40,20\n\"8\",\"16\",20,10\n"));
}

void ChartTest::bars_of_next_to_nothing_stay_above_the_axis() {
    const QTemporaryDir folder;
    ChartPanel panel("test");
    panel.resize(600, 300);
    Chart chart = two_levels();
    chart.series[1].values = {1, 1, 1, 1e6};
    chart.series[1].hollow = true;
    panel.setChart(chart);
    panel.exportTo(folder.filePath("a.svg"));
    QXmlStreamReader xml(content(folder.filePath("a.svg")));
    int outlines = 0;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"rect") {
            QVERIFY(!xml.attributes().value("height").startsWith(u'-'));
            outlines += xml.attributes().value("stroke") == u"#d95f02" ? 1 : 0;
        }
    }
    QVERIFY(outlines >= 4);
}

void ChartTest::says_why_a_file_cannot_be_written() {
    ChartPanel panel("test");
    panel.setChart(two_levels());
    QSignalSpy failed(&panel, &ChartPanel::failed);
    panel.exportTo("/nowhere/a.png");
    panel.exportTo("a.doc");
    QCOMPARE(failed.count(), 2);
    QVERIFY(failed[0][0].toString().contains("/nowhere"));
    QVERIFY(failed[1][0].toString().contains(".svg"));
}

QTEST_MAIN(ChartTest)
#include "chart_test.moc"
