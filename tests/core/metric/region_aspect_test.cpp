// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/region_aspect.h"

#include "core/metric/nodal_metric.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <random>

#include <Eigen/Geometry>

using namespace ameco;

class RegionAspectTest : public QObject {
    Q_OBJECT
private slots:
    void is_that_of_the_nodes_where_they_agree();
    void is_near_1_where_directions_are_at_random();
    void of_layers_is_as_large_as_that_of_their_nodes();
};

void RegionAspectTest::is_that_of_the_nodes_where_they_agree() {
    const Mesh<3> mesh = shapes::cube(3);
    MetricField<3> field(mesh.points.size());
    for (Metric<3>& metric : field) {
        metric.sizes = Vec<3>(1e-6, 0.5, 2);
    }
    for (const float ratio : region_aspect_ratios(mesh, field)) {
        QCOMPARE_LE(std::abs(static_cast<double>(ratio) / 2e6 - 1), 1e-6);
    }
}

void RegionAspectTest::is_near_1_where_directions_are_at_random() {
    const int n = 8;
    const Mesh<3> mesh = shapes::cube(n);
    MetricField<3> field(mesh.points.size());
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (Metric<3>& metric : field) {
        metric.sizes = Vec<3>(0.7, 1, 1.4);
        const Eigen::Quaterniond turn(normal(random), normal(random), normal(random),
                                      normal(random));
        metric.directions = turn.normalized().toRotationMatrix();
    }
    const auto ratios = region_aspect_ratios(mesh, field);
    for (const NodeId v : mesh.points.ids()) {
        const bool inside = (mesh.points[v].array() > 1.5 / n).all() &&
                            (mesh.points[v].array() < 1 - 1.5 / n).all();
        if (inside) {
            QCOMPARE_LT(ratios[v], 1.4f); // the nodes' own is 2
        }
    }
}

void RegionAspectTest::of_layers_is_as_large_as_that_of_their_nodes() {
    const Mesh<3> mesh = shapes::stretched_slab(4, 6, 1e-5, 1.2);
    const MetricField<3> field = nodal_metric(mesh);
    const auto ratios = region_aspect_ratios(mesh, field);
    for (const NodeId v : mesh.points.ids()) {
        QCOMPARE_GT(static_cast<double>(ratios[v]), 0.3 * aspect_ratio(field[v]));
    }
}

QTEST_APPLESS_MAIN(RegionAspectTest)
#include "region_aspect_test.moc"
