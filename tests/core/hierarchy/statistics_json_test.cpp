// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/statistics_json.h"

#include "core/base/error.h"

#include <QTest>

#include <limits>

using namespace ameco;

namespace {

LevelStatistics example() {
    LevelStatistics s;
    s.level = 3;
    s.nodes = 1234567890123;
    s.elements = 6;
    s.faces = 4;
    s.factor = 2;
    s.ratio = 1.0 / 3;
    s.predicted_nodes = 0.1;
    s.predicted_elements = std::numeric_limits<double>::max();
    s.volume = std::numeric_limits<double>::denorm_min();
    s.complexity = 1e-9;
    s.aspect_ratio = {532713, 150.5, 8, 0.3, 0.05};
    s.classes.max = 532713;
    s.classes.counts = {1, 0, 3};
    s.conformity = {99, 0.8, 0.1, 0.15, 1e-3, 3, 0.7, 1e-12};
    s.deviation = 1e-7;
    s.deviation_relative = 0.01;
    s.lines = 3;
    s.line_nodes = 30;
    s.removal.add(Verdict::accepted);
    s.removal.add(Verdict::accepted);
    s.removal.add(Verdict::long_edge);
    s.swaps.add(Verdict::breaks_line);
    s.moves.add(Verdict::no_improvement);
    s.warnings = {{Defect::orphan_node, 2, "node 7 \"odd\"\n"}};
    return s;
}

LevelTiming timing() {
    LevelTiming t;
    t.level = 2;
    t.phases = {1.5, 2.25, 0.1, 0.2, 0.3, 0.4};
    t.statistics = 0.01;
    t.write = 0.02;
    t.transfer = 0.03;
    t.peak_memory = 1LL << 40;
    return t;
}

std::vector<std::string> keys_of(const Json& json) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) {
        keys.push_back(key);
    }
    return keys;
}

} // namespace

class StatisticsJsonTest : public QObject {
    Q_OBJECT
private slots:
    void statistics_survive_the_way_through_text() {
        const Json json = to_json(example());
        LevelStatistics read;
        from_json(Json::parse(json.dump()), read);
        QCOMPARE(read.nodes, example().nodes);
        QCOMPARE(read.ratio, 1.0 / 3);
        QCOMPARE(read.volume, std::numeric_limits<double>::denorm_min());
        QVERIFY(read.predicted_elements == std::numeric_limits<double>::max());
        QCOMPARE(read.conformity.above_two, 0.15);
        QCOMPARE(read.removal[Verdict::accepted], std::int64_t{2});
        QCOMPARE(read.swaps[Verdict::breaks_line], std::int64_t{1});
        QCOMPARE(read.moves[Verdict::no_improvement], std::int64_t{1});
        QVERIFY(read.classes.counts == example().classes.counts);
        QCOMPARE(read.warnings.at(0).example, std::string("node 7 \"odd\"\n"));
        QVERIFY(to_json(read) == json); // and whatever was not named here
    }

    void timings_survive_the_way_through_text() {
        const Json json = to_json(timing());
        LevelTiming read;
        from_json(Json::parse(json.dump()), read);
        QVERIFY(to_json(read) == json);
        QCOMPARE(read.peak_memory, timing().peak_memory);
        QCOMPARE(read.phases.swap, timing().phases.swap);
        QVERIFY(std::abs(json.at("seconds").at("total").get<double>() - timing().total()) < 1e-12);
    }

    void repairs_survive_the_way_through_text() {
        const BoundaryRepair repair{1, 2, true, 3, 4};
        const Json json = to_json(repair);
        BoundaryRepair read;
        from_json(Json::parse(json.dump()), read);
        QVERIFY(to_json(read) == json);
        QVERIFY(read.elements_turned);
    }

    void keys_keep_their_order() {
        QCOMPARE(
            keys_of(to_json(example().conformity)),
            (std::vector<std::string>{"edges", "in_band", "below_half", "above_two", "shortest",
                                      "longest", "mean_quality", "worst_quality"}));
        QCOMPARE(keys_of(to_json(example())).front(), std::string("level"));
        QCOMPARE(keys_of(to_json(example())).back(), std::string("warnings"));
    }

    void verdicts_are_those_that_occurred_by_name() {
        QVERIFY(to_json(VerdictCounts{}).is_object() && to_json(VerdictCounts{}).empty());
        const Json json = to_json(example().removal);
        QCOMPARE(keys_of(json), (std::vector<std::string>{std::string(name(Verdict::accepted)),
                                                          std::string(name(Verdict::long_edge))}));
    }

    void every_verdict_and_defect_has_a_name_of_its_own() {
        LevelStatistics s = example();
        s.warnings.clear();
        for (std::size_t i = 0; i < verdict_count; ++i) {
            s.removal.counts[i] = static_cast<std::int64_t>(i) + 1;
        }
        for (int i = 0; i <= static_cast<int>(Defect::volumes_do_not_add_up); ++i) {
            s.warnings.push_back({static_cast<Defect>(i), i, ""});
        }
        LevelStatistics read;
        from_json(to_json(s), read);
        QVERIFY(read.removal.counts == s.removal.counts);
        for (std::size_t i = 0; i < s.warnings.size(); ++i) {
            QCOMPARE(read.warnings.at(i).defect, s.warnings[i].defect);
        }
    }

    void a_name_that_does_not_exist_is_refused() {
        Json json = to_json(example());
        json["verdicts"]["removal"]["tired"] = 7;
        LevelStatistics read;
        QVERIFY_THROWS_EXCEPTION(InputError, from_json(json, read));
        json = to_json(example());
        json["warnings"][0]["defect"] = "tired";
        QVERIFY_THROWS_EXCEPTION(InputError, from_json(json, read));
    }

    void a_value_that_is_missing_or_of_another_kind_is_refused() {
        const Json whole = to_json(example());
        for (const std::string& key : keys_of(whole)) {
            Json json = whole;
            json.erase(key);
            LevelStatistics read;
            QVERIFY_THROWS_EXCEPTION(Json::exception, from_json(json, read));
            json[key] = "seven";
            QVERIFY_THROWS_EXCEPTION(Json::exception, from_json(json, read));
        }
    }
};

QTEST_APPLESS_MAIN(StatisticsJsonTest)
#include "statistics_json_test.moc"
