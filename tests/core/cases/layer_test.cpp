// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/layer.h"

#include "core/base/error.h"
#include "core/cases/spacing.h"
#include "core/mesh/check.h"
#include "core/metric/aspect_ratio.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/cases/patches.h"

#include <QtTest>

using namespace ameco;

namespace {

LayerOptions small_layer() {
    LayerOptions o;
    o.nx = 6;
    o.ny = 5;
    o.nz = 12;
    return o;
}

/// Exact area over a wall of straight edges between radii a cylinder of radius r, with straight
/// layers up to height h: trapezoids between neighbouring columns.
double bent_area(int nx, double r, double h) {
    return nx * std::sin(1 / (nx * std::abs(r))) * std::abs((r + h) * (r + h) - r * r) / 2;
}

} // namespace

class LayerTest : public QObject {
    Q_OBJECT
private slots:
    void is_valid_whatever_its_shape_data();
    void is_valid_whatever_its_shape();
    void keeps_its_sides_flat_and_its_edges_straight();
    void fills_its_cylinder_when_bent();
    void moves_whole_columns();
    void moves_nodes_along_their_columns_by_jitter_only();
    void has_the_aspect_ratio_it_is_asked_for_at_the_wall();
    void keeps_every_nth_layer_to_the_bit();
    void refuses_a_bend_that_closes_on_itself();
};

void LayerTest::is_valid_whatever_its_shape_data() {
    QTest::addColumn<double>("aspect");
    QTest::addColumn<double>("growth");
    QTest::addColumn<double>("curvature");
    QTest::addColumn<double>("jitter");
    QTest::addColumn<int>("diagonals");
    for (const double aspect : {1e2, 1e4, 1e6}) {
        for (const double growth : {1.0, 1.2, 1.3}) {
            for (const double curvature : {0.0, 5.0, 0.5, -2.0}) {
                for (const double jitter : {0.0, 0.3}) {
                    const auto d = jitter > 0 ? Diagonals::random : Diagonals::columns;
                    QTest::addRow("aspect %g, growth %g, radius %g, jitter %g", aspect, growth,
                                  curvature, jitter)
                        << aspect << growth << curvature << jitter << static_cast<int>(d);
                }
            }
        }
    }
}

void LayerTest::is_valid_whatever_its_shape() {
    QFETCH(double, aspect);
    QFETCH(double, growth);
    QFETCH(double, curvature);
    QFETCH(double, jitter);
    QFETCH(int, diagonals);
    LayerOptions o = small_layer();
    o.aspect_ratio = aspect;
    o.growth = growth;
    o.curvature = curvature;
    o.jitter = jitter;
    o.displace = 0.24;
    o.nz = growth > 1 ? 60 : 10; // long enough to become isotropic
    o.nz = curvature < 0 ? std::min(o.nz, 40) : o.nz;
    o.diagonals = static_cast<Diagonals>(diagonals);
    if (curvature < 0 && aspect < 1e4) {
        o.nz = 12;
    }
    const CheckReport solid = check(make_layer<3>(o));
    QVERIFY2(solid.valid(), solid.summary().c_str());
    QVERIFY(solid.warnings.empty());
    const CheckReport flat = check(make_layer<2>(o));
    QVERIFY2(flat.valid(), flat.summary().c_str());
    if (curvature == 0) {
        const double height =
            growing_layers(1.0 / o.nx / aspect, growth, 1.0 / o.nx, static_cast<std::size_t>(o.nz))
                .back();
        QVERIFY(near(solid.volume, height * o.ny / o.nx, 1e-12));
        QVERIFY(near(flat.volume, height, 1e-12));
    }
}

void LayerTest::keeps_its_sides_flat_and_its_edges_straight() {
    LayerOptions o = small_layer();
    o.jitter = 0.3;
    const Mesh<3> layer = make_layer<3>(o);
    using P = const Vec<3>&;
    QVERIFY(all_of_patch<3>(layer, "wall", [](P p) { return p[2] == 0; }));
    QVERIFY(all_of_patch<3>(layer, "x-min", [](P p) { return p[0] == 0; }));
    QVERIFY(all_of_patch<3>(layer, "x-max", [](P p) { return p[0] == 1; }));
    QVERIFY(all_of_patch<3>(layer, "y-min", [](P p) { return p[1] == 0; }));
    QVERIFY(all_of_patch<3>(layer, "y-max", [](P p) { return p[1] == 5.0 / 6.0; }));
    const double top = layer.points[*patch_nodes(layer, "top").begin()][2];
    QVERIFY(all_of_patch<3>(layer, "top", [top](P p) { return p[2] == top; }));
    QCOMPARE(layer.patch_names.size(), 6u);
}

void LayerTest::fills_its_cylinder_when_bent() {
    LayerOptions o = small_layer();
    o.displace = 0;
    o.aspect_ratio = 20;
    for (const double radius : {0.5, 5.0, -5.0}) {
        o.curvature = radius;
        const double height =
            growing_layers(1.0 / o.nx / 20, o.growth, 1.0 / o.nx, static_cast<std::size_t>(o.nz))
                .back();
        const double area = bent_area(o.nx, radius, height);
        QVERIFY(near(check(make_layer<2>(o)).volume, area, 1e-12));
        QVERIFY(near(check(make_layer<3>(o)).volume, area * o.ny / o.nx, 1e-12));
    }
}

void LayerTest::moves_whole_columns() {
    const LayerOptions o = small_layer();
    const Mesh<3> layer = make_layer<3>(o);
    const std::size_t columns = 7 * 6;
    double largest = 0;
    for (std::size_t v = 0; v < layer.points.size(); ++v) {
        const Vec<3> foot = layer.points[NodeId(v % columns)];
        QCOMPARE(layer.points[NodeId(v)][0], foot[0]);
        QCOMPARE(layer.points[NodeId(v)][1], foot[1]);
        const double grid = static_cast<double>(v % columns % 7) / 6;
        largest = std::max(largest, std::abs(foot[0] - grid) * 6);
    }
    QVERIFY(largest > 0.15 && largest <= 0.2);
}

void LayerTest::moves_nodes_along_their_columns_by_jitter_only() {
    LayerOptions o = small_layer();
    const Mesh<3> straight = make_layer<3>(o);
    o.jitter = 0.3;
    const Mesh<3> moved = make_layer<3>(o);
    const auto layers =
        growing_layers(1.0 / 6 / o.aspect_ratio, o.growth, 1.0 / 6, static_cast<std::size_t>(o.nz));
    bool some = false;
    for (const NodeId v : straight.points.ids()) {
        const Vec<3> d = moved.points[v] - straight.points[v];
        const std::size_t k = v.index() / 42;
        const double height = k == 0 ? 0 : layers[k] - layers[k - 1];
        QCOMPARE(d[0], 0.0);
        QCOMPARE(d[1], 0.0);
        QVERIFY(std::abs(d[2]) <= 0.3 * height * (1 + 1e-9));
        some = some || std::abs(d[2]) > 0.2 * height;
    }
    QVERIFY(some);
}

void LayerTest::has_the_aspect_ratio_it_is_asked_for_at_the_wall() {
    for (const double aspect : {1e2, 1e4, 1e6}) {
        LayerOptions o = small_layer();
        o.aspect_ratio = aspect;
        o.displace = 0;
        const Mesh<3> layer = make_layer<3>(o);
        const auto field = nodal_metric(layer);
        for (const NodeId v : patch_nodes(layer, "wall")) {
            const double share = aspect_ratio(field[v]) / aspect;
            QVERIFY(share > 1 && share < 1.75); // of a tet against its cell: 1 ... sqrt(3)
        }
    }
}

void LayerTest::keeps_every_nth_layer_to_the_bit() {
    LayerOptions o = small_layer();
    o.jitter = 0.2;
    o.curvature = 2;
    const Mesh<3> fine = make_layer<3>(o);
    o.every = 5;
    const Mesh<3> coarse = make_layer<3>(o);
    QVERIFY(check(coarse).valid());
    const std::vector<std::size_t> kept{0, 5, 10, 12};
    QCOMPARE(coarse.points.size(), kept.size() * 42);
    for (std::size_t k = 0; k < kept.size(); ++k) {
        for (std::size_t c = 0; c < 42; ++c) {
            QVERIFY(coarse.points[NodeId(k * 42 + c)] == fine.points[NodeId(kept[k] * 42 + c)]);
        }
    }
}

void LayerTest::refuses_a_bend_that_closes_on_itself() {
    LayerOptions o = small_layer();
    o.aspect_ratio = 1;
    o.curvature = -1;
    QVERIFY_THROWS_EXCEPTION(UsageError, make_layer<3>(o));
    o.curvature = 0.1;
    QVERIFY_THROWS_EXCEPTION(UsageError, make_layer<2>(o));
}

QTEST_APPLESS_MAIN(LayerTest)
#include "layer_test.moc"
