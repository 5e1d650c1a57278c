// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/change_times.h"

#include <QTest>

#include <array>

using namespace ameco;

class ChangeTimesTest : public QObject {
    Q_OBJECT
private slots:
    void everything_has_changed_since_the_beginning_and_nothing_since_now() {
        ChangeTimes times(3);
        for (const NodeId v : {NodeId(0), NodeId(1), NodeId(2)}) {
            QVERIFY(times.changed_since(v, 0));
            QVERIFY(!times.changed_since(v, times.now()));
        }
        const ChangeTimes::Time before = times.now();
        times.touch(NodeId(1));
        times.tick();
        QVERIFY(times.changed_since(NodeId(1), before));
        QVERIFY(!times.changed_since(NodeId(1), times.now()));
        QVERIFY(!times.changed_since(NodeId(2), before));
    }

    void an_element_needs_two_nodes_that_have_changed() {
        ChangeTimes times(4);
        const std::array element{NodeId(0), NodeId(1), NodeId(2)};
        const ChangeTimes::Time before = times.now();
        QCOMPARE(times.changed_corners(element, 0), 0b111U);
        QCOMPARE(times.changed_corners(element, before), 0U);
        times.touch(NodeId(1));
        times.touch(NodeId(3));
        QCOMPARE(times.changed_corners(element, before), 0b010U);
        QVERIFY(!ChangeTimes::has_edge(0b010U));
        times.touch(NodeId(2));
        QCOMPARE(times.changed_corners(element, before), 0b110U);
        QVERIFY(ChangeTimes::has_edge(0b110U));
    }

    void lanes_go_on_from_the_latest_of_all() {
        ChangeTimes times(2);
        times.open_lanes(3);
        times.tick(1);
        times.tick(1);
        times.touch(NodeId(0), 1);
        const ChangeTimes::Time latest = times.now(1);
        QVERIFY(times.now(0) < latest);
        times.open_lanes(2);
        QCOMPARE(times.now(0), latest);
        QCOMPARE(times.now(1), latest);
        times.tick(0);
        QVERIFY(!times.changed_since(NodeId(0), times.now(0)));
    }

    void a_node_that_is_added_changes_now() {
        ChangeTimes times(1);
        const ChangeTimes::Time before = times.now();
        times.add_node();
        QVERIFY(times.changed_since(NodeId(1), before));
        times.drop_last_node();
        times.tick();
        times.add_node();
        QVERIFY(times.changed_since(NodeId(1), times.now()));
    }
};

QTEST_APPLESS_MAIN(ChangeTimesTest)
#include "change_times_test.moc"
