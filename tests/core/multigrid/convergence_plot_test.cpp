// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/convergence_plot.h"

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

using namespace ameco;

namespace {

/// Points of each curve, in the order of the file; empty if it is no XML.
std::vector<std::vector<QPointF>> curves_of(const std::string& svg) {
    std::vector<std::vector<QPointF>> curves;
    QXmlStreamReader xml(QString::fromStdString(svg));
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement || xml.name() != u"polyline") {
            continue;
        }
        curves.emplace_back();
        const QString points = xml.attributes().value("points").toString();
        for (const QString& point : points.split(' ', Qt::SkipEmptyParts)) {
            const QStringList xy = point.split(',');
            curves.back().emplace_back(xy[0].toDouble(), xy[1].toDouble());
        }
    }
    return xml.hasError() ? std::vector<std::vector<QPointF>>() : curves;
}

} // namespace

class ConvergencePlotTest : public QObject {
    Q_OBJECT
private slots:
    void a_constant_factor_is_a_straight_line();
    void all_curves_have_the_same_axes();
    void titles_and_numbers_do_no_harm();
};

void ConvergencePlotTest::a_constant_factor_is_a_straight_line() {
    const auto curves = curves_of(convergence_plot({{"tenths", {1, 1e-1, 1e-2, 1e-3, 1e-4}}}));
    QCOMPARE(curves.size(), std::size_t{1});
    QCOMPARE(curves[0].size(), std::size_t{5});
    const QPointF step = curves[0][1] - curves[0][0];
    QVERIFY(step.x() > 0 && step.y() > 0); // downwards
    for (std::size_t i = 1; i < curves[0].size(); ++i) {
        const QPointF difference = curves[0][i] - curves[0][i - 1] - step;
        QVERIFY(std::abs(difference.x()) < 0.03 && std::abs(difference.y()) < 0.03);
    }
}

void ConvergencePlotTest::all_curves_have_the_same_axes() {
    const auto curves = curves_of(convergence_plot({{"a", {1, 1e-2}}, {"b", {1, 1e-2, 1e-5}}}));
    QCOMPARE(curves.size(), std::size_t{2});
    QCOMPARE(curves[0][1], curves[1][1]);
}

void ConvergencePlotTest::titles_and_numbers_do_no_harm() {
    QCOMPARE(curves_of(convergence_plot({})).size(), std::size_t{0});
    // Exact convergence, and divergence above 1, stay in the picture.
    const auto curves = curves_of(convergence_plot({{"levels <1> & \"2\"", {1, 3, 0}}}));
    QCOMPARE(curves.size(), std::size_t{1});
    for (const QPointF& p : curves[0]) {
        QVERIFY(p.x() >= 0 && p.x() <= 640 && p.y() >= 0 && p.y() <= 420);
    }
}

QTEST_APPLESS_MAIN(ConvergencePlotTest)
#include "convergence_plot_test.moc"
