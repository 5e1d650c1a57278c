// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/coarsen.h"

#include "core/cases/layer.h"
#include "core/cases/shell.h"
#include "tests/support/boundary_fit.h"
#include "tests/support/layered_cases.h"

#include <QTest>

using namespace ameco;

namespace {

constexpr int wall = 1;

/// Nodes whose layer, counted from the wall or plane that is nearest, is no multiple of `every`.
template <class LayerOf>
std::int64_t in_wrong_layers(const std::vector<NodeId>& finest_ids, int every, LayerOf layer_of) {
    return std::count_if(finest_ids.begin(), finest_ids.end(),
                         [&](NodeId v) { return layer_of(v) % every != 0; });
}

} // namespace

class CurvedLayersTest : public QObject {
    Q_OBJECT

    static Mesh<3> curved_case(const QString& what, double aspect) {
        LayerOptions layer;
        layer.nx = layer.ny = 8;
        layer.aspect_ratio = aspect;
        if (what == "convex plate" || what == "concave plate") {
            layer.curvature = what == "convex plate" ? 1 : -1;
            return make_layer<3>(layer);
        }
        if (what == "cylinder") {
            const double step = 2 * std::numbers::pi / 24;
            return layered_cases::cylinder(24, 6, growing_layers(step / aspect, 1.2, step, 32));
        }
        ShellOptions shell;
        shell.frequency = 3;
        shell.aspect_ratio = aspect;
        shell.a = what == "ellipsoid" ? 2 : 1;
        shell.b = what == "ellipsoid" ? 1.5 : 1;
        return make_shell(shell);
    }

private slots:
    void curved_walls_stay_where_they_are_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<double>("aspect");
        for (const char* what :
             {"convex plate", "concave plate", "cylinder", "sphere", "ellipsoid"}) {
            for (const double aspect : {1e4, 1e6}) {
                QTest::addRow("%s, %.0e", what, aspect) << QString(what) << aspect;
            }
        }
    }
    /// Layers lose nodes across the wall and none along it: it does not move by more than rounding
    /// before the mesh beside it is nearly isotropic, and never by half of the height above it.
    void curved_walls_stay_where_they_are() {
        QFETCH(QString, what);
        QFETCH(double, aspect);
        const Mesh<3> finest = curved_case(what, aspect);
        Level<3> level = finest_level(finest, {});
        const double volume = check(finest).volume;
        const bool has_farfield = what == "sphere" || what == "ellipsoid";
        for (int k = 1; k <= 3; ++k) {
            CoarsenReport report;
            level = coarsen(level, {}, report);
            QVERIFY2(report.check.valid(), report.check.summary().c_str());
            const auto fits = boundary_fit::measure(level, finest);
            QVERIFY(fits.at(wall).over_short <= 0.5);
            QVERIFY(fits.at(wall).over_edge <= 0.1);
            if (aspect >= 1e5) {
                QVERIFY(fits.at(wall).over_edge < 1e-12);
            }
            // The coarse far field and the isotropic end of the layers are polygons.
            QVERIFY(std::abs(report.check.volume / volume - 1) < (has_farfield ? 0.05 : 0.02));
            QVERIFY(boundary_fit::area_change(level.mesh, finest) < 0.05);
            QVERIFY(level.mesh.patch_names == finest.patch_names);
            QVERIFY(static_cast<double>(report.nodes_before) >=
                    (k <= 2 ? 1.8 : 1.4) * static_cast<double>(report.nodes_after));
        }
    }

    void layers_inside_and_between_walls_lose_every_other_one_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<double>("aspect");
        for (const char* what : {"shear layer", "thin gap", "wake sheet"}) {
            for (const double aspect : {1e4, 1e6}) {
                QTest::addRow("%s, %.0e", what, aspect) << QString(what) << aspect;
            }
        }
    }
    void layers_inside_and_between_walls_lose_every_other_one() {
        QFETCH(QString, what);
        QFETCH(double, aspect);
        constexpr int n = 8, half = 16;
        const double dx = 1.0 / n;
        const bool gap = what == "thin gap";
        Mesh<3> finest =
            layered_cases::box(n, gap ? layered_cases::between_walls(dx / aspect, 1.2, dx, half)
                                      : layered_cases::about_plane(dx / aspect, 1.2, dx, half));
        if (what == "wake sheet") {
            layered_cases::add_sheet(finest, n);
        }
        // Both from the walls and from the plane between them: half is a power of two.
        const auto layer_of = [](NodeId v) { return v.value() / ((n + 1) * (n + 1)); };
        Level<3> level = finest_level(finest, {});
        const double volume = check(finest).volume;
        std::vector<NodeId> ids;
        for (const NodeId v : finest.points.ids()) {
            ids.push_back(v);
        }
        for (int k = 1; k <= 3; ++k) {
            CoarsenReport report;
            level = coarsen(level, {}, report);
            QVERIFY2(report.check.valid(), report.check.summary().c_str());
            std::vector<NodeId> left;
            for (const NodeId parent : level.parent) {
                left.push_back(ids[parent.index()]);
            }
            ids = left;
            QCOMPARE(ids.size(),
                     static_cast<std::size_t>((n + 1) * (n + 1) * (2 * half / (1 << k) + 1)));
            QCOMPARE(in_wrong_layers(ids, 1 << k, layer_of), std::int64_t{0});
            // All sides are planes, and along the axes.
            QVERIFY(std::abs(report.check.volume / volume - 1) < 1e-13);
            QVERIFY(boundary_fit::area_change(level.mesh, finest) < 1e-13);
            QVERIFY(level.mesh.patch_names == finest.patch_names);
            QCOMPARE(report.check.interior_faces, check(finest).interior_faces);
        }
    }
};

QTEST_APPLESS_MAIN(CurvedLayersTest)
#include "curved_layers_test.moc"
