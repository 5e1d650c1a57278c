// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/length_excess.h"

#include <QTest>

using namespace ameco;

class LengthExcessTest : public QObject {
    Q_OBJECT
private slots:
    void lengths_in_the_band_have_none_and_others_at_least_one() {
        for (const double l : {shortest_in_band, 0.8, 1.0, 1.3, longest_in_band}) {
            QCOMPARE(length_excess(l), 0.0);
        }
        for (const double l : {1e-9, 0.5, 0.7, 1.42, 3.0, 1e9}) {
            QVERIFY(length_excess(l) > 1);
        }
    }

    void it_is_the_same_for_a_length_and_its_inverse_and_grows_away_from_one() {
        double before = 0;
        for (double l = 1.01; l < 1e6; l *= 1.07) {
            const double excess = length_excess(l);
            QVERIFY(excess >= before);
            QVERIFY(std::abs(length_excess(1 / l) - excess) <= 1e-9 * (1 + excess));
            before = excess;
        }
    }
};

QTEST_APPLESS_MAIN(LengthExcessTest)
#include "length_excess_test.moc"
