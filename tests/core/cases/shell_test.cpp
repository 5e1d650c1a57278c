// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/shell.h"

#include "core/base/error.h"
#include "core/mesh/check.h"
#include "core/metric/aspect_ratio.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/cases/patches.h"

#include <numbers>

#include <QtTest>

using namespace ameco;

namespace {

ShellOptions small_shell() {
    ShellOptions o;
    o.frequency = 4;
    o.growth = 1.4;
    o.far_field = 5;
    return o;
}

} // namespace

class ShellTest : public QObject {
    Q_OBJECT
private slots:
    void is_valid_whatever_its_shape_data();
    void is_valid_whatever_its_shape();
    void lies_between_two_confocal_ellipsoids();
    void has_about_the_volume_between_two_spheres();
    void reaches_the_aspect_ratio_it_is_asked_for();
    void becomes_isotropic_far_away();
    void keeps_every_nth_layer();
    void refuses_a_wall_too_coarse_for_its_curvature();
    void refuses_half_axes_out_of_order();
};

void ShellTest::is_valid_whatever_its_shape_data() {
    QTest::addColumn<double>("b");
    QTest::addColumn<double>("c");
    QTest::addColumn<double>("aspect");
    QTest::addColumn<int>("diagonals");
    for (const double aspect : {1e2, 1e4, 1e6}) {
        for (const auto d : {Diagonals::columns, Diagonals::random}) {
            const int i = static_cast<int>(d);
            QTest::addRow("sphere, %g, %d", aspect, i) << 1.0 << 1.0 << aspect << i;
            QTest::addRow("spindle, %g, %d", aspect, i) << 0.2 << 0.2 << aspect << i;
            QTest::addRow("three axes, %g, %d", aspect, i) << 0.5 << 0.2 << aspect << i;
            QTest::addRow("flat, %g, %d", aspect, i) << 0.8 << 0.2 << aspect << i;
        }
    }
}

void ShellTest::is_valid_whatever_its_shape() {
    QFETCH(double, b);
    QFETCH(double, c);
    QFETCH(double, aspect);
    QFETCH(int, diagonals);
    ShellOptions o = small_shell();
    o.b = b;
    o.c = c;
    o.aspect_ratio = aspect;
    o.displace = 0.2;
    o.diagonals = static_cast<Diagonals>(diagonals);
    const CheckReport report = check(make_shell(o));
    QVERIFY2(report.valid(), report.summary().c_str());
    QVERIFY(report.warnings.empty());
}

void ShellTest::lies_between_two_confocal_ellipsoids() {
    ShellOptions o = small_shell();
    o.a = 2;
    o.b = 1;
    o.c = 0.5;
    o.far_field = 3;
    const Mesh<3> shell = make_shell(o);
    const auto on = [](const Vec<3>& p, double a2, double b2, double c2) {
        return std::abs(p[0] * p[0] / a2 + p[1] * p[1] / b2 + p[2] * p[2] / c2 - 1) < 1e-13;
    };
    QVERIFY(all_of_patch<3>(shell, "wall", [&](const Vec<3>& p) { return on(p, 4, 1, 0.25); }));
    QVERIFY(
        all_of_patch<3>(shell, "farfield", [&](const Vec<3>& p) { return on(p, 36, 33, 32.25); }));
}

void ShellTest::has_about_the_volume_between_two_spheres() {
    ShellOptions o = small_shell();
    o.frequency = 12;
    o.far_field = 2;
    o.aspect_ratio = 10;
    const double exact = 4 * std::numbers::pi / 3 * 7;
    const double volume = check(make_shell(o)).volume;
    QVERIFY(volume < exact && volume > 0.98 * exact); // facets cut the far sphere's curvature off
}

void ShellTest::reaches_the_aspect_ratio_it_is_asked_for() {
    for (const double aspect : {1e3, 1e6}) {
        ShellOptions o = small_shell();
        o.aspect_ratio = aspect;
        const double top = summarise_aspect_ratios(nodal_metric(make_shell(o))).max;
        QVERIFY(top > aspect && top < 2.5 * aspect);
    }
}

void ShellTest::becomes_isotropic_far_away() {
    const Mesh<3> shell = make_shell(small_shell());
    const auto field = nodal_metric(shell);
    for (const NodeId v : patch_nodes(shell, "farfield")) {
        QVERIFY(aspect_ratio(field[v]) < 5);
    }
}

void ShellTest::keeps_every_nth_layer() {
    ShellOptions o = small_shell();
    const Mesh<3> fine = make_shell(o);
    o.every = 2;
    const Mesh<3> coarse = make_shell(o);
    const std::size_t columns = 162;
    QVERIFY(check(coarse).valid());
    QVERIFY(coarse.points[NodeId(columns)] == fine.points[NodeId(2 * columns)]);
    QVERIFY(coarse.points.raw().back() == fine.points.raw().back());
    const std::size_t layers = fine.points.size() / columns - 1;
    QCOMPARE(coarse.points.size(), ((layers + 1) / 2 + 1) * columns);
}

void ShellTest::refuses_a_wall_too_coarse_for_its_curvature() {
    ShellOptions o = small_shell();
    o.b = 0.8;
    o.c = 0.02;
    QVERIFY_THROWS_EXCEPTION(UsageError, make_shell(o));
}

void ShellTest::refuses_half_axes_out_of_order() {
    ShellOptions o = small_shell();
    o.c = 2;
    QVERIFY_THROWS_EXCEPTION(UsageError, make_shell(o));
}

QTEST_APPLESS_MAIN(ShellTest)
#include "shell_test.moc"
