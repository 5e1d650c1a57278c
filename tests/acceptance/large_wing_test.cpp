// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Multigrid on a wing of half a million nodes: two minutes.
#include "tests/acceptance/wing_iterations.h"

#include <QTest>

using namespace ameco;

class LargeWingTest : public QObject {
    Q_OBJECT
private slots:
    void multigrid_does_not_feel_eight_times_the_nodes();
};

void LargeWingTest::multigrid_does_not_feel_eight_times_the_nodes() {
    Mesh<3> mesh = make_onera_m6(twice_as_fine());
    QCOMPARE(mesh.points.size(), std::size_t{528749});
    const int found = iterations(std::move(mesh));
    QVERIFY2(found <= 11, qPrintable(QString::number(found))); // 9 on an eighth of the nodes
}

QTEST_APPLESS_MAIN(LargeWingTest)
#include "large_wing_test.moc"
