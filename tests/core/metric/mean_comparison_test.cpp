// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Figures 2 and 3 of the paper: the central node of its model layer.
#include "core/metric/mean_comparison.h"

#include "core/cases/layer.h"
#include "core/cases/model_layer.h"

#include <QTest>
#include <QXmlStreamReader>

using namespace ameco;

namespace {

constexpr NodeId centre(12);

MeanComparison<2> compare(double angle_deg, double stretching) {
    ModelLayerOptions options;
    options.angle_deg = angle_deg;
    options.stretching = stretching;
    return compare_means(make_model_layer(options), centre);
}

template <int D>
const ComparedMean<D>& row(const MeanComparison<D>& comparison, Mean mean) {
    for (const ComparedMean<D>& r : comparison.means) {
        if (r.mean == mean) {
            return r;
        }
    }
    throw std::logic_error("no such mean");
}

int count_paths(const std::string& svg) {
    QXmlStreamReader xml(QByteArray::fromStdString(svg));
    int count = 0;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QString("path")) {
            ++count;
        }
    }
    return xml.hasError() ? -1 : count;
}

} // namespace

class MeanComparisonTest : public QObject {
    Q_OBJECT
private slots:
    void all_means_agree_on_a_plane_layer_data();
    void all_means_agree_on_a_plane_layer();
    void means_differ_on_a_turned_layer_as_in_figure_3_data();
    void means_differ_on_a_turned_layer_as_in_figure_3();
    void draws_one_line_per_different_mean();
    void works_at_any_node_in_3d();
};

void MeanComparisonTest::all_means_agree_on_a_plane_layer_data() {
    QTest::addColumn<double>("stretching");
    QTest::addRow("stretching 100") << 100.0;
    QTest::addRow("stretching 1000") << 1000.0;
}

void MeanComparisonTest::all_means_agree_on_a_plane_layer() {
    QFETCH(const double, stretching);
    const MeanComparison<2> comparison = compare(0, stretching);
    QCOMPARE(comparison.elements.size(), 6U);
    QCOMPARE(comparison.means.size(), all_means.size());
    for (const ComparedMean<2>& r : comparison.means) {
        QVERIFY(r.failure.empty());
        QCOMPARE_LE(r.distance, 0.01);
        QCOMPARE_LE(std::abs(r.metric.sizes[0] * stretching - 1), 1e-3);
    }
}

void MeanComparisonTest::means_differ_on_a_turned_layer_as_in_figure_3_data() {
    all_means_agree_on_a_plane_layer_data();
}

void MeanComparisonTest::means_differ_on_a_turned_layer_as_in_figure_3() {
    QFETCH(const double, stretching);
    const MeanComparison<2> comparison = compare(20, stretching);
    const auto height = [&](Mean mean) {
        return row(comparison, mean).metric.sizes[0] * stretching;
    };
    QCOMPARE_LE(std::abs(height(Mean::corrected) - 1), 0.01);
    QCOMPARE_GT(height(Mean::log_euclidean), 1.1); // less stretched, as the paper says
    QCOMPARE_LT(height(Mean::log_euclidean), 1.3);
    QCOMPARE_GT(height(Mean::geodesic), 4.0);
    QCOMPARE_GT(height(Mean::interpolation), 4.0);
    QCOMPARE(row(comparison, Mean::geodesic_fixed_step).failure, std::string("does not converge"));
}

void MeanComparisonTest::draws_one_line_per_different_mean() {
    QCOMPARE(count_paths(unit_balls_svg(compare(0, 100))), 1);
    QCOMPARE(count_paths(unit_balls_svg(compare(20, 100))), 4); // corrected and blended are one
}

void MeanComparisonTest::works_at_any_node_in_3d() {
    LayerOptions layer;
    layer.nx = layer.ny = 4;
    layer.aspect_ratio = 1e4;
    const Mesh<3> mesh = make_layer<3>(layer);
    for (const NodeId node : {NodeId(0), NodeId(30), NodeId(mesh.points.size() - 1)}) {
        const MeanComparison<3> comparison = compare_means(mesh, node);
        QCOMPARE_GT(comparison.elements.size(), 0U);
        for (const ComparedMean<3>& r : comparison.means) {
            QVERIFY(!r.failure.empty() || is_valid(r.metric));
        }
        QCOMPARE_GE(count_paths(unit_balls_svg(comparison)), 1);
    }
}

QTEST_APPLESS_MAIN(MeanComparisonTest)
#include "mean_comparison_test.moc"
