// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/rebuild.h"

#include "core/base/error.h"
#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "core/cases/shell.h"
#include "core/hierarchy/build_hierarchy.h"
#include "core/recovery/fill.h"
#include "tests/support/faces.h"

#include <QTest>

using namespace ameco;

class RebuildTest : public QObject {
    Q_OBJECT
private slots:
    void init();
    void gives_a_valid_nested_level_data();
    void gives_a_valid_nested_level();
    void coarsens_isotropic_meshes_as_predicted();
    void the_boundary_stays_within_its_bound();
    void the_boundary_is_kept_when_asked();
    void refuses_meshes_of_several_regions();
};

namespace {

Mesh<3> mesh_of(const QString& name) {
    if (name == "cube") {
        return make_cube<3>({.n = 8, .displace = 0.2});
    }
    if (name == "shell") { // the wall of a cavity, and a farfield
        return make_shell({.frequency = 6, .aspect_ratio = 100});
    }
    LayerOptions options{.nx = 12, .ny = 12, .nz = 16, .aspect_ratio = 1e4};
    options.curvature = name == "flat layer" ? 0 : 2;
    return make_layer<3>(options);
}

} // namespace

void RebuildTest::init() {
    if (!can_recover()) {
        QSKIP("built without TetGen");
    }
}

void RebuildTest::gives_a_valid_nested_level_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("levels");
    QTest::newRow("cube") << "cube" << 2;
    QTest::newRow("flat layer") << "flat layer" << 2;
    QTest::newRow("curved layer") << "curved layer" << 1;
    QTest::newRow("shell") << "shell" << 1;
}

void RebuildTest::gives_a_valid_nested_level() {
    QFETCH(QString, name);
    QFETCH(int, levels);
    const CoarsenOptions options;
    Level<3> level = finest_level(mesh_of(name), options);
    for (int k = 0; k < levels; ++k) {
        CoarsenReport report;
        const Level<3> coarse = rebuild_level(level, options, report);
        const CheckReport checked = check(coarse.mesh);
        QVERIFY2(checked.valid(), checked.summary().c_str());
        QVERIFY(report.nodes_after < 0.7 * static_cast<double>(report.nodes_before));
        QCOMPARE(coarse.parent.size(), coarse.mesh.points.size());
        QCOMPARE(coarse.geometry.node.size(), coarse.mesh.points.size());
        QCOMPARE(coarse.geometry.deviation.size(), coarse.mesh.faces.size());
        for (const NodeId v : coarse.mesh.points.ids()) {
            QVERIFY(coarse.mesh.points[v] == level.mesh.points[coarse.parent[v]]);
            QVERIFY(v.value() == 0 || coarse.parent[NodeId(v.value() - 1)] < coarse.parent[v]);
            QVERIFY(coarse.geometry.node[v] == level.geometry.node[coarse.parent[v]]);
        }
        for (const NodeId v : level.mesh.points.ids()) { // corners stay
            QVERIFY(level.geometry.node[v] != NodeClass::frozen ||
                    std::find(coarse.parent.begin(), coarse.parent.end(), v) !=
                        coarse.parent.end());
        }
        level = coarse;
    }
}

void RebuildTest::coarsens_isotropic_meshes_as_predicted() {
    const CoarsenOptions options;
    const Level<3> level = finest_level(make_cube<3>({.n = 10, .displace = 0.2}), options);
    CoarsenReport rebuilt, local;
    (void)rebuild_level(level, options, rebuilt);
    (void)coarsen(level, options, local);
    QVERIFY(std::abs(static_cast<double>(rebuilt.nodes_after) / rebuilt.predicted_nodes - 1) < 0.2);
    QVERIFY(rebuilt.conformity.in_band > local.conformity.in_band);
}

void RebuildTest::the_boundary_stays_within_its_bound() {
    const CoarsenOptions options;
    const Level<3> level = finest_level(mesh_of("shell"), options);
    CoarsenReport report;
    const Level<3> coarse = rebuild_level(level, options, report);
    QVERIFY(report.deviation > 0);
    QVERIFY(report.deviation_relative <= options.removal.surface.relative_distance);
}

void RebuildTest::the_boundary_is_kept_when_asked() {
    CoarsenOptions options;
    options.features.boundary = BoundaryChoice::keep;
    const Mesh<3> shell = mesh_of("shell");
    const Level<3> level = finest_level(shell, options);
    CoarsenReport report;
    const Level<3> coarse = rebuild_level(level, options, report);
    QCOMPARE(test::faces_of(coarse.mesh), test::faces_of(shell));
    QVERIFY(coarse.mesh.points.size() < shell.points.size());
    QCOMPARE(coarse.geometry.frozen_patches, level.geometry.frozen_patches);
}

void RebuildTest::refuses_meshes_of_several_regions() {
    Mesh<3> mesh = make_cube<3>({.n = 3});
    for (std::size_t e = 0; e < mesh.elements.size(); e += 2) {
        mesh.region[ElementId(e)] = 2;
    }
    const CoarsenOptions options;
    const Level<3> level = finest_level(mesh, options);
    CoarsenReport report;
    QVERIFY_THROWS_EXCEPTION(UsageError, (void)rebuild_level(level, options, report));
    HierarchyOptions hierarchy;
    require_possible(mesh, hierarchy);
    hierarchy.rebuild = true; // known before anything is made
    QVERIFY_THROWS_EXCEPTION(UsageError, require_possible(mesh, hierarchy));
}

QTEST_APPLESS_MAIN(RebuildTest)
#include "rebuild_test.moc"
