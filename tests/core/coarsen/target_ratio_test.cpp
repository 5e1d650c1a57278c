// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/target_ratio.h"

#include "core/base/error.h"
#include "core/cases/layer.h"
#include "core/metric/expected_nodes.h"

#include <QTest>

using namespace ameco;

namespace {

/// Layers below, isotropic above.
template <int D>
Mesh<D> mixed() {
    LayerOptions options;
    options.nx = D == 3 ? 8 : 32;
    options.ny = 8;
    options.nz = 24;
    options.aspect_ratio = 50;
    options.growth = 1.3;
    return make_layer<D>(options);
}

template <int D>
void metric_asks_for_the_ratio(double ratio) {
    const Mesh<D> mesh = mixed<D>();
    const MetricField<D> natural = nodal_metric(mesh);
    TargetOptions options;
    options.factor = factor_for_ratio(mesh, natural, options, ratio);
    QVERIFY(options.factor > 1 && options.factor < largest_factor);
    const double asked =
        expected_nodes(mesh, natural) / expected_nodes(mesh, target_metric(mesh, natural, options));
    QCOMPARE_LE(std::abs(asked / ratio - 1), 1e-3);
}

class Stopped : public Monitor {
public:
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view) override {}
    [[nodiscard]] bool stop_requested() const override { return true; }
};

class Listener : public Monitor {
public:
    void message(Severity, std::string_view text) override { messages.emplace_back(text); }
    void progress(double, std::string_view) override {}
    [[nodiscard]] bool stop_requested() const override { return false; }
    std::vector<std::string> messages;
};

} // namespace

class TargetRatioTest : public QObject {
    Q_OBJECT
private slots:
    void the_metric_asks_for_the_ratio_data();
    void the_metric_asks_for_the_ratio();
    void a_ratio_out_of_reach_takes_the_largest_factor();
    void the_level_has_the_ratio_data();
    void the_level_has_the_ratio();
    void says_which_ratio_there_is_when_it_is_another();
    void stops_when_asked();
};

void TargetRatioTest::the_metric_asks_for_the_ratio_data() {
    QTest::addColumn<double>("ratio");
    for (const double ratio : {1.1, 1.7, 2.0, 3.0}) {
        QTest::addRow("ratio %g", ratio) << ratio;
    }
}

void TargetRatioTest::the_metric_asks_for_the_ratio() {
    QFETCH(const double, ratio);
    metric_asks_for_the_ratio<2>(ratio);
    metric_asks_for_the_ratio<3>(ratio);
}

void TargetRatioTest::a_ratio_out_of_reach_takes_the_largest_factor() {
    const Mesh<2> mesh = mixed<2>();
    QCOMPARE(factor_for_ratio(mesh, nodal_metric(mesh), {}, 1e6), largest_factor);
}

void TargetRatioTest::the_level_has_the_ratio_data() {
    QTest::addColumn<double>("ratio");
    for (const double ratio : {1.8, 2.0, 2.1}) {
        QTest::addRow("ratio %g", ratio) << ratio;
    }
}

void TargetRatioTest::the_level_has_the_ratio() {
    QFETCH(const double, ratio);
    CoarsenReport report;
    Listener listener;
    const Level<2> coarse =
        coarsen_by_ratio(finest_level(mixed<2>(), {}), {}, ratio, report, listener);
    const double reached =
        static_cast<double>(report.nodes_before) / static_cast<double>(report.nodes_after);
    QCOMPARE(report.nodes_after, static_cast<std::int64_t>(coarse.mesh.points.size()));
    QCOMPARE_LE(std::abs(reached / ratio - 1), 0.05);
    QVERIFY(listener.messages.empty());
    QCOMPARE_GT(report.factor, 1.0);
}

void TargetRatioTest::says_which_ratio_there_is_when_it_is_another() {
    CoarsenReport report;
    Listener listener;
    (void)coarsen_by_ratio(finest_level(mixed<2>(), {}), {}, 20, report, listener);
    QCOMPARE(listener.messages.size(), 1U);
    QVERIFY2(listener.messages[0].find("not the 20.00 asked for") != std::string::npos,
             listener.messages[0].c_str());
}

void TargetRatioTest::stops_when_asked() {
    CoarsenReport report;
    Stopped stopped;
    const Level<2> fine = finest_level(mixed<2>(), {});
    QVERIFY_THROWS_EXCEPTION(Cancelled, (void)coarsen_by_ratio(fine, {}, 2, report, stopped));
}

QTEST_APPLESS_MAIN(TargetRatioTest)
#include "target_ratio_test.moc"
