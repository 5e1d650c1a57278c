// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/edit_notes.h"

#include "core/cases/cube.h"
#include "core/remesh/collapse.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;

class EditNotesTest : public QObject {
    Q_OBJECT
private slots:
    void forget_what_a_collapse_changes_and_nothing_else() {
        Workbench<3> bench(make_cube<3>({.n = 4}));
        std::fill(bench.notes.quality.begin(), bench.notes.quality.end(), 0.5F);
        const ChangeTimes::Time before = bench.notes.changes.now();
        const NodeId middle(62);
        QCOMPARE(bench.edit.node_class(middle), NodeClass::interior);
        const std::vector<NodeId> around = neighbours(bench.edit, middle);
        Cavity<3> ball;
        Star<3> star;
        gather_ball(bench.edit, middle, ball);
        for (const NodeId w : around) {
            const Collapse collapse{.removed = middle, .kept = w};
            if (propose_collapse(bench.edit, bench.sizes, {}, {.floor = 0, .share = 0}, 1, collapse,
                                 ball, star) == Verdict::accepted) {
                const auto fresh = apply_collapse(bench.edit, collapse, ball, star);
                bench.notes.replaced(fresh, star.elements, bench.edit, 0);
                break;
            }
        }
        QVERIFY(bench.edit.is_removed(middle));
        for (std::size_t i = 0; i < bench.edit.slot_count(); ++i) {
            const ElementId e(i);
            if (bench.edit.is_free(e)) {
                continue;
            }
            const bool is_new =
                std::find(ball.elements.begin(), ball.elements.end(), e) != ball.elements.end();
            QCOMPARE(bench.notes.quality[i] < 0, is_new);
        }
        for (const NodeId v : bench.mesh.points.ids()) {
            const bool beside = std::find(around.begin(), around.end(), v) != around.end();
            QCOMPARE(bench.notes.changes.changed_since(v, before), beside);
        }
    }

    void slots_that_come_later_are_not_known_yet() {
        const Workbench<2> bench(make_cube<2>({.n = 2}));
        EditNotes notes(bench.edit);
        const std::size_t count = bench.edit.slot_count();
        QCOMPARE(notes.quality.size(), count);
        notes.open_lanes(2, count + 5);
        QCOMPARE(notes.quality.size(), count + 5);
        QVERIFY(notes.quality.back() < 0);
        QCOMPARE(notes.element_tried.back(), 0);
    }
};

QTEST_APPLESS_MAIN(EditNotesTest)
#include "edit_notes_test.moc"
