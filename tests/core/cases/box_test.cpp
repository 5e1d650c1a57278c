// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/box.h"
#include "core/mesh/check.h"
#include "core/metric/aspect_ratio.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/cases/patches.h"

#include <QtTest>

using namespace ameco;

class BoxTest : public QObject {
    Q_OBJECT
private slots:
    void has_the_papers_counts();
    void is_valid_and_fills_the_box_data();
    void is_valid_and_fills_the_box();
    void has_six_flat_patches_turned_outward();
    void has_four_straight_patches_in_2d();
    void has_the_aspect_ratio_of_its_cells();
    void loses_the_middle_layer_when_every_second_is_kept();
};

void BoxTest::has_the_papers_counts() {
    const Mesh<3> box = make_box<3>();
    QCOMPARE(box.points.size(), 27u);   // paper, section 5.1
    QCOMPARE(box.elements.size(), 48u); // 8 bricks of 2 prisms of 3 tets
    QCOMPARE(box.faces.size(), 48u);
    QCOMPARE(make_box<2>().points.size(), 9u);
    QCOMPARE(make_box<2>().elements.size(), 8u);
}

void BoxTest::is_valid_and_fills_the_box_data() {
    QTest::addColumn<int>("diagonals");
    QTest::addColumn<double>("ratio");
    QTest::addColumn<int>("shuffle");
    for (const auto d :
         {Diagonals::uniform, Diagonals::alternating, Diagonals::columns, Diagonals::random}) {
        for (const double ratio : {1.0, 1e-3, 1e-6, 1e-9}) {
            QTest::addRow("diagonals %d, ratio %g", static_cast<int>(d), ratio)
                << static_cast<int>(d) << ratio << (ratio < 1e-3 ? 7 : 0);
        }
    }
}

void BoxTest::is_valid_and_fills_the_box() {
    QFETCH(int, diagonals);
    QFETCH(double, ratio);
    QFETCH(int, shuffle);
    BoxOptions o;
    o.nx = 4;
    o.ny = 3;
    o.nz = 5;
    o.dx = 0.5;
    o.ratio = ratio;
    o.diagonals = static_cast<Diagonals>(diagonals);
    o.shuffle = shuffle;
    const CheckReport solid = check(make_box<3>(o));
    QVERIFY2(solid.valid(), solid.summary().c_str());
    QVERIFY(near(solid.volume, 2.0 * 1.5 * (5 * 0.5 * ratio), 1e-13));
    const CheckReport flat = check(make_box<2>(o));
    QVERIFY2(flat.valid(), flat.summary().c_str());
    QVERIFY(near(flat.volume, 2.0 * (5 * 0.5 * ratio), 1e-13));
}

void BoxTest::has_six_flat_patches_turned_outward() {
    const auto normals = patch_normals(make_box<3>());
    const double side = 2 * 2e-3; // length times height
    QCOMPARE(normals.size(), 6u);
    QVERIFY(normals.at("bottom").isApprox(Vec<3>(0, 0, -4)));
    QVERIFY(normals.at("top").isApprox(Vec<3>(0, 0, 4)));
    QVERIFY(normals.at("x-min").isApprox(Vec<3>(-side, 0, 0)));
    QVERIFY(normals.at("x-max").isApprox(Vec<3>(side, 0, 0)));
    QVERIFY(normals.at("y-min").isApprox(Vec<3>(0, -side, 0)));
    QVERIFY(normals.at("y-max").isApprox(Vec<3>(0, side, 0)));
}

void BoxTest::has_four_straight_patches_in_2d() {
    const auto normals = patch_normals(make_box<2>());
    QCOMPARE(normals.size(), 4u);
    QVERIFY(normals.at("bottom").isApprox(Vec<2>(0, -2)));
    QVERIFY(normals.at("top").isApprox(Vec<2>(0, 2)));
    QVERIFY(normals.at("x-min").isApprox(Vec<2>(-2e-3, 0)));
    QVERIFY(normals.at("x-max").isApprox(Vec<2>(2e-3, 0)));
}

void BoxTest::has_the_aspect_ratio_of_its_cells() {
    // The metric of a right-angled tet is stretched a little more than its cell: by 1 to sqrt(3).
    for (const double ratio : {1e-3, 1e-6}) {
        BoxOptions o;
        o.ratio = ratio;
        for (const Metric<3>& m : nodal_metric(make_box<3>(o))) {
            QVERIFY(aspect_ratio(m) * ratio > 1 && aspect_ratio(m) * ratio < 1.75);
        }
    }
}

void BoxTest::loses_the_middle_layer_when_every_second_is_kept() {
    BoxOptions o;
    o.every = 2;
    const Mesh<3> box = make_box<3>(o);
    QCOMPARE(box.points.size(), 18u); // paper, section 5.1: the coarsened mesh
    QVERIFY(check(box).valid());
    QVERIFY(near(check(box).volume, 8e-3, 1e-13));
}

QTEST_APPLESS_MAIN(BoxTest)
#include "box_test.moc"
