// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/camera.h"
#include "gui/scene/legend.h"
#include "gui/scene/scene_input.h"

#include <QTest>

using namespace ameco;
using namespace ameco::gui;

class SceneInputTest : public QObject {
    Q_OBJECT
private slots:
    void finds_the_level_on_which_nodes_are_missing();
    void names_lead_back_to_what_they_name();
    void ticks_are_round_and_in_the_range();
    void lengths_of_scale_bars_are_round();
    void numbers_are_short();
};

void SceneInputTest::finds_the_level_on_which_nodes_are_missing() {
    using Parents = IdVector<NodeId, NodeId>;
    const Parents first(std::vector{NodeId(0), NodeId(2), NodeId(3), NodeId(5)}); // 1 and 4 go
    const Parents second(std::vector{NodeId(1), NodeId(3)}); // of these the ones called 0 and 3
    QCOMPARE(removal_levels(6, 0, {&first, &second}), (std::vector<int>{2, 1, 0, 2, 1, 0}));
    QCOMPARE(removal_levels(4, 1, {&second}), (std::vector<int>{2, 0, 2, 0}));
    QCOMPARE(removal_levels(2, 2, {}), (std::vector<int>{0, 0}));
}

void SceneInputTest::names_lead_back_to_what_they_name() {
    for (const ColourBy colour : all_colours) {
        QCOMPARE(colour_from_name(name(colour)), std::optional(colour));
    }
    for (const Representation representation : all_representations) {
        QCOMPARE(representation_from_name(name(representation)), std::optional(representation));
    }
    for (const StandardView view : all_standard_views) {
        QCOMPARE(standard_view_from_name(name(view)), std::optional(view));
    }
    QVERIFY(!colour_from_name("").has_value());
}

void SceneInputTest::ticks_are_round_and_in_the_range() {
    QCOMPARE(ticks({1, 1000}, true, 6), (std::vector<double>{1, 10, 100, 1000}));
    QCOMPARE(ticks({0, 1}, false, 6),
             (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1}));
    QCOMPARE(ticks({0.25, 4}, true, 6), (std::vector<double>{0.5, 1, 2}));
    for (const double value : ticks({3e-9, 2e4}, true, 6)) {
        QVERIFY(value >= 3e-9 && value <= 2e4);
    }
    QVERIFY(ticks({3e-9, 2e4}, true, 6).size() <= 8);
}

void SceneInputTest::lengths_of_scale_bars_are_round() {
    QCOMPARE(round_length(0.3), 0.2);
    QCOMPARE(round_length(7), 5.0);
    QCOMPARE(round_length(1.5e-7), 1e-7);
}

void SceneInputTest::numbers_are_short() {
    for (const auto& [value, text] :
         std::initializer_list<std::pair<double, const char*>>{{0, "0"},
                                                               {0.25, "0.25"},
                                                               {1, "1"},
                                                               {1000, "1000"},
                                                               {10000, "10000"},
                                                               {200000, "200000"},
                                                               {1e6, "1e6"},
                                                               {2.5e12, "2.5e12"},
                                                               {1e-5, "1e-5"},
                                                               {-3e-10, "-3e-10"},
                                                               {1.0 / 3, "0.3333"}}) {
        QCOMPARE(short_number(value), std::string(text));
    }
}

QTEST_APPLESS_MAIN(SceneInputTest)
#include "scene_input_test.moc"
