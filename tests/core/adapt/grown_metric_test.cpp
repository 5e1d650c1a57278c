// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/grown_metric.h"

#include "core/adapt/adapt.h"
#include "tests/core/adapt/adapt_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

namespace {

/// The unit square z = 0 in two triangles.
Mesh<3> square() {
    Mesh<3> surface;
    surface.points =
        IdVector<NodeId, Vec<3>>(std::vector<Vec<3>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    surface.faces.push_back({NodeId(0), NodeId(1), NodeId(2)});
    surface.faces.push_back({NodeId(0), NodeId(2), NodeId(3)});
    surface.patch.assign(2, 1);
    return surface;
}

MetricField<3> wall(double h) {
    Metric<3> metric;
    metric.sizes << h, 0.4, 0.5;
    metric.directions << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    return MetricField<3>(4, metric);
}

} // namespace

class GrownMetricTest : public QObject {
    Q_OBJECT
private slots:
    void on_the_surface_it_is_the_given_one() {
        const Mesh<3> surface = square();
        const GrownMetric source(surface, wall(1e-6), 0.2);
        NodeId near;
        const Metric<3> m = source.at({0.3, 0.6, 0}, near);
        QVERIFY(std::abs(m.sizes[0] / 1e-6 - 1) < 1e-9);
        QVERIFY(std::abs(m.sizes[1] - 0.4) < 1e-12);
        QVERIFY(std::abs(std::abs(m.directions(2, 0)) - 1) < 1e-12);
    }

    void sizes_grow_with_the_distance() {
        const Mesh<3> surface = square();
        const GrownMetric source(surface, wall(0.01), 0.2);
        NodeId near;
        const Metric<3> above = source.at({0.3, 0.6, 0.5}, near);
        QVERIFY(std::abs(above.sizes[0] - 0.11) < 1e-12);
        QVERIFY(std::abs(above.sizes[2] - 0.6) < 1e-12);
        // Beyond the rim the nearest point is on it.
        const Metric<3> beside = source.at({1.3, 0.5, 0.4}, near);
        QVERIFY(std::abs(beside.sizes[0] - 0.11) < 1e-12);
    }

    void layers_grow_from_it() {
        const Mesh<3> surface = square();
        const GrownMetric source(surface, wall(1e-3), 0.3);
        AdaptReport report;
        const auto adapted = adapt(make_cube<3>({.n = 3, .displace = 0}), source, {}, report);
        QVERIFY2(report.conformity.in_band > 0.93,
                 std::to_string(report.conformity.in_band).c_str());
        double first = 1;
        for (const Vec<3>& p : adapted.mesh.points) {
            first = p[2] > 0 ? std::min(first, p[2]) : first;
        }
        QVERIFY2(first > 5e-4 && first < 2e-3, std::to_string(first).c_str());
    }
};

QTEST_APPLESS_MAIN(GrownMetricTest)
#include "grown_metric_test.moc"
