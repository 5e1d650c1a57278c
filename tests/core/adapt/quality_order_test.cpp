// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/quality_order.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <vector>

using namespace ameco;

namespace {

using Set = std::vector<float>;

/// Few values and sizes: ties are common.
Set random_set(std::mt19937& random) {
    Set set(random() % 5);
    for (float& q : set) {
        q = static_cast<float>(random() % 3) / 2;
    }
    std::sort(set.begin(), set.end());
    return set;
}

Set united(const Set& a, const Set& b) {
    Set out;
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
    return out;
}

} // namespace

class QualityOrderTest : public QObject {
    Q_OBJECT
private slots:
    void sets_are_compared_from_the_worst_up_data() {
        QTest::addColumn<Set>("worse");
        QTest::addColumn<Set>("better");
        QTest::newRow("worst element") << Set{0.1F, 0.9F} << Set{0.2F, 0.3F};
        QTest::newRow("second after a tie") << Set{0.1F, 0.2F, 0.9F} << Set{0.1F, 0.3F, 0.4F};
        QTest::newRow("sizes differ") << Set{0.1F} << Set{0.2F, 0.2F, 0.2F};
        QTest::newRow("the worst one is there twice") << Set{0.1F, 0.1F, 0.9F} << Set{0.1F, 0.2F};
        QTest::newRow("one more after ties") << Set{0.1F, 0.5F} << Set{0.1F};
        QTest::newRow("something and nothing") << Set{1.0F} << Set{};
    }
    void sets_are_compared_from_the_worst_up() {
        QFETCH(Set, worse);
        QFETCH(Set, better);
        QVERIFY(is_worse(worse, better));
        QVERIFY(!is_worse(better, worse));
    }

    void of_two_sets_one_is_worse_unless_they_are_equal() {
        std::mt19937 random(1);
        for (int n = 0; n < 2000; ++n) {
            const Set a = random_set(random), b = random_set(random);
            QCOMPARE(int(is_worse(a, b)) + int(is_worse(b, a)), a == b ? 0 : 1);
        }
    }

    void the_order_is_transitive() {
        std::mt19937 random(2);
        int chains = 0;
        for (int n = 0; n < 5000; ++n) {
            const Set a = random_set(random), b = random_set(random), c = random_set(random);
            if (is_worse(a, b) && is_worse(b, c)) {
                QVERIFY(is_worse(a, c));
                ++chains;
            }
        }
        QVERIFY(chains > 100);
    }

    /// What makes a cavity better makes the mesh better.
    void the_same_elements_in_both_do_not_change_it() {
        std::mt19937 random(3);
        for (int n = 0; n < 2000; ++n) {
            const Set a = random_set(random), b = random_set(random), more = random_set(random);
            QCOMPARE(is_worse(united(a, more), united(b, more)), is_worse(a, b));
        }
    }
};

QTEST_APPLESS_MAIN(QualityOrderTest)
#include "quality_order_test.moc"
