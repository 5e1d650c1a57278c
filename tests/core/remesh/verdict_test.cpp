// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/verdict.h"

#include <QTest>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

using namespace ameco;

class VerdictTest : public QObject {
    Q_OBJECT
private slots:
    void every_verdict_has_a_name_of_its_own();
    void counts_each_verdict_by_itself();
};

void VerdictTest::every_verdict_has_a_name_of_its_own() {
    QCOMPARE(static_cast<std::size_t>(Verdict::soft_element) + 1, verdict_count);
    std::set<std::string> names;
    for (std::size_t i = 0; i < verdict_count; ++i) {
        const std::string text(name(static_cast<Verdict>(i)));
        QVERIFY(!text.empty());
        QVERIFY2(names.insert(text).second, text.c_str());
    }
    QCOMPARE(name(Verdict::accepted), std::string_view("accepted"));
    QCOMPARE(name(Verdict::region_border), std::string_view("region border"));
}

void VerdictTest::counts_each_verdict_by_itself() {
    VerdictCounts counts;
    counts.add(Verdict::gap);
    counts.add(Verdict::region_border);
    counts.add(Verdict::gap);
    QCOMPARE(counts[Verdict::gap], 2);
    QCOMPARE(counts[Verdict::region_border], 1);
    QCOMPARE(std::accumulate(counts.counts.begin(), counts.counts.end(), std::int64_t{0}), 3);
}

QTEST_APPLESS_MAIN(VerdictTest)
#include "verdict_test.moc"
