// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/surface/thin_surface.h"

#include "core/surface/surface_distance.h"
#include "core/surface/surface_features.h"
#include "core/surface/surface_report.h"
#include "tests/core/surface/surfaces.h"

#include <QtTest>

using namespace ameco;

class ThinSurfaceTest : public QObject {
    Q_OBJECT
private slots:
    void keeps_genus_patches_and_features_data();
    void keeps_genus_patches_and_features();
    void stays_within_the_distance_allowed();
    void leaves_frozen_nodes_alone();
    void adds_to_the_deviation_there_was();
};

namespace {

/// Everything shorter than `length` is to go; ridges as the features have them.
ThinningInput input_for(const Mesh<3>& mesh, double length) {
    ThinningInput input;
    for (const NodeId v : mesh.points.ids()) {
        input.order.push_back(v);
    }
    const SurfaceFeatures features = find_surface_features(mesh);
    input.frozen.assign(mesh.points.size(), false);
    for (const NodeId v : features.corners) {
        input.frozen[v.index()] = true;
    }
    for (const Edge& e : features.ridges) {
        input.ridges.push_back({e, 5});
    }
    input.reach.assign(mesh.points.size(), 1e9);
    input.too_close = [&mesh, length](NodeId v, NodeId w) {
        return (mesh.points[v] - mesh.points[w]).norm() < length;
    };
    return input;
}

/// The same without the nodes that nothing uses.
Mesh<3> compact(const Mesh<3>& surface) {
    return boundary_surface(surface);
}

} // namespace

void ThinSurfaceTest::keeps_genus_patches_and_features_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("length");
    QTest::newRow("cube") << "cube" << 0.2;
    QTest::newRow("sphere") << "sphere" << 0.25;
    QTest::newRow("torus") << "torus" << 0.15;
}

void ThinSurfaceTest::keeps_genus_patches_and_features() {
    QFETCH(QString, name);
    QFETCH(double, length);
    const Mesh<3> given = name == "cube"     ? surfaces::cube(10)
                          : name == "sphere" ? surfaces::sphere(16)
                                             : surfaces::torus(80, 40);
    const Thinning thinning = thin_surface(given, input_for(given, length));
    const Mesh<3> thin = compact(thinning.surface);
    const SurfaceReport before = inspect_surface(given), after = inspect_surface(thin);
    QVERIFY(after.sound());
    QCOMPARE(after.parts[0].genus(), before.parts[0].genus());
    QVERIFY2(2 * thin.points.size() <= given.points.size(),
             qPrintable(QString::number(thin.points.size())));
    QCOMPARE(static_cast<std::int64_t>(given.points.size() - thin.points.size()),
             thinning.collapses);
    if (name == "cube") {
        QVERIFY(std::abs(after.parts[0].volume - 1) < 1e-13);
        const SurfaceFeatures features = find_surface_features(thin);
        QCOMPARE(features.curves.size(), std::size_t{12});
        QCOMPARE(features.corners.size(), std::size_t{8});
        QCOMPARE(features.ridges.size(), thinning.ridges.size());
        QVERIFY(thinning.ridges.size() < 100); // of 120
        QCOMPARE(thinning.ridges[0].number, 5);
    }
}

void ThinSurfaceTest::stays_within_the_distance_allowed() {
    const Mesh<3> given = surfaces::sphere(20);
    std::int64_t before = 0;
    for (const double reach : {5e-3, 5e-2}) {
        ThinningInput input = input_for(given, 0.5);
        input.reach.assign(given.points.size(), reach);
        const Thinning thinning = thin_surface(given, input);
        QVERIFY(thinning.collapses > before);
        before = thinning.collapses;
        const double far = surface_distance(compact(thinning.surface), given, 1e-5).upper();
        QVERIFY2(far < 1.5 * reach, qPrintable(QString::number(far))); // it is sampled
        double bound = 0;
        for (const double d : thinning.deviation) {
            bound = std::max(bound, d);
        }
        QVERIFY(bound <= reach);
    }
}

void ThinSurfaceTest::leaves_frozen_nodes_alone() {
    const Mesh<3> given = surfaces::sphere(8);
    ThinningInput input = input_for(given, 1);
    input.frozen.assign(given.points.size(), true);
    const Thinning thinning = thin_surface(given, input);
    QCOMPARE(thinning.collapses, std::int64_t{0});
    QCOMPARE(thinning.surface.faces.size(), given.faces.size());
}

void ThinSurfaceTest::adds_to_the_deviation_there_was() {
    const Mesh<3> given = surfaces::sphere(12);
    ThinningInput input = input_for(given, 0.3);
    const std::int64_t without = thin_surface(given, input).collapses;
    input.deviation.resize(given.faces.size(), 0.01);
    const Thinning thinning = thin_surface(given, input);
    QVERIFY(thinning.collapses < without);
    for (const double d : thinning.deviation) {
        QVERIFY(d >= 0.01);
    }
}

QTEST_APPLESS_MAIN(ThinSurfaceTest)
#include "thin_surface_test.moc"
