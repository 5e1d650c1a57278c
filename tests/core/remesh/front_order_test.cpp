// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/front_order.h"

#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

#include <cmath>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

template <int D>
FrontOrder order_of(const Mesh<D>& mesh) {
    return front_order(mesh, nodal_metric(mesh), node_neighbours(mesh));
}

constexpr int layers = 10;

/// Largest and smallest key of each layer over the layer's number; nodes are stored by layers.
template <int D>
std::pair<double, double> key_over_layer(const Mesh<D>& mesh) {
    const FrontOrder front = order_of(mesh);
    const std::size_t columns = mesh.points.size() / (layers + 1);
    double low = INFINITY, high = 0;
    for (const NodeId v : mesh.points.ids()) {
        const std::size_t layer = v.index() / columns;
        if (layer > 0) {
            const double ratio = front.key[v] / static_cast<double>(layer);
            low = std::min(low, ratio);
            high = std::max(high, ratio);
        }
    }
    return {low, high};
}

/// Paths lean on the cheaper end and on slanting edges, so a layer costs less than 1; at corners of
/// a box, where a node has one element or two, least of all.
template <int D>
void count_layers(const Mesh<D>& mesh) {
    const auto [low, high] = key_over_layer(mesh);
    QCOMPARE_GE(low, 0.2);
    QCOMPARE_LE(high, 1.0);
}

/// A layer whose top is not flat enough to be a wall: its last cells are as high as wide.
template <int D>
Mesh<D> layer_with_open_top(double first) {
    std::vector<double> z = shapes::geometric(layers - 1, first, 1.2);
    z.push_back(z.back() + 0.3);
    if constexpr (D == 2) {
        return shapes::rectangle(shapes::uniform(4), z);
    } else {
        return shapes::box(shapes::uniform(3), shapes::uniform(3), z);
    }
}

template <int D>
void compare_with_shuffled(const Mesh<D>& mesh) {
    const Mesh<D> other = shapes::shuffled(mesh, 9);
    const FrontOrder a = order_of(mesh), b = order_of(other);
    std::map<std::array<double, D>, double> key;
    for (const NodeId v : mesh.points.ids()) {
        key[key_of<D>(mesh.points[v])] = a.key[v];
    }
    for (const NodeId v : other.points.ids()) {
        // Sums over balls are taken in another order.
        const double expected = key.at(key_of<D>(other.points[v]));
        QCOMPARE_LE(std::abs(b.key[v] - expected), 1e-9 * (1 + expected));
    }
}

template <int D>
void verify_order(const Mesh<D>& mesh) {
    const FrontOrder front = order_of(mesh);
    QCOMPARE(front.order.size(), mesh.points.size());
    std::vector<NodeId> sorted_order = front.order;
    std::sort(sorted_order.begin(), sorted_order.end());
    for (std::size_t i = 0; i < sorted_order.size(); ++i) {
        QCOMPARE(sorted_order[i].index(), i);
    }
    for (std::size_t i = 0; i + 1 < front.order.size(); ++i) {
        QVERIFY(std::pair(front.key[front.order[i]], front.order[i]) <
                std::pair(front.key[front.order[i + 1]], front.order[i + 1]));
    }
    QCOMPARE(front.key[front.order.front()], 0.0);
}

} // namespace

class FrontOrderTest : public QObject {
    Q_OBJECT
private slots:
    void keys_count_layers_at_any_aspect_ratio_data();
    void keys_count_layers_at_any_aspect_ratio();
    void layers_of_displaced_columns_follow_each_other();
    void both_walls_of_a_channel_are_seeds();
    void without_walls_the_whole_boundary_is_the_seed();
    void the_order_is_a_permutation_by_key();
    void does_not_depend_on_the_numbering();
};

void FrontOrderTest::keys_count_layers_at_any_aspect_ratio_data() {
    QTest::addColumn<double>("first_height");
    for (const double h : {1e-3, 1e-5, 1e-7, 1e-9}) {
        QTest::addRow("%g", h) << h;
    }
}

void FrontOrderTest::keys_count_layers_at_any_aspect_ratio() {
    QFETCH(double, first_height);
    count_layers(layer_with_open_top<2>(first_height));
    count_layers(layer_with_open_top<3>(first_height));
    // Nor does the factor itself: it is that of moderate heights.
    const auto reference = key_over_layer(layer_with_open_top<3>(1e-6));
    const auto here = key_over_layer(layer_with_open_top<3>(first_height));
    QCOMPARE_LE(std::abs(here.first - reference.first), 0.02);
    QCOMPARE_LE(std::abs(here.second - reference.second), 0.02);
}

void FrontOrderTest::layers_of_displaced_columns_follow_each_other() {
    for (const double ratio : {1e4, 1e6}) {
        const Mesh<3> mesh = make_layer<3>({.nx = 5, .ny = 5, .nz = 80, .aspect_ratio = ratio});
        const FrontOrder front = order_of(mesh);
        const std::size_t columns = 36;
        double highest_before = -1;
        for (std::size_t layer = 0; layer < 20; ++layer) {
            double low = INFINITY, high = 0;
            for (std::size_t c = 0; c < columns; ++c) {
                const double key = front.key[NodeId(layer * columns + c)];
                low = std::min(low, key);
                high = std::max(high, key);
            }
            QCOMPARE_GT(low, highest_before);
            highest_before = high;
        }
    }
}

void FrontOrderTest::both_walls_of_a_channel_are_seeds() {
    const Mesh<2> mesh = shapes::rectangle(shapes::uniform(4), shapes::geometric(8, 1e-4, 1));
    const FrontOrder front = order_of(mesh);
    for (const NodeId v : mesh.points.ids()) {
        const auto layer = static_cast<double>(v.index() / 5);
        const double from_wall = std::min(layer, 8 - layer);
        QCOMPARE_GE(front.key[v], 0.5 * from_wall);
        QCOMPARE_LE(front.key[v], 2 * from_wall);
    }
}

void FrontOrderTest::without_walls_the_whole_boundary_is_the_seed() {
    const auto verify = [](const auto& mesh) {
        const FrontOrder front = order_of(mesh);
        const auto classes = classify_geometry(mesh);
        for (const NodeId v : mesh.points.ids()) {
            QCOMPARE(front.key[v] == 0, classes.node[v] != NodeClass::interior);
        }
    };
    verify(make_cube<2>({.n = 8}));
    verify(make_cube<3>({.n = 5}));
}

void FrontOrderTest::the_order_is_a_permutation_by_key() {
    verify_order(make_layer<2>({.nx = 10, .nz = 12, .shuffle = 3}));
    verify_order(make_layer<3>({.nx = 5, .ny = 5, .nz = 12, .shuffle = 3}));
    verify_order(make_cube<3>({.n = 4}));
}

void FrontOrderTest::does_not_depend_on_the_numbering() {
    compare_with_shuffled(make_layer<2>({.nx = 10, .nz = 16}));
    compare_with_shuffled(make_layer<3>({.nx = 5, .ny = 5, .nz = 16}));
    compare_with_shuffled(make_cube<3>({.n = 4}));
}

QTEST_APPLESS_MAIN(FrontOrderTest)
#include "front_order_test.moc"
