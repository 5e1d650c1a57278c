// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/metric_source.h"

#include "tests/core/adapt/adapt_support.h"

#include <QTest>

#include <random>

using namespace ameco;
using namespace ameco::adapt_test;

class MetricSourceTest : public QObject {
    Q_OBJECT
private slots:
    void nodes_have_their_own_metric() {
        const Mesh<3> mesh = make_cube<3>({.n = 3});
        const LayerMetric<3> formula(0.01, 0.3, 0.5);
        MetricField<3> field;
        for (const Vec<3>& p : mesh.points) {
            NodeId near;
            field.push_back(formula.at(p, near));
        }
        const BackgroundMetric<3> source(mesh, field);
        for (const NodeId v : mesh.points.ids()) {
            NodeId near(0);
            const Metric<3> m = source.at(mesh.points[v], near);
            QVERIFY((m.sizes - field[v].sizes).cwiseAbs().maxCoeff() < 1e-12);
            QVERIFY(mesh.points[near] == mesh.points[v]);
        }
    }

    void sizes_that_grow_linearly_are_exact_in_the_corrected_mean() {
        const Mesh<2> mesh = make_cube<2>({.n = 4});
        const LayerMetric<2> formula(1e-6, 0.2, 10);
        MetricField<2> field;
        for (const Vec<2>& p : mesh.points) {
            NodeId near;
            field.push_back(formula.at(p, near));
        }
        const BackgroundMetric<2> source(mesh, field);
        const BackgroundMetric<2> logarithmic(mesh, field, Mean::log_euclidean);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(0, 1);
        double smaller = 0;
        for (int n = 0; n < 500; ++n) {
            const Vec<2> p(unit(random), unit(random));
            NodeId near(0);
            const double wanted = formula.at(p, near).sizes[0];
            QVERIFY(std::abs(source.at(p, near).sizes[0] - wanted) < 1e-9);
            smaller = std::max(smaller, wanted / logarithmic.at(p, near).sizes[0]);
        }
        QVERIFY(smaller > 10);
    }

    void points_outside_get_the_metric_of_the_nearest_face() {
        const Mesh<3> mesh = make_cube<3>({.n = 3});
        MetricField<3> field;
        for (const Vec<3>& p : mesh.points) {
            field.push_back({Vec<3>::Constant(1 + p[0]), Mat<3>::Identity()});
        }
        const BackgroundMetric<3> source(mesh, field);
        NodeId near(0);
        QVERIFY(std::abs(source.at({0.5, 0.3, -0.2}, near).sizes[0] - 1.5) < 1e-9);
        QVERIFY(std::abs(source.at({1.3, 0.3, 0.2}, near).sizes[0] - 2) < 1e-9);
    }

    void a_hint_that_is_no_node_does_no_harm() {
        const Mesh<3> mesh = make_cube<3>({.n = 2});
        const BackgroundMetric<3> source(mesh, remesh_test::isotropic<3>(mesh.points.size(), 0.5));
        for (const NodeId hint : {NodeId(), NodeId(1000000)}) {
            NodeId near = hint;
            QCOMPARE(source.at({0.4, 0.4, 0.4}, near).sizes[0], 0.5);
            QVERIFY(mesh.points.contains(near));
        }
    }
};

QTEST_APPLESS_MAIN(MetricSourceTest)
#include "metric_source_test.moc"
