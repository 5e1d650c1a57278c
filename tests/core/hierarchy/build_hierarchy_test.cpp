// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/hierarchy/hierarchy_support.h"

#include <numeric>

#include <QtTest>

using namespace ameco;
using namespace ameco::test;

class BuildHierarchyTest : public QObject {
    Q_OBJECT
private slots:
    void makes_valid_levels_that_get_smaller();
    void describes_each_level_truly();
    void works_in_two_dimensions();
    void ends_when_the_mesh_cannot_be_coarsened();
    void takes_a_factor_per_level();
    void keeps_to_a_ratio();
    void ends_when_a_level_is_isotropic();
    void keeps_the_levels_it_has_when_stopped();
    void makes_the_same_levels_in_two_goes();
    void lets_the_trouble_of_the_sink_through();
};

namespace {

/// What holds of the statistics of any level, whatever the coarsener did.
template <int D>
void verify_statistics(const Collected<D>& made, std::size_t k) {
    const LevelStatistics& s = made.statistics[k];
    const Mesh<D>& mesh = made.levels[k].mesh;
    QCOMPARE(s.level, static_cast<int>(k));
    QCOMPARE(s.nodes, static_cast<std::int64_t>(mesh.points.size()));
    QCOMPARE(s.elements, static_cast<std::int64_t>(mesh.elements.size()));
    QCOMPARE(s.faces, static_cast<std::int64_t>(mesh.faces.size()));
    const CheckReport report = check(mesh);
    QVERIFY2(report.valid(), report.summary().c_str());
    QCOMPARE(s.volume, report.volume);
    QCOMPARE(std::accumulate(s.classes.counts.begin(), s.classes.counts.end(), std::int64_t{0}),
             s.nodes);
    QCOMPARE(s.classes.max, made.statistics[0].classes.max);
    QVERIFY(s.complexity > 0 && s.predicted_nodes > 0 && s.predicted_elements > 0);
    QVERIFY(s.conformity.edges > 0);
}

} // namespace

void BuildHierarchyTest::makes_valid_levels_that_get_smaller() {
    Collected<3> made;
    HierarchyOptions options;
    options.levels = 2;
    const HierarchyEnd end = build_hierarchy(small_mesh<3>(), options, made.sink());
    QCOMPARE(end.status, HierarchyStatus::complete);
    QVERIFY(!end.refused);
    QCOMPARE(made.levels.size(), std::size_t{3});
    for (std::size_t k = 0; k < 3; ++k) {
        verify_statistics(made, k);
        if (k > 0) {
            QVERIFY(made.statistics[k].ratio > options.min_ratio);
            QVERIFY(std::abs(made.statistics[k].volume - 1) < 1e-12);
        }
    }
}

void BuildHierarchyTest::describes_each_level_truly() {
    Collected<3> made;
    HierarchyOptions options;
    options.levels = 1;
    build_hierarchy(small_mesh<3>(), options, made.sink());
    QCOMPARE(made.statistics[0].ratio, 1.0);
    QCOMPARE(made.statistics[0].predicted_nodes, static_cast<double>(made.statistics[0].nodes));
    QCOMPARE(made.statistics[1].ratio, static_cast<double>(made.statistics[0].nodes) /
                                           static_cast<double>(made.statistics[1].nodes));
    QVERIFY(made.statistics[1].predicted_nodes < made.statistics[0].predicted_nodes);
    QCOMPARE(made.statistics[1].removal[Verdict::accepted],
             made.statistics[0].nodes - made.statistics[1].nodes);
    QVERIFY(made.timings[1].phases.total() > 0);
    QVERIFY(made.timings[1].peak_memory > 1'000'000);
}

void BuildHierarchyTest::works_in_two_dimensions() {
    Collected<2> made;
    HierarchyOptions options;
    options.levels = 2;
    build_hierarchy(small_mesh<2>(), options, made.sink());
    QCOMPARE(made.levels.size(), std::size_t{3});
    for (std::size_t k = 0; k < 3; ++k) {
        verify_statistics(made, k);
    }
}

void BuildHierarchyTest::ends_when_the_mesh_cannot_be_coarsened() {
    Mesh<3> mesh = std::get<Mesh<3>>(make_case("cube", {{"n", "1"}})); // its corners only
    const std::size_t nodes = mesh.points.size();
    Collected<3> made;
    const HierarchyEnd end = build_hierarchy(std::move(mesh), {}, made.sink());
    QCOMPARE(end.status, HierarchyStatus::exhausted);
    QCOMPARE(made.levels.size(), std::size_t{1});
    QVERIFY(end.refused.has_value());
    QCOMPARE(end.refused->nodes_after, static_cast<std::int64_t>(nodes));
}

void BuildHierarchyTest::takes_a_factor_per_level() {
    HierarchyOptions options;
    options.levels = 3;
    options.factors = {1.5, 3};
    Collected<2> made;
    build_hierarchy(small_mesh<2>(), options, made.sink());
    QCOMPARE(made.statistics.size(), std::size_t{4});
    QCOMPARE(made.statistics[1].factor, 1.5);
    QCOMPARE(made.statistics[2].factor, 3.0);
    QCOMPARE(made.statistics[3].factor, 3.0); // the last one goes on
}

void BuildHierarchyTest::keeps_to_a_ratio() {
    HierarchyOptions options;
    options.levels = 2;
    options.target_ratio = 1.8;
    Collected<2> made;
    build_hierarchy(
        std::get<Mesh<2>>(make_case(
            "layer",
            {{"dim", "2"}, {"nx", "32"}, {"nz", "24"}, {"growth", "1.3"}, {"aspect-ratio", "50"}})),
        options, made.sink());
    QCOMPARE(made.statistics.size(), std::size_t{3});
    QVERIFY2(std::abs(made.statistics[1].ratio / 1.8 - 1) <= 0.05,
             qPrintable(QString::number(made.statistics[1].ratio)));
    QVERIFY(made.statistics[1].factor != 2);
}

void BuildHierarchyTest::ends_when_a_level_is_isotropic() {
    const auto layer = [](const std::string& aspect_ratio) {
        return std::get<Mesh<2>>(make_case("layer", {{"dim", "2"},
                                                     {"nx", "24"},
                                                     {"nz", "32"},
                                                     {"growth", "1"},
                                                     {"aspect-ratio", aspect_ratio}}));
    };
    HierarchyOptions options;
    options.levels = 10;
    options.until_isotropic = true;
    Collected<2> made;
    const HierarchyEnd end = build_hierarchy(layer("16"), options, made.sink());
    QCOMPARE(end.status, HierarchyStatus::complete);
    QVERIFY(made.statistics.size() >= 3 && made.statistics.size() <= 5);
    for (std::size_t k = 0; k < made.statistics.size(); ++k) {
        const bool isotropic = made.statistics[k].aspect_ratio.share_isotropic >= isotropic_share;
        QCOMPARE(isotropic, k + 1 == made.statistics.size());
    }
    Collected<2> none; // isotropic from the start
    QCOMPARE(build_hierarchy(layer("1"), options, none.sink()).status, HierarchyStatus::complete);
    QCOMPARE(none.levels.size(), std::size_t{1});
}

void BuildHierarchyTest::keeps_the_levels_it_has_when_stopped() {
    HierarchyOptions options;
    options.levels = 2;
    Collected<3> whole;
    StopAt never(std::numeric_limits<int>::max());
    build_hierarchy(small_mesh<3>(), options, whole.sink(), never);
    QVERIFY2(never.asked() > 4, "the computation must ask whether to stop");
    for (const int question : {1, never.asked() / 2, never.asked()}) {
        StopAt monitor(question);
        Collected<3> made;
        const HierarchyEnd end = build_hierarchy(small_mesh<3>(), options, made.sink(), monitor);
        QCOMPARE(end.status, HierarchyStatus::cancelled);
        QVERIFY(made.levels.size() < whole.levels.size());
        for (std::size_t k = 0; k < made.levels.size(); ++k) {
            QVERIFY(made.levels[k].mesh == whole.levels[k].mesh);
        }
    }
}

void BuildHierarchyTest::makes_the_same_levels_in_two_goes() {
    HierarchyOptions options;
    options.levels = 3;
    Collected<3> whole;
    build_hierarchy(small_mesh<3>(), options, whole.sink());
    QVERIFY(whole.levels.size() >= 3);
    Collected<3> rest;
    extend_hierarchy(whole.levels[1], 1, whole.statistics[0].classes.max, options, rest.sink());
    QCOMPARE(rest.levels.size() + 2, whole.levels.size());
    for (std::size_t k = 0; k < rest.levels.size(); ++k) {
        QCOMPARE(rest.statistics[k].level, static_cast<int>(k) + 2);
        QVERIFY(rest.levels[k].mesh == whole.levels[k + 2].mesh);
        QVERIFY(rest.levels[k].natural == whole.levels[k + 2].natural);
    }
}

void BuildHierarchyTest::lets_the_trouble_of_the_sink_through() {
    const LevelSink<3> full_disk = [](const Level<3>&, const LevelStatistics&, const LevelTiming&) {
        throw FileError("disk full");
    };
    QVERIFY_THROWS_EXCEPTION(FileError, build_hierarchy(small_mesh<3>(), {}, full_disk));
}

QTEST_APPLESS_MAIN(BuildHierarchyTest)
#include "build_hierarchy_test.moc"
