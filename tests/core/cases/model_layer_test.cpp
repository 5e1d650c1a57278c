// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/model_layer.h"

#include "core/base/error.h"
#include "core/mesh/check.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/cases/patches.h"

#include <numbers>

#include <QtTest>

using namespace ameco;

class ModelLayerTest : public QObject {
    Q_OBJECT
private slots:
    void is_valid_at_all_angles_data();
    void is_valid_at_all_angles();
    void turns_by_its_angle_at_the_middle_of_the_wall();
    void has_layers_parallel_to_the_wall();
    void has_a_central_node_between_both_directions();
    void refuses_layers_too_thick_for_a_concave_turn();
};

void ModelLayerTest::is_valid_at_all_angles_data() {
    QTest::addColumn<double>("angle");
    QTest::addColumn<double>("stretching");
    for (const double angle : {-60.0, -20.0, 0.0, 20.0, 90.0}) {
        for (const double stretching : {1e1, 1e2, 1e3, 1e6}) {
            QTest::addRow("%g deg, stretching %g", angle, stretching) << angle << stretching;
        }
    }
}

void ModelLayerTest::is_valid_at_all_angles() {
    QFETCH(double, angle);
    QFETCH(double, stretching);
    ModelLayerOptions o;
    o.angle_deg = angle;
    o.stretching = stretching;
    const Mesh<2> mesh = make_model_layer(o);
    QCOMPARE(mesh.points.size(), 25u);
    const CheckReport report = check(mesh);
    QVERIFY2(report.valid(), report.summary().c_str());
    // Two parallel strips of length 2, and the kite that a convex turn opens between them.
    const double height = 4 / stretching;
    const double kite = height * height * std::tan(angle * std::numbers::pi / 360);
    QVERIFY(near(report.volume, 4 * height + kite, 1e-9));
}

void ModelLayerTest::turns_by_its_angle_at_the_middle_of_the_wall() {
    const Mesh<2> mesh = make_model_layer();
    const Vec<2> left = mesh.points[NodeId(2)] - mesh.points[NodeId(1)];
    const Vec<2> right = mesh.points[NodeId(3)] - mesh.points[NodeId(2)];
    const double sine = left[0] * right[1] - left[1] * right[0];
    QVERIFY(near(std::atan2(sine, left.dot(right)), -20 * std::numbers::pi / 180, 1e-12));
    QVERIFY(near(left.norm(), 1, 1e-14));
}

void ModelLayerTest::has_layers_parallel_to_the_wall() {
    const Mesh<2> mesh = make_model_layer();
    const Vec<2> along = (mesh.points[NodeId(4)] - mesh.points[NodeId(2)]).normalized();
    const Vec<2> normal(-along[1], along[0]);
    for (int i = 2; i < 5; ++i) { // the bisector's column and those right of it
        const Vec<2> up = mesh.points[NodeId(5 + i)] - mesh.points[NodeId(2)];
        QVERIFY(near(up.dot(normal), 1e-3, 1e-10));
    }
}

void ModelLayerTest::has_a_central_node_between_both_directions() {
    const Mesh<2> mesh = make_model_layer();
    const auto field = nodal_metric(mesh);
    const NodeId centre(12);
    QCOMPARE(mesh.points[centre][0], 0.0);
    const Vec<2> stretched = field[centre].directions.col(1);
    QVERIFY(std::abs(stretched[1]) < 0.02); // along x, between walls of +10 and -10 degrees
}

void ModelLayerTest::refuses_layers_too_thick_for_a_concave_turn() {
    ModelLayerOptions o;
    o.angle_deg = -60;
    o.stretching = 1;
    QVERIFY_THROWS_EXCEPTION(UsageError, make_model_layer(o));
}

QTEST_APPLESS_MAIN(ModelLayerTest)
#include "model_layer_test.moc"
