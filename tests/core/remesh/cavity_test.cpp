// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/cavity.h"

#include "core/cases/cube.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;
using shapes::nodes;

namespace {

template <int D>
double cavity_volume(const EditMesh<D>& mesh, const Cavity<D>& cavity) {
    double sum = 0;
    for (const ElementId e : cavity.elements) {
        sum += mesh.is_ghost(e) ? 0 : volume_of(mesh, mesh.nodes(e));
    }
    return sum;
}

/// Whether the star covers the cavity: its elements are positive, and together as large.
template <int D>
bool covers(const EditMesh<D>& mesh, const Cavity<D>& cavity, const Star<D>& star) {
    double sum = 0;
    for (const EditElement<D>& e : star.elements) {
        if (e.nodes[D] != mesh.ghost()) {
            const double v = volume_of(mesh, e.nodes);
            if (!(v > 0)) {
                return false;
            }
            sum += v;
        }
    }
    const double before = cavity_volume(mesh, cavity);
    return std::abs(sum - before) <= 1e-13 * before && star.sources.size() == star.elements.size();
}

/// Stars of a cavity inside the domain from all nodes around; returns how many were accepted, or -1
/// if one does not cover.
template <int D>
int try_all_stars(const EditMesh<D>& mesh, const Cavity<D>& cavity) {
    // At the boundary a star may well cut off a part of the domain: that is for other rules.
    if (std::any_of(cavity.elements.begin(), cavity.elements.end(),
                    [&](ElementId e) { return mesh.is_ghost(e); })) {
        return 0;
    }
    std::set<NodeId> around;
    for (const Facet<D>& f : cavity.facets) {
        around.insert(f.begin(), f.end());
    }
    around.erase(mesh.ghost());
    int accepted = 0;
    for (const NodeId v : around) {
        Star<D> star;
        const Verdict verdict = make_star(mesh, cavity, v, star);
        if (verdict == Verdict::accepted) {
            ++accepted;
            if (!covers(mesh, cavity, star)) {
                return -1;
            }
        } else if (verdict != Verdict::inverts_element) {
            return -1;
        }
    }
    return accepted;
}

template <int D>
void star_all_cavities() {
    const Mesh<D> mesh =
        make_cube<D>({.n = 3, .displace = 0.2, .diagonals = Diagonals::random, .shuffle = 3});
    const Workbench<D> bench(mesh);
    const EditMesh<D>& edit = bench.edit;
    Cavity<D> cavity;
    int balls = 0, shells = 0, pairs = 0;
    for (const NodeId v : edit.nodes()) {
        gather_ball(edit, v, cavity);
        QCOMPARE(cavity.facets.size(), cavity.elements.size());
        const int stars = try_all_stars(edit, cavity);
        QCOMPARE_GE(stars, 0);
        balls += stars;
        for (const NodeId w : neighbours(edit, v)) {
            gather_shell(edit, v, w, cavity);
            QCOMPARE(cavity.facets.size(), 2 * cavity.elements.size());
            const int of_shell = try_all_stars(edit, cavity);
            QCOMPARE_GE(of_shell, 0);
            shells += of_shell;
        }
    }
    for (const ElementId e : mesh.elements.ids()) {
        for (const ElementId f : mesh.elements.ids()) {
            const Simplex<D>& s = mesh.elements[e];
            const auto common = std::count_if(s.begin(), s.end(), [&](NodeId v) {
                return std::count(mesh.elements[f].begin(), mesh.elements[f].end(), v) > 0;
            });
            if (common == D) {
                gather_pair(edit, e, f, cavity);
                QCOMPARE(cavity.elements.size(), std::size_t{2});
                QCOMPARE(cavity.facets.size(), static_cast<std::size_t>(2 * D));
                const int of_pair = try_all_stars(edit, cavity);
                QCOMPARE_GE(of_pair, D); // the two elements themselves, at least
                pairs += of_pair;
            }
        }
    }
    QCOMPARE_GT(balls, 0);
    QCOMPARE_GT(shells, 0);
    QCOMPARE_GT(pairs, 0);
}

} // namespace

class CavityTest : public QObject {
    Q_OBJECT
private slots:
    void stars_cover_balls_shells_and_pairs();
    void a_node_that_does_not_see_the_whole_cavity_is_refused();
    void a_star_without_real_element_is_refused();
    void new_elements_inherit_region_patch_and_deviation();
    void judges_by_the_worst_new_element();
};

void CavityTest::stars_cover_balls_shells_and_pairs() {
    star_all_cavities<2>();
    star_all_cavities<3>();
}

void CavityTest::a_node_that_does_not_see_the_whole_cavity_is_refused() {
    // A dart around node 0 with its dent at node 2: from 1 and 3 the far sides are hidden.
    const Workbench<2> dart(
        shapes::from_literals<2>({{0, 0}, {2, 0}, {0.3, 0.3}, {0, 2}, {-1, -1}},
                                 {nodes(0, 1, 2), nodes(0, 2, 3), nodes(0, 3, 4), nodes(0, 4, 1)}));
    Cavity<2> ball;
    Star<2> star;
    gather_ball(dart.edit, NodeId(0), ball);
    QCOMPARE(make_star(dart.edit, ball, NodeId(1), star), Verdict::inverts_element);
    QCOMPARE(make_star(dart.edit, ball, NodeId(3), star), Verdict::inverts_element);
    QCOMPARE(make_star(dart.edit, ball, NodeId(2), star), Verdict::accepted);
    QCOMPARE(star.elements.size(), std::size_t{2});
    QVERIFY(covers(dart.edit, ball, star));
    // The same as a double pyramid.
    const Workbench<3> pyramid(shapes::from_literals<3>(
        {{0, 0, 0}, {2, 0, 0}, {0.3, 0.3, 0}, {0, 2, 0}, {-1, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {nodes(0, 1, 2, 5), nodes(0, 2, 3, 5), nodes(0, 3, 4, 5), nodes(0, 4, 1, 5),
         nodes(0, 2, 1, 6), nodes(0, 3, 2, 6), nodes(0, 4, 3, 6), nodes(0, 1, 4, 6)}));
    Cavity<3> ball3;
    Star<3> star3;
    gather_ball(pyramid.edit, NodeId(0), ball3);
    QCOMPARE(make_star(pyramid.edit, ball3, NodeId(1), star3), Verdict::inverts_element);
    QCOMPARE(make_star(pyramid.edit, ball3, NodeId(2), star3), Verdict::accepted);
    QVERIFY(covers(pyramid.edit, ball3, star3));
    // A flat element is refused as well: 2 exactly between 1 and 3.
    const Workbench<2> flat(
        shapes::from_literals<2>({{0, 0}, {1, 1}, {0, 1}, {-1, 1}, {0, -1}},
                                 {nodes(0, 1, 2), nodes(0, 2, 3), nodes(0, 3, 4), nodes(0, 4, 1)}));
    gather_ball(flat.edit, NodeId(0), ball);
    QCOMPARE(make_star(flat.edit, ball, NodeId(1), star), Verdict::inverts_element);
}

void CavityTest::a_star_without_real_element_is_refused() {
    const Workbench<3> tet(shapes::single_tet());
    Cavity<3> ball;
    Star<3> star;
    gather_ball(tet.edit, NodeId(0), ball);
    QCOMPARE(make_star(tet.edit, ball, NodeId(1), star), Verdict::inverts_element);
    const Workbench<2> triangle(shapes::single_triangle());
    Cavity<2> ball2;
    Star<2> star2;
    gather_ball(triangle.edit, NodeId(0), ball2);
    QCOMPARE(make_star(triangle.edit, ball2, NodeId(1), star2), Verdict::inverts_element);
}

void CavityTest::new_elements_inherit_region_patch_and_deviation() {
    Mesh<2> mesh = shapes::square(2);
    mesh.region.assign(mesh.elements.size(), 6);
    Workbench<2> bench(mesh);
    Cavity<2> ball;
    Star<2> star;
    gather_ball(bench.edit, NodeId(1), ball); // (1/2, 0), on patch 3
    for (const ElementId e : ball.elements) {
        if (bench.edit.is_ghost(e)) {
            bench.edit.set_measure(e, 0.125f);
        }
    }
    QCOMPARE(make_star(bench.edit, ball, NodeId(0), star), Verdict::accepted);
    int ghosts = 0;
    for (const EditElement<2>& e : star.elements) {
        const bool ghost = e.nodes[2] == bench.edit.ghost();
        ghosts += ghost;
        QCOMPARE(e.label, ghost ? 3 : 6);
        if (ghost) {
            QCOMPARE(e.measure, 0.125f);
            QVERIFY(ghost_face<2>(e.nodes) == nodes(0, 2));
        }
    }
    QCOMPARE(ghosts, 1);
}

void CavityTest::judges_by_the_worst_new_element() {
    const Mesh<3> mesh = make_cube<3>({.n = 3, .displace = 0.1});
    const Workbench<3> bench(mesh, isotropic<3>(mesh.points.size(), 0.4));
    Cavity<3> ball;
    Star<3> star;
    for (const NodeId v : mesh.points.ids()) {
        if (bench.edit.node_class(v) != NodeClass::interior) {
            continue;
        }
        gather_ball(bench.edit, v, ball);
        double before = 1;
        for (const ElementId e : ball.elements) {
            before = std::min(before, size_quality(bench.edit, bench.sizes, bench.edit.nodes(e)));
        }
        QCOMPARE_LE(std::abs(worst_quality(bench.edit, ball) - before), 1e-7);
        for (const NodeId w : neighbours(bench.edit, v)) {
            if (make_star(bench.edit, ball, w, star) != Verdict::accepted) {
                continue;
            }
            QCOMPARE(judge(bench.edit, bench.sizes, 0, star), Verdict::accepted);
            double worst = 1;
            for (const EditElement<3>& e : star.elements) {
                worst = std::min(worst, size_quality(bench.edit, bench.sizes, e.nodes));
            }
            QCOMPARE(star.worst_quality, worst);
            QCOMPARE(judge(bench.edit, bench.sizes, worst * 1.0001, star), Verdict::low_quality);
        }
    }
}

QTEST_APPLESS_MAIN(CavityTest)
#include "cavity_test.moc"
