// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/onera_m6.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/check.h"
#include "tests/core/cases/patches.h"

#include <QtTest>

using namespace ameco;

namespace {

OneraM6Options preset(const std::string& name) {
    for (const OneraM6Preset& p : onera_m6_presets()) {
        if (p.name == name) {
            return p.options;
        }
    }
    throw std::logic_error("no preset " + name);
}

Vec<3> extent(const Mesh<3>& mesh) {
    Vec<3> low = mesh.points[NodeId(0)], high = low;
    for (const Vec<3>& p : mesh.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return high - low;
}

} // namespace

class OneraM6Test : public QObject {
    Q_OBJECT
private slots:
    void is_valid_in_many_variants_data();
    void is_valid_in_many_variants();
    void has_its_symmetry_plane_exactly_at_zero();
    void has_the_wings_planform_and_a_mirrored_section();
    void puts_the_far_field_ten_chords_away();
    void keeps_every_nth_layer();
    void is_the_same_on_any_number_of_threads();
    void refuses_layers_that_overshoot_the_far_field();
    void refuses_thinned_columns_that_never_catch_up();
};

void OneraM6Test::is_valid_in_many_variants_data() {
    QTest::addColumn<int>("variant");
    QTest::newRow("as it is") << 0;
    QTest::newRow("sharp trailing edge") << 1;
    QTest::newRow("random diagonals") << 2;
    QTest::newRow("uniform diagonals") << 3;
    QTest::newRow("heights of 1e-8") << 4;
    QTest::newRow("thinned columns") << 5;
    QTest::newRow("every second layer") << 6;
    QTest::newRow("shuffled") << 7;
    QTest::newRow("alternating diagonals, no spread") << 8;
}

void OneraM6Test::is_valid_in_many_variants() {
    QFETCH(int, variant);
    OneraM6Options o = preset("m6-8k");
    switch (variant) {
    case 1:
        o.trailing_edge = TrailingEdge::sharp;
        break;
    case 2:
        o.diagonals = Diagonals::random;
        break;
    case 3:
        o.diagonals = Diagonals::uniform;
        break;
    case 4:
        o.first_height = 1e-8;
        o.layers = 50;
        o.growth_layers = 30;
        break;
    case 5:
        o.thin_ratio = 0.3;
        break;
    case 6:
        o.every = 2;
        break;
    case 7:
        o.shuffle = 5;
        break;
    case 8:
        o.diagonals = Diagonals::alternating;
        o.spread = 1;
        break;
    default:
        break;
    }
    const CheckReport report = check(make_onera_m6(o));
    QVERIFY2(report.valid(), report.summary().c_str());
    QVERIFY(report.warnings.empty());
}

void OneraM6Test::has_its_symmetry_plane_exactly_at_zero() {
    const Mesh<3> m6 = make_onera_m6(preset("m6-8k"));
    QVERIFY(all_of_patch<3>(m6, "symmetry", [](const Vec<3>& p) { return p[1] == 0; }));
    for (const NodeId v : m6.points.ids()) {
        QVERIFY(m6.points[v][1] >= 0);
    }
    QCOMPARE(patch_nodes(m6, "symmetry").size(), std::size_t{32 * 21}); // one section, all layers
}

void OneraM6Test::has_the_wings_planform_and_a_mirrored_section() {
    const Mesh<3> m6 = make_onera_m6(preset("m6-8k"));
    double span = 0, nose = 1, tail = 0, top = 0, bottom = 0;
    for (const NodeId v : patch_nodes(m6, "wing")) {
        const Vec<3>& p = m6.points[v];
        span = std::max(span, p[1]);
        top = std::max(top, p[2]);
        bottom = std::min(bottom, p[2]);
        if (p[1] == 0) {
            nose = std::min(nose, p[0]);
            tail = std::max(tail, p[0]);
        }
    }
    QCOMPARE(nose, 0.0);
    QVERIFY(near(tail, 0.8059 * 1.000624, 1e-5));
    QVERIFY(near(span, 1.1963 + 0.0489 * 0.4540, 1e-3)); // half span and half the tip's thickness
    QCOMPARE(bottom, -top);
    QVERIFY(near(top, 0.0489 * 0.8059, 1e-2));
}

void OneraM6Test::puts_the_far_field_ten_chords_away() {
    const Mesh<3> m6 = make_onera_m6(preset("m6-8k"));
    // No column of this coarse mesh ends exactly on top of the far ellipse.
    QVERIFY(extent(m6)[2] <= 2 * 6.46 && extent(m6)[2] > 2 * 6.4);
    QVERIFY(extent(m6)[0] > 2 * 6.46);
}

void OneraM6Test::keeps_every_nth_layer() {
    OneraM6Options o = preset("m6-8k");
    const Mesh<3> fine = make_onera_m6(o);
    o.every = 2;
    const Mesh<3> coarse = make_onera_m6(o);
    const std::size_t columns = 397;
    QCOMPARE(coarse.points.size(), 11 * columns);
    for (std::size_t k = 0; k <= 10; ++k) {
        for (std::size_t c = 0; c < columns; ++c) {
            QVERIFY(coarse.points[NodeId(k * columns + c)] ==
                    fine.points[NodeId(2 * k * columns + c)]);
        }
    }
}

void OneraM6Test::is_the_same_on_any_number_of_threads() {
    const int before = thread_count();
    set_thread_count(1);
    const Mesh<3> alone = make_onera_m6(preset("m6-8k"));
    set_thread_count(3);
    const Mesh<3> together = make_onera_m6(preset("m6-8k"));
    set_thread_count(before);
    QVERIFY(alone == together);
}

void OneraM6Test::refuses_layers_that_overshoot_the_far_field() {
    OneraM6Options o = preset("m6-8k");
    o.first_height = 1;
    QVERIFY_THROWS_EXCEPTION(UsageError, make_onera_m6(o));
    o = preset("m6-8k");
    o.growth_layers = o.layers;
    QVERIFY_THROWS_EXCEPTION(UsageError, make_onera_m6(o));
}

void OneraM6Test::refuses_thinned_columns_that_never_catch_up() {
    OneraM6Options o = preset("m6-8k");
    o.thin_ratio = 0.01; // 8 layers that double, against a growth of 1.4, make up for 0.06 only
    QVERIFY_THROWS_EXCEPTION(UsageError, make_onera_m6(o));
}

QTEST_APPLESS_MAIN(OneraM6Test)
#include "onera_m6_test.moc"
