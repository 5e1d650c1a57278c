// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/box_tree.h"

#include "core/cases/random.h"

#include <QTest>

#include <limits>
#include <set>

using namespace ameco;

namespace {

template <int D>
Vec<D> random_point(std::uint64_t seed, std::uint64_t i) {
    Vec<D> p;
    for (int k = 0; k < D; ++k) {
        p[k] = random_signed({seed, i, static_cast<std::uint64_t>(k)});
    }
    return p;
}

/// Boxes of all sizes, some of them flat, some equal.
template <int D>
std::vector<Box<D>> random_boxes(std::size_t n, std::uint64_t seed) {
    std::vector<Box<D>> boxes;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec<D> a = random_point<D>(seed, i / 2 * 2);
        Vec<D> size = random_point<D>(seed + 1, i / 2 * 2).cwiseAbs() * (i % 8 < 4 ? 0.01 : 0.5);
        size[0] = i % 6 < 2 ? 0 : size[0];
        Box<D> box(a);
        box.extend(a + size);
        boxes.push_back(box);
    }
    return boxes;
}

} // namespace

class BoxTreeTest : public QObject {
    Q_OBJECT

    template <int D>
    static void find_what_brute_force_finds(std::size_t n) {
        const auto boxes = random_boxes<D>(n, n);
        const BoxTree<D> tree(boxes);
        for (std::uint64_t i = 0; i < 200; ++i) {
            // Also corners of boxes, which belong to them.
            const Vec<D> p =
                i % 4 == 0 && n > 0 ? Vec<D>(boxes[i % n].max()) : random_point<D>(7, i);
            std::set<std::int32_t> expected, found;
            for (std::size_t k = 0; k < n; ++k) {
                if (boxes[k].contains(p)) {
                    expected.insert(static_cast<std::int32_t>(k));
                }
            }
            std::size_t visits = 0;
            QCOMPARE(tree.find(p,
                               [&](std::int32_t item) {
                                   ++visits;
                                   if (boxes[static_cast<std::size_t>(item)].contains(p)) {
                                       found.insert(item);
                                   }
                                   return false;
                               }),
                     -1);
            QVERIFY(found == expected);
            QVERIFY(visits <= n);
        }
    }

    template <int D>
    static void find_the_nearest(std::size_t n) {
        const auto boxes = random_boxes<D>(n, n + 1);
        const BoxTree<D> tree(boxes);
        for (std::uint64_t i = 0; i < 200; ++i) {
            const Vec<D> p = 3 * random_point<D>(8, i);
            const auto distance = [&](std::int32_t item) {
                return boxes[static_cast<std::size_t>(item)].exteriorDistance(p);
            };
            std::int32_t expected = -1;
            double least = std::numeric_limits<double>::infinity();
            for (std::int32_t k = 0; k < static_cast<std::int32_t>(n); ++k) {
                if (distance(k) < least) {
                    least = distance(k);
                    expected = k;
                }
            }
            QCOMPARE(tree.nearest(p, distance), expected);
            const auto guess = static_cast<std::int32_t>(i % n);
            QCOMPARE(tree.nearest(p, distance, guess), expected);
        }
    }

private slots:
    void every_box_that_holds_a_point_is_visited() {
        for (const std::size_t n : {1, 2, 5, 40, 300}) {
            find_what_brute_force_finds<2>(n);
            find_what_brute_force_finds<3>(n);
        }
    }

    void the_search_ends_with_the_first_item_that_is_taken() {
        const auto boxes = random_boxes<2>(100, 3);
        const BoxTree<2> tree(boxes);
        const Vec<2> p = boxes[17].center();
        const std::int32_t found =
            tree.find(p, [&](std::int32_t item) { return item == 16 || item == 17; });
        QVERIFY(found == 16 || found == 17); // the two are equal
    }

    void the_nearest_item_is_that_of_brute_force() {
        for (const std::size_t n : {1, 3, 50, 300}) {
            find_the_nearest<2>(n);
            find_the_nearest<3>(n);
        }
    }

    /// A distance may be larger than that to the box.
    void the_distance_to_what_is_in_a_box_decides() {
        std::vector<Box<2>> boxes{Box<2>(Vec<2>(0, 0)), Box<2>(Vec<2>(1, 0))};
        boxes[0].extend(Vec<2>(0.5, 1));
        const BoxTree<2> tree(boxes);
        const auto far_in_the_first = [](std::int32_t item) { return item == 0 ? 0.9 : 0.8; };
        QCOMPARE(tree.nearest(Vec<2>(0.2, 0), far_in_the_first), 1);
    }

    void of_equal_distances_the_smallest_number_wins() {
        const std::vector<Box<3>> boxes(50, Box<3>(Vec<3>(1, 2, 3)));
        const BoxTree<3> tree(boxes);
        QCOMPARE(tree.nearest(Vec<3>::Zero(), [](std::int32_t) { return 5.0; }), 0);
    }

    void items_are_visited_where_the_test_lets_the_search_enter() {
        const auto boxes = random_boxes<3>(200, 5);
        const BoxTree<3> tree(boxes);
        const Box<3> window(Vec<3>(-0.2, -0.3, -0.4), Vec<3>(0.1, 0.2, 0.3));
        std::multiset<std::int32_t> visited;
        tree.visit([&](const Box<3>& box) { return box.intersects(window); },
                   [&](std::int32_t item) { visited.insert(item); });
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            const auto item = static_cast<std::int32_t>(k);
            QVERIFY(visited.count(item) <= 1);
            QVERIFY(!boxes[k].intersects(window) || visited.count(item) == 1);
        }
        QVERIFY(visited.size() < boxes.size());
    }

    void an_empty_tree_has_nothing() {
        const BoxTree<2> tree({});
        QCOMPARE(tree.find(Vec<2>(0, 0), [](std::int32_t) { return true; }), -1);
        QCOMPARE(tree.nearest(Vec<2>(0, 0), [](std::int32_t) { return 0.0; }), -1);
        tree.visit([](const Box<2>&) { return true; },
                   [](std::int32_t) { QFAIL("there is no item"); });
    }
};

QTEST_APPLESS_MAIN(BoxTreeTest)
#include "box_tree_test.moc"
