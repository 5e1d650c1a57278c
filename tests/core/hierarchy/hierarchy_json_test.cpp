// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/hierarchy_json.h"

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <QtTest>

using namespace ameco;
using Json = nlohmann::ordered_json;

class HierarchyJsonTest : public QObject {
    Q_OBJECT
private slots:
    void is_the_same_after_writing_and_reading_it();
    void keeps_every_digit();
    void sums_up_the_levels();
    void names_what_is_wrong_with_a_file_data();
    void names_what_is_wrong_with_a_file();
    void survives_any_change_of_one_value();
    void says_which_settings_differ();
    void keeps_timings();
};

namespace {

HierarchyLevel level(int k) {
    HierarchyLevel l;
    l.mesh = {k == 0 ? "../wing.meshb" : "level_1.meshb", 0x1234u + static_cast<unsigned>(k)};
    l.metric = {"metric_" + std::to_string(k) + ".solb", 0xffffffffffffffffu};
    if (k > 0) {
        l.state = {"state_1.cbor", 7};
    }
    LevelStatistics& s = l.statistics;
    s.level = k;
    s.nodes = 1000 >> k;
    s.elements = 6000 >> k;
    s.faces = 40;
    s.factor = 2.25;
    s.ratio = 1.0 / 3;
    s.predicted_nodes = 411.1;
    s.predicted_elements = 2500.25;
    s.volume = 0.1;
    s.complexity = 1e-9;
    s.aspect_ratio = {532713, 150.5, 8, 0.3, 0.05};
    s.classes.max = 532713;
    s.classes.counts = {1, 2, 3};
    s.conformity = {99, 0.8, 0.1, 0.1, 1e-3, 3, 0.7, 1e-12};
    s.deviation = 1e-7;
    s.deviation_relative = 0.01;
    s.lines = 3;
    s.line_nodes = 30;
    s.removal.add(Verdict::accepted);
    s.removal.add(Verdict::region_border);
    s.swaps.add(Verdict::breaks_line);
    s.warnings = {{Defect::orphan_node, 2, "node 7 \"odd\""}};
    return l;
}

Hierarchy example() {
    Hierarchy h;
    h.program = "ameco 0.1.0";
    h.dimension = 3;
    h.mesh_suffix = ".mesh";
    h.export_format = "su2";
    h.export_suffix = ".su2";
    h.status = HierarchyStatus::exhausted;
    h.options.levels = 5;
    h.options.coarsen.mean = Mean::log_euclidean;
    h.options.coarsen.target.algorithm = TargetAlgorithm::graded;
    h.options.coarsen.target.gradation = 1.25;
    h.options.coarsen.target.factor = 2.5;
    h.options.factors = {2.5, 3};
    h.options.target_ratio = 2.125;
    h.options.until_isotropic = true;
    h.options.rebuild = true;
    h.options.coarsen.features.frozen_patches = {1, 4};
    h.options.coarsen.features.boundary = BoundaryChoice::keep;
    h.options.coarsen.nodes = CoarseNodes::moved;
    h.input.file = {"../wing.meshb", 0x1234u};
    h.input.format = "Medit binary, version 2";
    h.input.repair = {1, 2, true, 3, 4};
    h.levels = {level(0), level(1)};
    h.levels[1].exports = {{"level_1.su2", 0x77u}};
    return h;
}

} // namespace

void HierarchyJsonTest::is_the_same_after_writing_and_reading_it() {
    const std::string text = hierarchy_text(example());
    const Hierarchy read = parse_hierarchy(text, "hierarchy.json");
    QCOMPARE(hierarchy_text(read), text);
    QCOMPARE(read.status, HierarchyStatus::exhausted);
    QCOMPARE(read.levels.size(), std::size_t{2});
    QVERIFY(read.levels[1].state == example().levels[1].state);
    QVERIFY(read.levels[1].exports == example().levels[1].exports);
    QCOMPARE(read.levels[1].statistics.warnings.at(0).defect, Defect::orphan_node);
    QCOMPARE(read.levels[1].statistics.removal[Verdict::region_border], std::int64_t{1});
    QCOMPARE(read.options.coarsen.mean, Mean::log_euclidean);
    QCOMPARE(read.options.factors, (std::vector<double>{2.5, 3}));
    QCOMPARE(read.options.target_ratio, 2.125);
    QVERIFY(read.options.until_isotropic);
    QVERIFY(read.options.rebuild);
    QCOMPARE(read.options.coarsen.features.boundary, BoundaryChoice::keep);
    QVERIFY(read.options.coarsen.nodes == CoarseNodes::moved);
    QCOMPARE(read.levels[1].statistics.factor, 2.25);
    QCOMPARE(read.options.coarsen.target.algorithm, TargetAlgorithm::graded);
    QCOMPARE(read.options.coarsen.target.gradation, 1.25);
    QVERIFY(read.input.repair.elements_turned);
}

void HierarchyJsonTest::keeps_every_digit() {
    Hierarchy h = example();
    h.levels[0].statistics.ratio = 0.1 + 0.2;
    const Hierarchy read = parse_hierarchy(hierarchy_text(h), "hierarchy.json");
    QVERIFY(read.levels[0].statistics.ratio == h.levels[0].statistics.ratio);
}

void HierarchyJsonTest::sums_up_the_levels() {
    QCOMPARE(grid_complexity(example()), 1.5);
    QCOMPARE(element_complexity(example()), 1.5);
    QCOMPARE(grid_complexity(Hierarchy()), 0.0);
}

void HierarchyJsonTest::names_what_is_wrong_with_a_file_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("complaint");
    const auto changed = [](const char* pointer, const Json& value) {
        Json json = Json::parse(hierarchy_text(example()));
        json[Json::json_pointer(pointer)] = value;
        return QString::fromStdString(json.dump());
    };
    QTest::newRow("not JSON") << "Ameco"
                              << "damaged";
    QTest::newRow("empty") << ""
                           << "damaged";
    QTest::newRow("cut off") << QString::fromStdString(hierarchy_text(example())).left(500)
                             << "damaged";
    QTest::newRow("another program's") << "{\"schema\": \"x\"}"
                                       << "not an ameco hierarchy";
    QTest::newRow("newer") << changed("/schema_version", 2) << "schema version is 2";
    QTest::newRow("dimension") << changed("/dimension", 4) << "dimension";
    QTest::newRow("status") << changed("/status", "odd") << "status \"odd\"";
    QTest::newRow("level number") << changed("/levels/1/level", 3) << "level 3";
    QTest::newRow("no nodes") << changed("/levels/1/nodes", 0) << "level 1 has no mesh";
    QTest::newRow("hash") << changed("/levels/0/mesh/hash", "12") << "content hash";
    QTest::newRow("type") << changed("/levels/0/ratio", "two") << "damaged";
}

void HierarchyJsonTest::names_what_is_wrong_with_a_file() {
    QFETCH(QString, text);
    QFETCH(QString, complaint);
    try {
        (void)parse_hierarchy(text.toStdString(), "out/hierarchy.json");
        QFAIL("no exception");
    } catch (const InputError& error) {
        const QString what = error.what();
        QVERIFY2(what.startsWith("out/hierarchy.json: "), qPrintable(what));
        QVERIFY2(what.contains(complaint), qPrintable(what));
    }
}

void HierarchyJsonTest::survives_any_change_of_one_value() {
    const Json flat = Json::parse(hierarchy_text(example())).flatten();
    for (const auto& item : flat.items()) {
        for (const Json& value : {Json(), Json(-1), Json("x"), Json::array()}) {
            Json changed = flat;
            if (value.is_array()) {
                changed.erase(item.key());
            } else {
                changed[item.key()] = value;
            }
            try {
                (void)parse_hierarchy(changed.unflatten().dump(), "hierarchy.json");
            } catch (const InputError&) {
                continue; // the only exception there may be
            } catch (const Json::exception&) {
                continue; // a gap in an array, which the test itself cannot unflatten
            }
        }
    }
}

void HierarchyJsonTest::says_which_settings_differ() {
    const Hierarchy a = example();
    Hierarchy b = a;
    b.options.levels = 9; // more levels of the same hierarchy
    QCOMPARE(different_settings(a, b), std::string());
    b.options.coarsen.target.factor = 3;
    b.options.coarsen.features.frozen_patches.clear();
    b.options.coarsen.features.boundary = BoundaryChoice::coarsen;
    QCOMPARE(different_settings(a, b), std::string("factor, frozen_patches, boundary"));
}

void HierarchyJsonTest::keeps_timings() {
    LevelTiming timing;
    timing.level = 1;
    timing.phases.swap = 1.5;
    timing.write = 0.25;
    timing.peak_memory = 123456789;
    const auto read = parse_timing(timing_text({timing}, 2), "timing.json");
    QCOMPARE(read.size(), std::size_t{1});
    QCOMPARE(read[0].total(), 1.75);
    QCOMPARE(read[0].peak_memory, timing.peak_memory);
}

QTEST_APPLESS_MAIN(HierarchyJsonTest)
#include "hierarchy_json_test.moc"
