// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/swap.h"

#include "core/cases/layer.h"
#include "core/remesh/coarsening_rules.h"
#include "tests/core/remesh/swap_support.h"

#include <QTest>

#include <numeric>

using namespace ameco;
using namespace ameco::remesh_test;
using shapes::nodes;

namespace {

template <int D>
struct Look {
    double worst = 1; ///< metric quality
    int lineless = 0;
    std::size_t nodes = 0;
};

template <int D>
Look<D> look_at(const Workbench<D>& bench, const Lines& lines) {
    Look<D> look;
    for (std::size_t i = 0; i < bench.edit.slot_count(); ++i) {
        const ElementId e(i);
        if (!bench.edit.is_free(e) && !bench.edit.is_ghost(e)) {
            const Simplex<D>& s = bench.edit.nodes(e);
            look.worst = std::min(look.worst, metric_quality(bench.edit, bench.root, s));
            look.lineless += is_lineless<D>(lines, s);
        }
    }
    for (const NodeId v : bench.edit.nodes()) {
        look.nodes += !bench.edit.is_removed(v);
    }
    return look;
}

/// Swaps with all that is bad, and verifies what must not change. Returns how many swaps were made.
template <int D>
std::int64_t swap_and_verify(Workbench<D>& bench, const Lines& lines) {
    const Extent extent_before = extent(bench.edit.compact().mesh);
    const Look<D> before = look_at(bench, lines);
    VerdictCounts verdicts;
    swap_bad_elements<D>(
        bench.edit, {bench.sizes, bench.root, bench.short_size, lines, bench.removed, bench.notes},
        {.below = 0.9, .size_floor = 0}, plane_sides, verdicts);
    const Look<D> after = look_at(bench, lines);
    const auto compact = bench.edit.compact();
    const CheckReport report = check(compact.mesh);
    const double changed = difference(extent_before, extent(compact.mesh));
    if (!report.valid() || !(changed <= 1e-11)) {
        qWarning("after swaps: %s, extent changed by %g", report.summary().c_str(), changed);
        return -1;
    }
    if (after.worst < before.worst || after.lineless > before.lineless ||
        after.nodes != before.nodes) {
        qWarning("worst quality %g to %g, lineless elements %d to %d, nodes %zu to %zu",
                 before.worst, after.worst, before.lineless, after.lineless, before.nodes,
                 after.nodes);
        return -1;
    }
    return verdicts[Verdict::accepted];
}

template <int D>
void improve_displaced_cubes(int n, unsigned seed) {
    const Mesh<D> mesh = displaced_cube<D>(n, seed);
    Workbench<D> bench(mesh, isotropic<D>(mesh.points.size(), 1.0 / n));
    const Lines lines = no_lines(mesh.points.size());
    const double before = look_at(bench, lines).worst;
    QCOMPARE_GT(swap_and_verify(bench, lines), 10);
    QCOMPARE_GE(look_at(bench, lines).worst, before);
}

template <int D>
void alternate_with_collapses(int n, unsigned seed) {
    const Mesh<D> mesh = displaced_cube<D>(n, seed);
    Workbench<D> bench(mesh, isotropic<D>(mesh.points.size(), 2.0 / n));
    const Lines lines = no_lines(mesh.points.size());
    std::int64_t made = 0;
    for (unsigned round = 0; round < 5; ++round) {
        thin_out(bench, 300, seed + round);
        const std::int64_t now = swap_and_verify(bench, lines);
        QCOMPARE_GE(now, 0);
        made += now;
    }
    QCOMPARE_GT(made, 20);
}

/// Nodes of a layer taken away at random, then swaps.
template <int D>
void keep_lines(double aspect_ratio, unsigned seed) {
    const Mesh<D> mesh = make_layer<D>({.nx = D == 2 ? 16 : 5,
                                        .ny = 5,
                                        .nz = 10,
                                        .aspect_ratio = aspect_ratio,
                                        .jitter = 0.2,
                                        .diagonals = Diagonals::random,
                                        .seed = static_cast<int>(seed)});
    Workbench<D> bench(mesh);
    const Lines lines = lines_of(bench);
    QCOMPARE_GT(lines.count, 0);
    QCOMPARE_GE(swap_and_verify(bench, lines), 0);
    thin_out(bench, 400, seed);
    QCOMPARE_GE(swap_and_verify(bench, lines), 1);
}

} // namespace

class SwapTest : public QObject {
    Q_OBJECT
private slots:
    void turns_the_diagonal_of_a_flat_pair();
    void replaces_three_elements_at_an_edge_by_two();
    void replaces_two_elements_at_a_face_by_three();
    void turns_the_diagonal_of_a_plane_side();
    void improves_displaced_boxes_data();
    void improves_displaced_boxes();
    void keeps_boxes_whole_between_collapses();
    void never_adds_elements_off_the_lines_of_a_layer();
    void leaves_required_faces_and_elements();
    void leaves_region_borders();
    void leaves_listed_edges_inside_the_domain();
    void tries_an_element_again_only_when_one_beside_it_has_changed();
    void no_node_becomes_soft_data();
    void no_node_becomes_soft();
    void does_nothing_to_a_good_mesh();
    void names_elements_off_the_lines();
};

void SwapTest::turns_the_diagonal_of_a_flat_pair() {
    const Mesh<2> mesh = shapes::from_literals<2>({{0, 0}, {4, 0}, {2, 0.7}, {2, -0.7}},
                                                  {nodes(0, 1, 2), nodes(1, 0, 3)});
    Workbench<2> bench(mesh, isotropic<2>(4, 2));
    QCOMPARE(swap_and_verify(bench, no_lines(4)), 1);
    const auto around = neighbours(bench.edit, NodeId(0));
    QVERIFY(std::find(around.begin(), around.end(), NodeId(1)) == around.end());
    const auto across = neighbours(bench.edit, NodeId(2));
    QVERIFY(std::find(across.begin(), across.end(), NodeId(3)) != across.end());
}

void SwapTest::replaces_three_elements_at_an_edge_by_two() {
    // A long edge 0 1 through a triangle 2 3 4.
    const Mesh<3> mesh = shapes::from_literals<3>(
        {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {-0.5, 0.866, 0}, {-0.5, -0.866, 0}},
        {nodes(0, 2, 3, 1), nodes(0, 3, 4, 1), nodes(0, 4, 2, 1)});
    QVERIFY(check(mesh).valid());
    Workbench<3> bench(mesh, isotropic<3>(5, 1.58));
    QCOMPARE(swap_and_verify(bench, no_lines(5)), 1);
    QCOMPARE(bench.edit.compact().mesh.elements.size(), std::size_t{2});
}

void SwapTest::replaces_two_elements_at_a_face_by_three() {
    const Mesh<3> mesh = shapes::from_literals<3>(
        {{0, 0, -2}, {0, 0, 2}, {0.6, 0, 0}, {-0.3, 0.52, 0}, {-0.3, -0.52, 0}},
        {nodes(2, 4, 3, 0), nodes(2, 3, 4, 1)});
    QVERIFY(check(mesh).valid());
    // Sizes that make the long edge the wanted one.
    Workbench<3> bench(mesh, uniform_metric<3>(5, {{0.6, 0.6, 4}, Mat<3>::Identity()}));
    QCOMPARE(swap_and_verify(bench, no_lines(5)), 1);
    QCOMPARE(bench.edit.compact().mesh.elements.size(), std::size_t{3});
}

void SwapTest::turns_the_diagonal_of_a_plane_side() {
    // Two tets over a plane kite whose long diagonal is the edge 0 1.
    const Mesh<3> mesh =
        shapes::from_literals<3>({{-1.5, 0, 0}, {1.5, 0, 0}, {0, 0.6, 0}, {0, -0.6, 0}, {0, 0, 1}},
                                 {nodes(0, 1, 2, 4), nodes(1, 0, 3, 4)});
    Workbench<3> bench(mesh, isotropic<3>(5, 1.3));
    QCOMPARE(swap_and_verify(bench, no_lines(5)), 1);
    const auto across = neighbours(bench.edit, NodeId(2));
    QVERIFY(std::find(across.begin(), across.end(), NodeId(3)) != across.end());
    QCOMPARE(bench.edit.compact().mesh.faces.size(), std::size_t{6});
}

void SwapTest::improves_displaced_boxes_data() {
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 4; ++seed) {
        QTest::addRow("seed %u", seed) << seed;
    }
}

void SwapTest::improves_displaced_boxes() {
    QFETCH(unsigned, seed);
    improve_displaced_cubes<2>(12, seed);
    improve_displaced_cubes<3>(5, seed);
}

void SwapTest::keeps_boxes_whole_between_collapses() {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        alternate_with_collapses<2>(14, seed);
        alternate_with_collapses<3>(6, seed);
    }
}

void SwapTest::never_adds_elements_off_the_lines_of_a_layer() {
    for (unsigned seed = 1; seed <= 2; ++seed) {
        for (const double ratio : {1e2, 1e6}) {
            keep_lines<2>(ratio, seed);
            keep_lines<3>(ratio, seed);
        }
    }
}

void SwapTest::leaves_required_faces_and_elements() {
    Mesh<3> mesh = displaced_cube<3>(4, 7);
    for (int f = 0; f < static_cast<int>(mesh.faces.size()); f += 5) {
        mesh.features.required_faces.push_back(f);
    }
    mesh.features.required_elements = {11, 50, 200};
    const auto before = places(mesh, mesh.features.required_faces);
    Workbench<3> bench(mesh, isotropic<3>(mesh.points.size(), 0.25));
    QCOMPARE_GT(swap_and_verify(bench, no_lines(mesh.points.size())), 5);
    const Mesh<3> after = bench.edit.compact().mesh;
    QVERIFY(places(after, after.features.required_faces) == before);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto element = [&](const Mesh<3>& m) {
            return place_of<3>(m, m.elements[ElementId(m.features.required_elements[i])]);
        };
        QVERIFY(element(after) == element(mesh));
    }
    // In two dimensions files call boundary faces edges.
    Mesh<2> square = displaced_cube<2>(8, 7);
    square.features.required_edges = {0, 5, 9};
    const auto edges = places(square, square.features.required_edges);
    Workbench<2> bench2(square, isotropic<2>(square.points.size(), 0.125));
    QCOMPARE_GT(swap_and_verify(bench2, no_lines(square.points.size())), 5);
    const Mesh<2> after2 = bench2.edit.compact().mesh;
    QVERIFY(places(after2, after2.features.required_edges) == edges);
}

void SwapTest::leaves_region_borders() {
    const auto border = [](const auto& mesh) {
        std::vector<int> faces;
        for (const FaceId f : mesh.faces.ids()) {
            if (mesh.patch[f] == 20) {
                faces.push_back(f.value());
            }
        }
        return places(mesh, faces);
    };
    Mesh<3> cube = displaced_cube<3>(5, 3);
    split_regions(cube, 0.5);
    Workbench<3> bench(cube, isotropic<3>(cube.points.size(), 0.2));
    QCOMPARE_GT(swap_and_verify(bench, no_lines(cube.points.size())), 5);
    const Mesh<3> after = bench.edit.compact().mesh;
    QVERIFY(border(after) == border(cube));
    QCOMPARE_EQ(check(after).interior_faces, check(cube).interior_faces);
    // A border that no file lists as faces holds as well.
    Mesh<2> square = displaced_cube<2>(10, 3);
    split_regions(square, 0.5);
    const std::int64_t inside = check(square).interior_faces;
    square.faces.raw().resize(square.faces.size() - static_cast<std::size_t>(inside));
    square.patch.raw().resize(square.faces.size());
    Workbench<2> bench2(square, isotropic<2>(square.points.size(), 0.1));
    QCOMPARE_GT(swap_and_verify(bench2, no_lines(square.points.size())), 5);
}

void SwapTest::leaves_listed_edges_inside_the_domain() {
    // The long edge 0 1 through a triangle 2 3 4, which a swap would remove, inside a larger mesh:
    // the same three elements with one more tet on each of their outer faces.
    Mesh<3> mesh =
        shapes::from_literals<3>({{0, 0, -1},
                                  {0, 0, 1},
                                  {1, 0, 0},
                                  {-0.5, 0.866, 0},
                                  {-0.5, -0.866, 0},
                                  {0, 0, -2.5},
                                  {0, 0, 2.5}},
                                 {nodes(0, 2, 3, 1), nodes(0, 3, 4, 1), nodes(0, 4, 2, 1),
                                  nodes(2, 3, 1, 6), nodes(3, 4, 1, 6), nodes(4, 2, 1, 6),
                                  nodes(3, 2, 0, 5), nodes(4, 3, 0, 5), nodes(2, 4, 0, 5)});
    QVERIFY2(check(mesh).valid(), check(mesh).summary().c_str());
    Workbench<3> bare(mesh, isotropic<3>(7, 1.58));
    QVERIFY(swap_and_verify(bare, no_lines(7)) > 0);
    const auto linked = [](const EditMesh<3>& edit) {
        const auto around = neighbours(edit, NodeId(0));
        return std::find(around.begin(), around.end(), NodeId(1)) != around.end();
    };
    QVERIFY(!linked(bare.edit));
    mesh.features.edges = {{NodeId(0), NodeId(1)}};
    mesh.features.edge_labels = {3};
    Workbench<3> listed(mesh, isotropic<3>(7, 1.58));
    QCOMPARE_GE(swap_and_verify(listed, no_lines(7)), 0);
    QVERIFY(linked(listed.edit));
    QCOMPARE(listed.edit.compact().mesh.features.edges.size(), std::size_t{1});
}

void SwapTest::no_node_becomes_soft_data() {
    QTest::addColumn<unsigned>("seed");
    for (const unsigned seed : {1u, 2u, 3u}) {
        QTest::addRow("seed %u", seed) << seed;
    }
}

void SwapTest::no_node_becomes_soft() {
    QFETCH(unsigned, seed);
    const Mesh<3> mesh = displaced_cube<3>(5, seed);
    const std::size_t n = mesh.points.size();
    const Couplings couplings = make_couplings(mesh);
    // Least a_vv after swaps over that before them, of all nodes.
    const auto softest = [&](double least) {
        Workbench<3> bench(mesh, isotropic<3>(n, 0.2));
        RemovedNodes<3> removed(couplings, IdVector<NodeId, float>(n, 0.0F));
        const Lines lines = no_lines(n);
        VerdictCounts verdicts;
        swap_bad_elements<3>(
            bench.edit,
            {bench.sizes, bench.root, bench.short_size, lines, removed, bench.notes, {}, least},
            {.below = 0.9, .size_floor = 0}, plane_sides, verdicts);
        const Couplings after = make_couplings(bench.edit.compact().mesh);
        double least_share = 1;
        for (const NodeId v : mesh.points.ids()) { // none is removed: they keep their numbers
            const float share = after.diagonal[v] / couplings.diagonal[v];
            least_share = std::min(least_share, static_cast<double>(share));
        }
        return std::pair(least_share, verdicts);
    };
    const auto [free, free_verdicts] = softest(0);
    QCOMPARE_LT(free, 0.7);
    QCOMPARE(free_verdicts[Verdict::soft_element], 0);
    const auto [held, held_verdicts] = softest(0.7);
    QCOMPARE_GE(held, 0.7 - 1e-6);
    QCOMPARE_GT(held_verdicts[Verdict::soft_element], 0);
    QCOMPARE_GT(held_verdicts[Verdict::accepted], 10);
}

void SwapTest::tries_an_element_again_only_when_one_beside_it_has_changed() {
    Workbench<3> bench(make_cube<3>({.n = 4}));
    const Lines lines = no_lines(bench.mesh.points.size());
    const SwapInput<3> input{bench.sizes, bench.root,    bench.short_size,
                             lines,       bench.removed, bench.notes};
    const SwapOptions options{.below = 0.9, .size_floor = 0, .rounds = 20};
    const auto tries = [&] {
        VerdictCounts verdicts;
        swap_bad_elements<3>(bench.edit, input, options, plane_sides, verdicts);
        return std::accumulate(verdicts.counts.begin(), verdicts.counts.end(), std::int64_t{0});
    };
    QVERIFY(tries() > 100);
    QCOMPARE(tries(), 0); // all that is bad has failed, and is as it was
    const ElementId bad = [&] {
        for (std::size_t i = 0; i < bench.edit.slot_count(); ++i) {
            const ElementId e(i);
            if (!bench.edit.is_free(e) && !bench.edit.is_ghost(e) &&
                metric_quality(bench.edit, bench.root, bench.edit.nodes(e)) < options.below) {
                return e;
            }
        }
        return ElementId();
    }();
    QVERIFY(bad.valid());
    bench.notes.changes.touch(bench.edit.nodes(bad)[0]);
    QCOMPARE(tries(), 0); // one node says that a neighbour has changed beyond it
    bench.notes.changes.touch(bench.edit.nodes(bad)[1]);
    bench.notes.changes.tick();
    QVERIFY(tries() > 0);
    QCOMPARE(tries(), 0);
}

void SwapTest::does_nothing_to_a_good_mesh() {
    Workbench<2> bench(shapes::single_triangle());
    VerdictCounts verdicts;
    const Lines lines = no_lines(3);
    swap_bad_elements<2>(
        bench.edit, {bench.sizes, bench.root, bench.short_size, lines, bench.removed, bench.notes},
        {}, plane_sides, verdicts);
    for (const std::int64_t count : verdicts.counts) {
        QCOMPARE(count, 0);
    }
}

void SwapTest::names_elements_off_the_lines() {
    // Two columns of two nodes: 0 1 and 2 3; node 4 is on none.
    Lines lines = no_lines(5);
    for (const int foot : {0, 2}) {
        lines.next[NodeId(foot)] = NodeId(foot + 1);
        lines.previous[NodeId(foot + 1)] = NodeId(foot);
        lines.position[NodeId(foot)] = 0;
        lines.position[NodeId(foot + 1)] = 1;
    }
    lines.position[NodeId(4)] = -1;
    QVERIFY(!is_lineless<2>(lines, nodes(0, 1, 2)));
    QVERIFY(!is_lineless<2>(lines, nodes(0, 2, 4)));
    QVERIFY(!is_lineless<3>(lines, nodes(0, 2, 1, 4)));
    lines.next[NodeId(0)] = lines.previous[NodeId(1)] = NodeId();
    QVERIFY(is_lineless<2>(lines, nodes(0, 1, 2)));
    QVERIFY(!is_lineless<3>(lines, nodes(0, 1, 2, 3)));
}

QTEST_APPLESS_MAIN(SwapTest)
#include "swap_test.moc"
