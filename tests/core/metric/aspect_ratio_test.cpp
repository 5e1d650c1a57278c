// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/aspect_ratio.h"

#include <QTest>

#include <numeric>

using namespace ameco;

namespace {

/// A field with the given aspect ratios.
MetricField<3> field_of(const std::vector<double>& ratios) {
    MetricField<3> field(ratios.size());
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        field[NodeId(i)].sizes = Vec<3>(1, 1, ratios[i]); // exact, so that class edges are as well
    }
    return field;
}

using Counts = std::vector<std::int64_t>;

} // namespace

class AspectRatioTest : public QObject {
    Q_OBJECT
private slots:
    void classes_are_closed_above_and_open_below();
    void the_last_class_contains_one_data();
    void the_last_class_contains_one();
    void nodes_above_a_given_maximum_are_in_the_first_class();
    void class_edges_are_those_of_the_falcon_table();
    void an_isotropic_field_has_one_class();
    void a_summary_counts_shares_and_quantiles();
    void the_summary_of_no_nodes_is_isotropic();
};

void AspectRatioTest::classes_are_closed_above_and_open_below() {
    const auto classes = classify_aspect_ratios<3>(field_of({8, 4.0001, 4, 3, 2, 1.5, 1, 1}));
    QCOMPARE(classes.max, 8.0);
    QVERIFY((classes.counts == Counts{2, 2, 2, 2}));
    QCOMPARE(classes.upper(1), 4.0);
    QCOMPARE(classes.lower(1), 2.0);
}

void AspectRatioTest::the_last_class_contains_one_data() {
    QTest::addColumn<double>("max");
    QTest::addColumn<int>("classes");
    QTest::newRow("1") << 1.0 << 1;
    QTest::newRow("1.9") << 1.9 << 1;
    QTest::newRow("2") << 2.0 << 2;
    QTest::newRow("10") << 10.0 << 4;
    QTest::newRow("532713 (Falcon)") << 532713.0 << 20;
}

void AspectRatioTest::the_last_class_contains_one() {
    QFETCH(const double, max);
    QFETCH(const int, classes);
    const auto found = classify_aspect_ratios<3>(field_of({max, 1}));
    QCOMPARE(found.counts.size(), static_cast<std::size_t>(classes));
    const std::size_t last = found.counts.size() - 1;
    QCOMPARE_LT(found.lower(last), 1.0);
    QCOMPARE_GE(found.upper(last), 1.0);
    QCOMPARE_GE(found.counts[last], 1);
}

void AspectRatioTest::nodes_above_a_given_maximum_are_in_the_first_class() {
    const auto classes = classify_aspect_ratios<3>(field_of({100, 9, 7, 1}), 8);
    QCOMPARE(classes.max, 8.0);
    QVERIFY((classes.counts == Counts{3, 0, 0, 1}));
}

void AspectRatioTest::class_edges_are_those_of_the_falcon_table() {
    // Paper, Table 3: classes 5 and 16, counted from 1.
    const auto classes = classify_aspect_ratios<3>(field_of({532713.0, 1}));
    QCOMPARE_LE(std::abs(classes.upper(4) - 33294.562), 0.001);
    QCOMPARE_LE(std::abs(classes.lower(4) - 16647.281), 0.001);
    QCOMPARE_LE(std::abs(classes.upper(15) - 16.257), 0.001);
    QCOMPARE_LE(std::abs(classes.lower(15) - 8.128), 0.001);
}

void AspectRatioTest::an_isotropic_field_has_one_class() {
    const auto classes = classify_aspect_ratios<3>(field_of({1, 1, 1}));
    QVERIFY((classes.counts == Counts{3}));
}

void AspectRatioTest::a_summary_counts_shares_and_quantiles() {
    std::vector<double> ratios(100);
    std::iota(ratios.rbegin(), ratios.rend(), 101.0); // 101 ... 200
    ratios[7] = 4.99;
    ratios[8] = 5;
    const auto summary = summarise_aspect_ratios<3>(field_of(ratios));
    QCOMPARE(summary.max, 200.0);
    QCOMPARE(summary.share_isotropic, 0.01);
    const auto above = [&](double bound) {
        return std::count_if(ratios.begin(), ratios.end(), [&](double r) { return r > bound; });
    };
    QCOMPARE(above(summary.top_5_percent), 5);
    QCOMPARE(above(summary.median), 50);
    QCOMPARE(summary.share_above_150, static_cast<double>(above(150)) / 100);
}

void AspectRatioTest::the_summary_of_no_nodes_is_isotropic() {
    const auto summary = summarise_aspect_ratios<3>(MetricField<3>());
    QCOMPARE(summary.max, 1.0);
    QCOMPARE(summary.share_isotropic, 1.0);
}

QTEST_APPLESS_MAIN(AspectRatioTest)
#include "aspect_ratio_test.moc"
