// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/prediction.h"

#include "core/cases/layer.h"
#include "core/coarsen/target_ratio.h"

#include <QtTest>

#include <numeric>

using namespace ameco;

namespace {

Level<3> layer() {
    LayerOptions options;
    options.nx = 8;
    options.ny = 8;
    options.nz = 24;
    options.aspect_ratio = 50;
    options.growth = 1.2;
    return finest_level(make_layer<3>(options), {});
}

} // namespace

class PredictionTest : public QObject {
    Q_OBJECT
private slots:
    void is_what_coarsening_reports();
    void classes_add_up_to_the_nodes();
    void largest_class_empties_when_layers_are_coarsened();
    void asks_for_the_ratio_that_is_wanted();
};

void PredictionTest::is_what_coarsening_reports() {
    const Level<3> fine = layer();
    const CoarsenOptions options;
    CoarsenReport report;
    (void)coarsen(fine, options, report);
    const Prediction p = predict(fine.mesh, fine.natural, options.target, 0, 100);
    QCOMPARE(p.nodes, report.predicted_nodes);
    QCOMPARE(p.factor, options.target.factor);
}

void PredictionTest::classes_add_up_to_the_nodes() {
    const Level<3> fine = layer();
    const double max = summarise_aspect_ratios(fine.natural).max;
    const Prediction p = predict(fine.mesh, fine.natural, {}, 0, max);
    const auto sum = std::accumulate(p.classes.counts.begin(), p.classes.counts.end(), 0LL);
    QVERIFY(std::abs(static_cast<double>(sum) - p.nodes) <=
            static_cast<double>(p.classes.counts.size()));
    QCOMPARE(p.classes.counts.size(), classify_aspect_ratios(fine.natural, max).counts.size());
}

void PredictionTest::largest_class_empties_when_layers_are_coarsened() {
    const Level<3> fine = layer();
    const double max = summarise_aspect_ratios(fine.natural).max;
    const Prediction p = predict(fine.mesh, fine.natural, {}, 0, max);
    QVERIFY(classify_aspect_ratios(fine.natural, max).counts[0] > 0);
    QCOMPARE(p.classes.counts[0], std::int64_t{0}); // the short size doubles, the long one stays
}

void PredictionTest::asks_for_the_ratio_that_is_wanted() {
    const Level<3> fine = layer();
    const Prediction p = predict(fine.mesh, fine.natural, {}, 1.8, 100);
    QVERIFY(std::abs(static_cast<double>(fine.mesh.points.size()) / p.nodes - 1.8) < 0.01);
    QCOMPARE(p.factor, factor_for_ratio(fine.mesh, fine.natural, {}, 1.8));
}

QTEST_APPLESS_MAIN(PredictionTest)
#include "prediction_test.moc"
