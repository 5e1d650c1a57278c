// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/cube.h"

#include "core/mesh/check.h"
#include "core/mesh/simplex.h"
#include "core/metric/aspect_ratio.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/cases/patches.h"

#include <QtTest>

using namespace ameco;

class CubeTest : public QObject {
    Q_OBJECT
private slots:
    void is_valid_and_has_volume_one_data();
    void is_valid_and_has_volume_one();
    void is_kuhns_subdivision();
    void keeps_its_sides_flat();
    void is_isotropic();
};

void CubeTest::is_valid_and_has_volume_one_data() {
    QTest::addColumn<int>("n");
    QTest::addColumn<int>("diagonals");
    QTest::addColumn<int>("seed");
    for (const int n : {1, 2, 9}) {
        for (const auto d : {Diagonals::uniform, Diagonals::alternating, Diagonals::random}) {
            for (int seed = 0; seed < 5; ++seed) {
                QTest::addRow("n %d, diagonals %d, seed %d", n, static_cast<int>(d), seed)
                    << n << static_cast<int>(d) << seed;
            }
        }
    }
}

void CubeTest::is_valid_and_has_volume_one() {
    QFETCH(int, n);
    QFETCH(int, diagonals);
    QFETCH(int, seed);
    CubeOptions o;
    o.n = n;
    o.diagonals = static_cast<Diagonals>(diagonals);
    o.seed = seed;
    const CheckReport cube = check(make_cube<3>(o));
    QVERIFY2(cube.valid(), cube.summary().c_str());
    QVERIFY(near(cube.volume, 1, 1e-13));
    const CheckReport square = check(make_cube<2>(o));
    QVERIFY2(square.valid(), square.summary().c_str());
    QVERIFY(near(square.volume, 1, 1e-13));
}

void CubeTest::is_kuhns_subdivision() {
    CubeOptions o;
    o.n = 1;
    const Mesh<3> cube = make_cube<3>(o);
    QCOMPARE(cube.elements.size(), 6u);
    for (const Simplex<3>& s : cube.elements) { // all around the same space diagonal
        const auto in_order = sorted(s);
        QCOMPARE(in_order.front(), NodeId(0));
        QCOMPARE(in_order.back(), NodeId(7));
    }
}

void CubeTest::keeps_its_sides_flat() {
    const Mesh<3> cube = make_cube<3>();
    using P = const Vec<3>&;
    QVERIFY(all_of_patch<3>(cube, "bottom", [](P p) { return p[2] == 0; }));
    QVERIFY(all_of_patch<3>(cube, "top", [](P p) { return p[2] == 1; }));
    QVERIFY(all_of_patch<3>(cube, "x-max", [](P p) { return p[0] == 1; }));
    QVERIFY(all_of_patch<3>(cube, "y-min", [](P p) { return p[1] == 0; }));
    QVERIFY(cube.points[NodeId(5)][0] != 0.5); // while nodes on them do move
}

void CubeTest::is_isotropic() {
    const auto summary = summarise_aspect_ratios(nodal_metric(make_cube<3>()));
    QVERIFY(summary.max < 5);
    QCOMPARE(summary.share_isotropic, 1.0);
}

QTEST_APPLESS_MAIN(CubeTest)
#include "cube_test.moc"
