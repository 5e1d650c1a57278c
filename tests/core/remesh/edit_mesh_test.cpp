// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/edit_mesh.h"

#include "core/cases/cube.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;
using shapes::nodes;

namespace {

/// Nodes with their orientation and label, the same for every way to write them.
template <std::size_t N>
struct Entity {
    std::array<NodeId, N> nodes;
    bool odd;
    int label;
    friend auto operator<=>(const Entity&, const Entity&) = default;
};

template <std::size_t N>
Entity<N> entity(const std::array<NodeId, N>& nodes, int label) {
    return {sorted(nodes), oppositely_oriented(sorted(nodes), nodes), label};
}

template <int D>
std::set<Entity<D + 1>> elements_of(const Mesh<D>& mesh) {
    std::set<Entity<D + 1>> set;
    for (const ElementId e : mesh.elements.ids()) {
        set.insert(entity(mesh.elements[e], mesh.region[e]));
    }
    return set;
}

template <int D>
std::set<Entity<D>> faces_of(const Mesh<D>& mesh) {
    std::set<Entity<D>> set;
    for (const FaceId f : mesh.faces.ids()) {
        set.insert(entity(mesh.faces[f], mesh.patch[f]));
    }
    return set;
}

/// The entities behind a list of indices.
template <class Tuples>
auto chosen(const Tuples& tuples, const std::vector<int>& ids) {
    std::set<std::decay_t<decltype(sorted(tuples.raw()[0]))>> set;
    for (const int i : ids) {
        set.insert(sorted(tuples.raw().at(static_cast<std::size_t>(i))));
    }
    return set;
}

std::set<Entity<2>> edges_with_labels(const Features& features) {
    std::set<Entity<2>> set;
    for (std::size_t i = 0; i < features.edges.size(); ++i) {
        set.insert({sorted(features.edges[i]), false, features.edge_labels[i]});
    }
    return set;
}

template <int D>
void compare_features(const Mesh<D>& a, const Mesh<D>& b) {
    QVERIFY(a.features.corners == b.features.corners);
    QVERIFY(a.features.required_nodes == b.features.required_nodes);
    QVERIFY(chosen(a.elements, a.features.required_elements) ==
            chosen(b.elements, b.features.required_elements));
    QVERIFY(chosen(a.faces, a.features.required_faces) ==
            chosen(b.faces, b.features.required_faces));
    QVERIFY(edges_with_labels(a.features) == edges_with_labels(b.features));
    if constexpr (D == 2) {
        QVERIFY(chosen(a.faces, a.features.ridges) == chosen(b.faces, b.features.ridges));
        QVERIFY(chosen(a.faces, a.features.required_edges) ==
                chosen(b.faces, b.features.required_edges));
    } else {
        const IdVector<FaceId, Edge> edges_a(a.features.edges), edges_b(b.features.edges);
        QVERIFY(chosen(edges_a, a.features.ridges) == chosen(edges_b, b.features.ridges));
        QVERIFY(chosen(edges_a, a.features.required_edges) ==
                chosen(edges_b, b.features.required_edges));
    }
}

template <int D>
void compare(const Mesh<D>& a, const Mesh<D>& b) {
    QVERIFY(a.points == b.points);
    QVERIFY(a.labels == b.labels);
    QCOMPARE(a.elements.size(), b.elements.size());
    QVERIFY(elements_of(a) == elements_of(b));
    QCOMPARE(a.faces.size(), b.faces.size());
    QVERIFY(faces_of(a) == faces_of(b));
    QVERIFY(a.patch_names == b.patch_names);
    compare_features(a, b);
}

/// A mesh with something of everything.
template <int D>
Mesh<D> rich_mesh() {
    Mesh<D> mesh = make_cube<D>({.n = 3, .diagonals = Diagonals::random, .shuffle = 5});
    split_regions(mesh, 0.5);
    mesh.patch_names = {{1, "bottom"}, {20, "interface"}};
    for (const NodeId v : mesh.points.ids()) {
        mesh.labels.push_back(100 + v.value());
    }
    mesh.features.corners = {mesh.elements[ElementId(0)][0]};
    mesh.features.required_nodes = {NodeId(3), NodeId(7)};
    mesh.features.required_elements = {2, 9};
    if constexpr (D == 2) {
        mesh.features.ridges = {1, 4};
        mesh.features.required_edges = {2, 3};
    } else {
        // Edges of faces, so that they exist; the third one is inside the domain.
        const auto& f = mesh.faces;
        const auto inside = f[FaceId(f.size() - 1)];
        mesh.features.edges = {{f[FaceId(0)][1], f[FaceId(0)][0]},
                               {f[FaceId(6)][0], f[FaceId(6)][1]},
                               {inside[0], inside[1]}};
        mesh.features.edge_labels = {5, 6, 7};
        mesh.features.ridges = {1};
        mesh.features.required_edges = {0, 2};
        mesh.features.required_faces = {4, 8};
    }
    return mesh;
}

template <int D>
void return_what_was_put_in() {
    const Mesh<D> mesh = rich_mesh<D>();
    QVERIFY2(check(mesh).valid(), check(mesh).summary().c_str());
    const GeometryClasses<D> classes = classify_geometry(mesh);
    const auto compact = EditMesh<D>(mesh, classes).compact();
    compare(mesh, compact.mesh);
    QVERIFY2(check(compact.mesh).valid(), check(compact.mesh).summary().c_str());
    QVERIFY(compact.classes.node == classes.node);
    QVERIFY(compact.classes.ridges == classes.ridges);
    QCOMPARE(compact.classes.deviation.size(), mesh.faces.size());
    for (const NodeId v : mesh.points.ids()) {
        QCOMPARE(compact.parent[v].value(), v.value());
    }
}

template <int D>
void compare_balls() {
    const Mesh<D> mesh = rich_mesh<D>();
    const EditMesh<D> edit(mesh, classify_geometry(mesh));
    for (const NodeId v : edit.nodes()) {
        std::set<ElementId> brute;
        for (std::size_t i = 0; i < edit.slot_count(); ++i) {
            const Simplex<D>& s = edit.nodes(ElementId(i));
            if (std::find(s.begin(), s.end(), v) != s.end()) {
                brute.insert(ElementId(i));
            }
        }
        const auto ball = edit.ball(v);
        QCOMPARE(ball.size(), brute.size());
        QVERIFY(std::set<ElementId>(ball.begin(), ball.end()) == brute);
    }
}

/// Every facet of real and ghost elements is shared by two, which see it from opposite sides.
template <int D>
void verify_closed(const EditMesh<D>& edit) {
    std::map<Facet<D>, std::vector<Facet<D>>> uses;
    std::size_t ghosts = 0;
    for (std::size_t i = 0; i < edit.slot_count(); ++i) {
        if (edit.is_free(ElementId(i))) {
            continue;
        }
        ghosts += edit.is_ghost(ElementId(i));
        for (int k = 0; k <= D; ++k) {
            const Facet<D> f = facet_of<D>(edit.nodes(ElementId(i)), k);
            uses[sorted(f)].push_back(f);
        }
    }
    QCOMPARE_GT(ghosts, std::size_t{0});
    for (const auto& [key, facets] : uses) {
        QCOMPARE(facets.size(), std::size_t{2});
        QVERIFY(oppositely_oriented(facets[0], facets[1]));
    }
}

template <int D>
void keep_balls_after_replacing() {
    const Mesh<D> mesh = make_cube<D>({.n = 3});
    Workbench<D> bench(mesh);
    // The node in the middle of the mesh leaves along an edge that allows it.
    Cavity<D> ball;
    Star<D> star;
    NodeId removed;
    for (const NodeId v : bench.edit.nodes()) {
        if (bench.edit.node_class(v) != NodeClass::interior || removed.valid()) {
            continue;
        }
        gather_ball(bench.edit, v, ball);
        for (const NodeId w : neighbours(bench.edit, v)) {
            if (!removed.valid() && make_star(bench.edit, ball, w, star) == Verdict::accepted) {
                bench.edit.replace(ball.elements, star.elements, star.sources);
                removed = v;
            }
        }
    }
    QVERIFY(removed.valid());
    QVERIFY(bench.edit.is_removed(removed));
    verify_closed(bench.edit);
    const auto compact = bench.edit.compact();
    QVERIFY2(check(compact.mesh).valid(), check(compact.mesh).summary().c_str());
    QCOMPARE(compact.mesh.points.size(), mesh.points.size() - 1);
    for (const NodeId v : compact.parent.ids()) {
        QVERIFY(compact.mesh.points[v] == mesh.points[compact.parent[v]]);
        QVERIFY(compact.parent[v] != removed);
    }
}

} // namespace

class EditMeshTest : public QObject {
    Q_OBJECT
private slots:
    void returns_the_mesh_that_was_put_in();
    void balls_agree_with_brute_force();
    void ghost_elements_close_the_mesh();
    void ghost_elements_hold_their_face();
    void knows_what_is_on_the_boundary();
    void stays_closed_and_loses_one_node_when_a_ball_is_replaced();
};

void EditMeshTest::returns_the_mesh_that_was_put_in() {
    return_what_was_put_in<2>();
    return_what_was_put_in<3>();
}

void EditMeshTest::balls_agree_with_brute_force() {
    compare_balls<2>();
    compare_balls<3>();
}

void EditMeshTest::ghost_elements_close_the_mesh() {
    const Mesh<2> square = rich_mesh<2>();
    verify_closed(EditMesh<2>(square, classify_geometry(square)));
    const Mesh<3> cube = rich_mesh<3>();
    verify_closed(EditMesh<3>(cube, classify_geometry(cube)));
}

void EditMeshTest::ghost_elements_hold_their_face() {
    const NodeId ghost(9);
    QVERIFY(ghost_face<2>(ghost_simplex<2>(nodes(4, 2), ghost)) == nodes(4, 2));
    QVERIFY(ghost_face<3>(ghost_simplex<3>(nodes(4, 2, 7), ghost)) == nodes(4, 2, 7));
    QVERIFY(ghost_simplex<2>(nodes(4, 2), ghost)[2] == ghost);
    QVERIFY(ghost_simplex<3>(nodes(4, 2, 7), ghost)[3] == ghost);
}

void EditMeshTest::knows_what_is_on_the_boundary() {
    Mesh<3> mesh = shapes::cube(2);
    split_regions(mesh, 0.5);
    mesh.features.required_faces = {0};
    const EditMesh<3> edit(mesh, classify_geometry(mesh));
    for (const NodeId v : edit.nodes()) {
        const bool inside = v == NodeId(13); // the centre, on the interface
        QCOMPARE(edit.on_boundary(v), !inside);
    }
    QVERIFY(edit.has_protected_inside());
    QVERIFY(edit.is_required(mesh.faces[FaceId(0)]));
    QVERIFY(!edit.is_required(mesh.faces[FaceId(1)]));
    QVERIFY(edit.is_ridge(NodeId(0), NodeId(1)));
    QVERIFY(edit.is_ridge(NodeId(1), NodeId(0)));
    QVERIFY(!edit.is_ridge(NodeId(0), NodeId(13)));
}

void EditMeshTest::stays_closed_and_loses_one_node_when_a_ball_is_replaced() {
    keep_balls_after_replacing<2>();
    keep_balls_after_replacing<3>();
}

QTEST_APPLESS_MAIN(EditMeshTest)
#include "edit_mesh_test.moc"
