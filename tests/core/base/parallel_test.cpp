// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/parallel.h"

#include "core/base/error.h"

#include <QTest>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

using namespace ameco;

class ParallelTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { set_thread_count(0); }

    void visits_every_item_once_data();
    void visits_every_item_once();
    void cuts_the_same_pieces_for_any_number_of_threads();
    void begins_pieces_in_order();
    void gives_the_same_sum_for_any_number_of_threads();
    void hands_exceptions_to_the_caller();
    void remembers_the_number_of_threads();
};

void ParallelTest::visits_every_item_once_data() {
    QTest::addColumn<int>("threads");
    QTest::addColumn<int>("items");
    QTest::addColumn<int>("grain");
    for (const int threads : {0, 1, 2, 5}) {
        for (const int items : {0, 1, 7, 100, 1000}) {
            for (const int grain : {1, 7, 100, 5000}) {
                QTest::addRow("%d threads, %d items, grain %d", threads, items, grain)
                    << threads << items << grain;
            }
        }
    }
}

void ParallelTest::visits_every_item_once() {
    QFETCH(int, threads);
    QFETCH(int, items);
    QFETCH(int, grain);
    set_thread_count(threads);
    std::vector<int> visits(static_cast<std::size_t>(items), 0);
    parallel_for(visits.size(), static_cast<std::size_t>(grain),
                 [&](std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) {
                         ++visits[i];
                     }
                 });
    for (const int count : visits) {
        QCOMPARE(count, 1);
    }
}

void ParallelTest::cuts_the_same_pieces_for_any_number_of_threads() {
    const auto pieces = [](int threads) {
        set_thread_count(threads);
        std::mutex mutex;
        std::set<std::pair<std::size_t, std::size_t>> seen;
        parallel_for(103, 10, [&](std::size_t begin, std::size_t end) {
            const std::lock_guard lock(mutex);
            seen.emplace(begin, end);
        });
        return seen;
    };
    const auto one = pieces(1);
    QCOMPARE(one.size(), std::size_t{11});
    QVERIFY(one.contains({100, 103}));
    QVERIFY(pieces(2) == one);
    QVERIFY(pieces(8) == one);
}

void ParallelTest::begins_pieces_in_order() {
    set_thread_count(3);
    std::mutex mutex;
    std::map<std::thread::id, std::vector<std::size_t>> begun;
    parallel_for(5000, 1, [&](std::size_t begin, std::size_t) {
        const std::lock_guard lock(mutex);
        begun[std::this_thread::get_id()].push_back(begin);
    });
    for (const auto& [thread, pieces] : begun) {
        QVERIFY(std::is_sorted(pieces.begin(), pieces.end()));
    }
}

void ParallelTest::gives_the_same_sum_for_any_number_of_threads() {
    const auto sum = [](int threads) {
        set_thread_count(threads);
        std::vector<double> partial(1000);
        parallel_for(1000000, 1000, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                partial[begin / 1000] += std::sqrt(static_cast<double>(i));
            }
        });
        double total = 0;
        for (const double p : partial) {
            total += p;
        }
        return total;
    };
    const double one = sum(1);
    QVERIFY(one == sum(2)); // to the bit
    QVERIFY(one == sum(3));
    QVERIFY(std::abs(one / (2.0 / 3 * 1e9) - 1) < 1e-5);
}

void ParallelTest::hands_exceptions_to_the_caller() {
    for (const int threads : {1, 2}) {
        set_thread_count(threads);
        QVERIFY_THROWS_EXCEPTION(Cancelled, parallel_for(100, 1, [](std::size_t i, std::size_t) {
                                     if (i == 37) {
                                         throw Cancelled();
                                     }
                                 }));
    }
}

void ParallelTest::remembers_the_number_of_threads() {
    set_thread_count(3);
    QCOMPARE(thread_count(), 3);
    set_thread_count(0);
    QVERIFY(thread_count() >= 1);
    set_thread_count(-4);
    QVERIFY(thread_count() >= 1);
}

QTEST_APPLESS_MAIN(ParallelTest)
#include "parallel_test.moc"
