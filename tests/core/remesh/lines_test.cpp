// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/lines.h"

#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "core/remesh/front_order.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

template <int D>
Lines lines_of(const Mesh<D>& mesh, const LineOptions& options = {}) {
    const Couplings couplings = make_couplings(mesh);
    const FrontOrder front = front_order(mesh, nodal_metric(mesh), couplings.neighbours);
    return find_lines(mesh, couplings, front.key, options);
}

/// A line over nodes 0 ... n-1.
Lines single_line(int n) {
    Lines lines;
    const auto size = static_cast<std::size_t>(n);
    lines.previous.resize(size);
    lines.next.resize(size);
    lines.position.resize(size);
    lines.gap_used.assign(size, 0);
    for (int i = 0; i < n; ++i) {
        lines.previous[NodeId(i)] = i > 0 ? NodeId(i - 1) : NodeId();
        lines.next[NodeId(i)] = i + 1 < n ? NodeId(i + 1) : NodeId();
        lines.position[NodeId(i)] = i;
    }
    lines.count = 1;
    lines.node_count = n;
    return lines;
}

/// All nodes of a layer of `nz` cells are on lines of nz + 1 nodes that climb from the wall.
template <int D>
void expect_columns(const Mesh<D>& mesh, int nz) {
    const Lines lines = lines_of(mesh);
    QCOMPARE(lines.node_count, static_cast<std::int64_t>(mesh.points.size()));
    QCOMPARE(lines.count * (nz + 1), lines.node_count);
    for (const NodeId v : mesh.points.ids()) {
        QVERIFY(lines.on_line(v));
        const NodeId up = lines.next[v];
        QCOMPARE(up.valid(), lines.position[v] < nz);
        QCOMPARE(lines.previous[v].valid(), lines.position[v] > 0);
        QCOMPARE(lines.position[v] == 0, mesh.points[v][D - 1] == 0);
        if (up.valid()) {
            QCOMPARE(lines.position[up], lines.position[v] + 1);
            QVERIFY(lines.previous[up] == v);
            QCOMPARE_GT(mesh.points[up][D - 1], mesh.points[v][D - 1]);
            QVERIFY(lines.linked(v, up));
            QVERIFY(lines.linked(up, v));
        }
        QCOMPARE(lines.gap_used[v], std::uint8_t{0});
    }
}

} // namespace

class LinesTest : public QObject {
    Q_OBJECT
private slots:
    void layers_are_all_lines_numbered_from_the_wall_data();
    void layers_are_all_lines_numbered_from_the_wall();
    void isotropic_meshes_have_hardly_any_lines();
    void lines_between_two_walls_start_on_the_same_side();
    void lines_end_where_the_layer_does();
    void lines_go_on_beyond_their_ends_where_couplings_dominate_less();
    void weaker_couplings_alone_make_no_lines();
    void no_line_goes_along_a_needle();
    void does_not_depend_on_the_numbering();
    void removal_joins_two_gaps_and_marks_the_new_one();
    void removal_of_an_end_shortens_the_line();
    void the_node_beside_a_removed_end_stays();
    void only_neighbours_on_a_line_are_linked();
};

void LinesTest::layers_are_all_lines_numbered_from_the_wall_data() {
    QTest::addColumn<double>("aspect_ratio");
    QTest::addColumn<int>("seed");
    for (const double ratio : {1e3, 1e4, 1e6}) {
        for (const int seed : {0, 5}) {
            QTest::addRow("%g, shuffle %d", ratio, seed) << ratio << seed;
        }
    }
}

void LinesTest::layers_are_all_lines_numbered_from_the_wall() {
    QFETCH(double, aspect_ratio);
    QFETCH(int, seed);
    expect_columns(
        make_layer<2>(
            {.nx = 12, .nz = 12, .aspect_ratio = aspect_ratio, .displace = 0.2, .shuffle = seed}),
        12);
    expect_columns(make_layer<3>({.nx = 6,
                                  .ny = 6,
                                  .nz = 12,
                                  .aspect_ratio = aspect_ratio,
                                  .displace = 0.2,
                                  .shuffle = seed}),
                   12);
}

void LinesTest::isotropic_meshes_have_hardly_any_lines() {
    const Mesh<2> square = make_cube<2>({.n = 12, .displace = 0});
    QCOMPARE(lines_of(square).count, 0);
    const Mesh<3> cube = make_cube<3>({.n = 8, .displace = 0});
    QCOMPARE_LE(lines_of(cube).node_count, static_cast<std::int64_t>(cube.points.size()) / 10);
}

void LinesTest::lines_between_two_walls_start_on_the_same_side() {
    // An even number of nodes: odd positions counted from either side are different layers.
    const std::vector<double> heights = shapes::geometric(7, 1e-5, 1);
    for (unsigned seed = 1; seed <= 3; ++seed) {
        expect_columns(shapes::shuffled(shapes::rectangle(shapes::uniform(6), heights), seed), 7);
        expect_columns(
            shapes::shuffled(shapes::box(shapes::uniform(4), shapes::uniform(4), heights), seed),
            7);
    }
}

void LinesTest::lines_end_where_the_layer_does() {
    // Heights 1/64, 1/32, ... 1/2 and then three times 1/8, over a width of 1/8: strong upwards as
    // long as they are much lower than wide.
    const Mesh<2> mesh = shapes::rectangle(
        shapes::uniform(8), {0, 1.0 / 512, 3.0 / 512, 7.0 / 512, 15.0 / 512, 0.15, 0.275, 0.4});
    const Lines lines = lines_of(mesh);
    const NodeId foot(4); // in the middle of the wall
    QCOMPARE(lines.position[foot], 0);
    std::int32_t top = 0;
    for (NodeId v = foot; v.valid(); v = lines.next[v]) {
        top = lines.position[v];
        QCOMPARE(mesh.points[v][0], 0.5);
    }
    QCOMPARE_GE(top, 3);
    QCOMPARE_LE(top, 5);
}

/// Cells 1/8 wide, `low` of a quarter of that and then `high` that are 0.77 times as high as wide:
/// there couplings upwards are 1.7 times those to the sides.
Mesh<2> fading_layer(int low, int high) {
    std::vector<double> heights{0};
    for (int k = 0; k < low + high; ++k) {
        heights.push_back(heights.back() + (k < low ? 0.25 : 0.77) / 8);
    }
    return shapes::rectangle(shapes::uniform(8), heights);
}

void LinesTest::lines_go_on_beyond_their_ends_where_couplings_dominate_less() {
    const Mesh<2> mesh = fading_layer(6, 5);
    const auto nodes_above = [&](const LineOptions& options) {
        const Lines lines = lines_of(mesh, options);
        int count = 0;
        for (NodeId v(4); lines.next[v].valid(); v = lines.next[v]) { // from the middle of the wall
            ++count;
        }
        return count;
    };
    QCOMPARE_LE(nodes_above({.dominance = 2, .continuation = 2}), 7);
    QCOMPARE(nodes_above({.dominance = 2, .continuation = 1.4}), 11);
}

void LinesTest::weaker_couplings_alone_make_no_lines() {
    QCOMPARE(lines_of(fading_layer(0, 8)).count, 0);
}

void LinesTest::no_line_goes_along_a_needle() {
    const Mesh<3> rod = make_rod(7);
    const Couplings couplings = make_couplings(rod);
    const NodeId middle(3 * (rod_corners + 1)), above(4 * (rod_corners + 1));
    const auto neighbours = couplings.neighbours[middle];
    float others = 0;
    for (const NodeId w : neighbours) {
        const bool on_axis = w.index() % (rod_corners + 1) == 0;
        others = std::max(others, on_axis ? 0 : couplings.between(middle, w));
    }
    QCOMPARE_GT(couplings.between(middle, above), 2 * others); // as if on a line
    QVERIFY(!lines_of(rod).on_line(middle));
}

void LinesTest::does_not_depend_on_the_numbering() {
    const Mesh<3> mesh = make_layer<3>({.nx = 5, .ny = 5, .nz = 24, .aspect_ratio = 100});
    const auto position_by_place = [](const Mesh<3>& m) {
        const Lines lines = lines_of(m);
        std::map<std::array<double, 3>, std::int32_t> out;
        for (const NodeId v : m.points.ids()) {
            out[key_of<3>(m.points[v])] = lines.position[v];
        }
        return out;
    };
    QVERIFY(position_by_place(mesh) == position_by_place(shapes::shuffled(mesh, 4)));
}

void LinesTest::removal_joins_two_gaps_and_marks_the_new_one() {
    Lines lines = single_line(5);
    lines.remove(NodeId(1));
    QVERIFY(!lines.on_line(NodeId(1)));
    QVERIFY(lines.next[NodeId(0)] == NodeId(2));
    QVERIFY(lines.previous[NodeId(2)] == NodeId(0));
    QVERIFY(lines.linked(NodeId(0), NodeId(2)));
    QVERIFY(!lines.linked(NodeId(0), NodeId(1)));
    QVERIFY(lines.beside_used_gap(NodeId(0)));
    QVERIFY(lines.beside_used_gap(NodeId(2)));
    QVERIFY(!lines.beside_used_gap(NodeId(3)));
    QVERIFY(!lines.beside_used_gap(NodeId(4)));
    QCOMPARE(lines.position[NodeId(2)], 2); // others keep their place
}

void LinesTest::removal_of_an_end_shortens_the_line() {
    Lines lines = single_line(3);
    lines.remove(NodeId(2));
    QVERIFY(!lines.next[NodeId(1)].valid());
    lines.remove(NodeId(0));
    QVERIFY(!lines.previous[NodeId(1)].valid());
    QVERIFY(lines.on_line(NodeId(1)));
}

void LinesTest::the_node_beside_a_removed_end_stays() {
    Lines wall = single_line(5);
    wall.remove(NodeId(0));
    QVERIFY(wall.beside_used_gap(NodeId(1)));
    QVERIFY(!wall.beside_used_gap(NodeId(3)));
    Lines top = single_line(5);
    top.remove(NodeId(4));
    QVERIFY(top.beside_used_gap(NodeId(3)));
    QVERIFY(!top.beside_used_gap(NodeId(1)));
}

void LinesTest::only_neighbours_on_a_line_are_linked() {
    const Lines lines = single_line(4);
    QVERIFY(lines.linked(NodeId(1), NodeId(2)));
    QVERIFY(lines.linked(NodeId(2), NodeId(1)));
    QVERIFY(!lines.linked(NodeId(0), NodeId(2)));
    QVERIFY(!lines.linked(NodeId(3), NodeId(0)));
    // No node is linked to none.
    QVERIFY(!lines.linked(NodeId(3), NodeId()));
    QVERIFY(!lines.linked(NodeId(1), NodeId()));
}

QTEST_APPLESS_MAIN(LinesTest)
#include "lines_test.moc"
