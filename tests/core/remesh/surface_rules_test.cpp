// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/surface_rules.h"

#include "core/metric/element_metric.h"
#include "core/remesh/collapse.h"
#include "tests/core/remesh/round_shapes.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace ameco;
using namespace ameco::remesh_test;
using shapes::nodes;

namespace {

constexpr SurfaceRules everything{
    .largest_turn_deg = 89, .relative_distance = 1e9, .layer_share = 1e9};

/// A ring of six triangles between the triangles 0 1 2 (a hole) and 3 4 5.
Mesh<2> triangle_with_hole() {
    Mesh<2> mesh;
    for (const double radius : {1.0, 3.0}) {
        for (int i = 0; i < 3; ++i) {
            const double angle = std::numbers::pi * (0.5 + 2 * i / 3.0);
            mesh.points.push_back(radius * Vec<2>(std::cos(angle), std::sin(angle)));
        }
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        mesh.elements.push_back(nodes(i, 3 + i, 3 + j));
        mesh.elements.push_back(nodes(i, 3 + j, j));
    }
    mesh.region.assign(6, 1);
    shapes::add_boundary(mesh);
    return mesh;
}

/// A plate with a triangular tunnel: each triangle becomes a prism of three tets.
Mesh<3> plate_with_tunnel() {
    const Mesh<2> flat = triangle_with_hole();
    Mesh<3> mesh;
    for (const double z : {0.0, 1.0}) {
        for (const Vec<2>& x : flat.points) {
            mesh.points.push_back({x[0], x[1], z});
        }
    }
    const auto up = [&](NodeId v) { return NodeId(v.index() + flat.points.size()); };
    for (const Simplex<2>& triangle : flat.elements) {
        const Simplex<2> s = sorted(triangle);
        for (Simplex<3> tet :
             {Simplex<3>{s[0], s[1], s[2], up(s[2])}, Simplex<3>{s[0], s[1], up(s[1]), up(s[2])},
              Simplex<3>{s[0], up(s[0]), up(s[1]), up(s[2])}}) {
            if (orientation(mesh, tet) < 0) {
                std::swap(tet[0], tet[1]);
            }
            mesh.elements.push_back(tet);
            mesh.region.push_back(1);
        }
    }
    shapes::add_boundary(mesh);
    return mesh;
}

/// Judges the collapse of one corner of a dodecagon onto the next; the bound that it leaves.
Verdict judge_corner(const SurfaceRules& rules, double short_size, float before, float& after) {
    Workbench<2> bench(polygon(12));
    Cavity<2> ball;
    Star<2> star;
    gather_ball(bench.edit, NodeId(2), ball);
    for (const ElementId e : ball.elements) {
        if (bench.edit.is_ghost(e)) {
            bench.edit.set_measure(e, before);
        }
    }
    if (make_star(bench.edit, ball, NodeId(1), star) != Verdict::accepted) {
        return Verdict::inverts_element;
    }
    const Verdict verdict = judge_surface(bench.edit, ball, short_size, rules, star);
    for (const EditElement<2>& e : star.elements) {
        if (e.nodes[2] == bench.edit.ghost()) {
            after = e.measure;
        }
    }
    return verdict;
}

template <int D>
void accumulate(const Mesh<D>& mesh, int attempts, std::size_t at_least) {
    Workbench<D> bench(mesh);
    std::mt19937 random(6);
    const std::size_t accepted = collapse_boundary_nodes(
        bench, random, attempts,
        {.largest_turn_deg = 45, .relative_distance = 1, .layer_share = 1e9});
    QCOMPARE_GE(accepted, at_least);
    const auto compact = bench.edit.compact();
    double largest = 0;
    for (const FaceId f : compact.mesh.faces.ids()) {
        const double moved = sampled_distance(compact.mesh, f, mesh);
        QCOMPARE_GE(compact.classes.deviation[f], moved - 1e-15); // rounding of the distance
        largest = std::max(largest, moved);
    }
    QCOMPARE_GT(largest, 0.001);
}

/// Short size of the one among some elements that has all nodes of a face; 0 if none has.
double short_size_on(const EditMesh<3>& mesh, const Facet<3>& face,
                     const std::vector<Simplex<3>>& elements) {
    for (const Simplex<3>& s : elements) {
        if (s[3] != mesh.ghost() && std::all_of(face.begin(), face.end(), [&](NodeId v) {
                return std::find(s.begin(), s.end(), v) != s.end();
            })) {
            return element_metric<3>(corners_of(mesh, s)).sizes[0];
        }
    }
    return 0;
}

/// Whether a star gives a face of the boundary a thinner element than it had, and one with less
/// than `least` for its short size.
bool thins_a_layer(const Workbench<3>& bench, const Cavity<3>& ball, const Star<3>& star,
                   double least) {
    std::vector<Simplex<3>> before, after;
    for (const ElementId e : ball.elements) {
        before.push_back(bench.edit.nodes(e));
    }
    for (const EditElement<3>& e : star.elements) {
        after.push_back(e.nodes);
    }
    return std::any_of(bench.mesh.faces.begin(), bench.mesh.faces.end(), [&](const Facet<3>& f) {
        const double h = short_size_on(bench.edit, f, after);
        return h > 0 && h < least && h < short_size_on(bench.edit, f, before);
    });
}

} // namespace

class SurfaceRulesTest : public QObject {
    Q_OBJECT
private slots:
    void a_hole_is_not_closed();
    void a_tunnel_is_not_closed();
    void ordinary_collapses_keep_the_surface_a_manifold();
    void refuses_turns_above_the_limit();
    void refuses_distances_above_the_limits();
    void refuses_faces_that_could_pass_the_elements_on_them();
    void elements_on_faces_that_have_moved_do_not_become_thin();
    void adds_the_distance_to_the_bound_of_the_faces_replaced();
    void plane_sides_do_not_move();
    void bounds_stay_above_the_true_distance();
};

void SurfaceRulesTest::a_hole_is_not_closed() {
    const Mesh<2> mesh = triangle_with_hole();
    QVERIFY2(check(mesh).valid(), check(mesh).summary().c_str());
    const Workbench<2> bench(mesh);
    for (int i = 0; i < 3; ++i) {
        QCOMPARE(check_link(bench.edit, NodeId(i), NodeId((i + 1) % 3)), Verdict::link_condition);
        // Nor are the hole and the outside joined through the inside.
        QCOMPARE(check_link(bench.edit, NodeId(i), NodeId(3 + i)), Verdict::link_condition);
    }
}

void SurfaceRulesTest::a_tunnel_is_not_closed() {
    const Mesh<3> mesh = plate_with_tunnel();
    QVERIFY2(check(mesh).valid(), check(mesh).summary().c_str());
    const Workbench<3> bench(mesh);
    for (int i = 0; i < 3; ++i) {
        QCOMPARE(check_link(bench.edit, NodeId(i), NodeId((i + 1) % 3)), Verdict::link_condition);
        QCOMPARE(check_link(bench.edit, NodeId(6 + i), NodeId(6 + (i + 1) % 3)),
                 Verdict::link_condition);
    }
}

void SurfaceRulesTest::ordinary_collapses_keep_the_surface_a_manifold() {
    const Workbench<2> square(shapes::square(3));
    QCOMPARE(check_link(square.edit, NodeId(1), NodeId(2)), Verdict::accepted);
    const Workbench<3> cube(shapes::cube(3));
    QCOMPARE(check_link(cube.edit, NodeId(1), NodeId(2)), Verdict::accepted);
    QCOMPARE(check_link(cube.edit, NodeId(5), NodeId(6)), Verdict::accepted);
}

void SurfaceRulesTest::refuses_turns_above_the_limit() {
    // The new side of a dodecagon turns by 15 degrees against the one it replaces.
    float after = 0;
    SurfaceRules rules = everything;
    rules.largest_turn_deg = 14.9;
    QCOMPARE(judge_corner(rules, 1, 0, after), Verdict::surface_normal);
    rules.largest_turn_deg = 15.1;
    QCOMPARE(judge_corner(rules, 1, 0, after), Verdict::accepted);
}

void SurfaceRulesTest::refuses_distances_above_the_limits() {
    const double sagitta = 1 - std::cos(std::numbers::pi / 6);
    const double edge = 2 * std::sin(std::numbers::pi / 6); // the new side
    float after = 0;
    SurfaceRules rules = everything;
    rules.relative_distance = 0.999 * sagitta / edge;
    QCOMPARE(judge_corner(rules, 1, 0, after), Verdict::surface_distance);
    rules.relative_distance = 1.001 * sagitta / edge;
    QCOMPARE(judge_corner(rules, 1, 0, after), Verdict::accepted);
    // What lies behind the faces already counts.
    QCOMPARE(judge_corner(rules, 1, 0.01f, after), Verdict::surface_distance);
    rules = everything;
    rules.layer_share = 0.3;
    QCOMPARE(judge_corner(rules, 0.999 * sagitta / 0.3, 0, after), Verdict::surface_distance);
    QCOMPARE(judge_corner(rules, 1.001 * sagitta / 0.3, 0, after), Verdict::accepted);
}

void SurfaceRulesTest::refuses_faces_that_could_pass_the_elements_on_them() {
    const double sagitta = 1 - std::cos(std::numbers::pi / 6);
    const Mesh<2> mesh = polygon(12);
    const Workbench<2> bench(mesh);
    Cavity<2> ball;
    Star<2> star;
    gather_ball(bench.edit, NodeId(2), ball);
    QCOMPARE(make_star(bench.edit, ball, NodeId(1), star), Verdict::accepted);
    double h = 0; // of the one element on the one new side
    for (const EditElement<2>& e : star.elements) {
        if (e.nodes[2] != bench.edit.ghost()) {
            h = element_metric<2>(corners_of(bench.edit, e.nodes)).sizes[0];
        }
    }
    QCOMPARE_GT(h, 0);
    float after = 0;
    SurfaceRules rules = everything;
    // The side moves by the sagitta, from where it may have been 0.2 off.
    rules.layer_share = 0.999 * (sagitta + 0.2) / h;
    QCOMPARE(judge_corner(rules, 1e9, 0.2f, after), Verdict::surface_distance);
    QCOMPARE(judge_corner(rules, 1e9, 0.19f, after), Verdict::accepted);
}

void SurfaceRulesTest::elements_on_faces_that_have_moved_do_not_become_thin() {
    Workbench<3> bench(shapes::cube(4));
    Cavity<3> ball;
    Star<3> star;
    int thinned = 0, accepted = 0;
    for (const double distance : {0.02, 0.05, 0.1}) {
        for (std::size_t i = 0; i < bench.edit.slot_count(); ++i) {
            if (bench.edit.is_ghost(ElementId(i))) {
                bench.edit.set_measure(ElementId(i), static_cast<float>(distance));
            }
        }
        std::vector<NodeId> neighbours;
        for (const NodeId v : bench.mesh.points.ids()) {
            if (bench.edit.on_boundary(v)) {
                continue;
            }
            gather_ball(bench.edit, v, ball);
            bench.edit.neighbours(v, neighbours);
            for (const NodeId w : neighbours) {
                if (make_star(bench.edit, ball, w, star) != Verdict::accepted) {
                    continue;
                }
                const bool thin = thins_a_layer(bench, ball, star,
                                                static_cast<double>(static_cast<float>(distance)) /
                                                    SurfaceRules().layer_share);
                QCOMPARE(judge_layer(bench.edit, ball, SurfaceRules(), star),
                         thin ? Verdict::surface_distance : Verdict::accepted);
                ++(thin ? thinned : accepted);
            }
        }
    }
    QCOMPARE_GT(thinned, 10);
    QCOMPARE_GT(accepted, 10);
}

void SurfaceRulesTest::adds_the_distance_to_the_bound_of_the_faces_replaced() {
    const double sagitta = 1 - std::cos(std::numbers::pi / 6);
    for (const float before : {0.0f, 0.25f}) {
        float after = 0;
        QCOMPARE(judge_corner(everything, 1, before, after), Verdict::accepted);
        const double expected = static_cast<double>(before) + sagitta;
        QCOMPARE_GE(static_cast<double>(after), expected);
        QCOMPARE_LE(static_cast<double>(after), expected + 1e-7);
    }
}

void SurfaceRulesTest::plane_sides_do_not_move() {
    Workbench<3> cube(shapes::cube(3));
    Cavity<3> ball;
    Star<3> star;
    gather_ball(cube.edit, NodeId(5), ball);
    QCOMPARE(make_star(cube.edit, ball, NodeId(6), star), Verdict::accepted);
    const SurfaceRules strict{
        .largest_turn_deg = 0.01, .relative_distance = 1e-15, .layer_share = 1e-15};
    QCOMPARE(judge_surface(cube.edit, ball, 1, strict, star), Verdict::accepted);
    for (const EditElement<3>& e : star.elements) {
        if (e.nodes[3] == cube.edit.ghost()) {
            QCOMPARE_LE(e.measure, 1e-15f);
        }
    }
}

void SurfaceRulesTest::bounds_stay_above_the_true_distance() {
    accumulate<2>(polygon(48), 400, 20);
    accumulate<3>(ball_of(6), 2000, 100);
}

QTEST_APPLESS_MAIN(SurfaceRulesTest)
#include "surface_rules_test.moc"
