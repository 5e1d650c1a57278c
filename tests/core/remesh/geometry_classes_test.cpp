// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/geometry_classes.h"

#include "tests/core/remesh/round_shapes.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;
using shapes::nodes;

namespace {

template <int D>
std::map<NodeClass, int> counts(const GeometryClasses<D>& classes) {
    std::map<NodeClass, int> out;
    for (const NodeClass c : classes.node) {
        ++out[c];
    }
    return out;
}

using Counts = std::map<NodeClass, int>;

/// Number of coordinates of a point that are 0 or 1: on a face, an edge or a corner of a cube.
template <int D>
int sides_at(const Vec<D>& x) {
    return static_cast<int>((x.array() == 0).count() + (x.array() == 1).count());
}

} // namespace

class GeometryClassesTest : public QObject {
    Q_OBJECT
private slots:
    void a_box_has_corners_ridges_and_sides();
    void a_square_has_four_corners();
    void sharp_edges_are_found_without_patches();
    void smooth_surfaces_have_no_ridges();
    void lines_with_a_sharp_turn_have_a_corner_there();
    void frozen_patches_are_frozen();
    void all_patches_are_frozen_when_the_boundary_is_kept();
    void required_and_listed_entities_are_frozen();
    void interfaces_between_regions_are_frozen();
    void listed_edges_are_kept_with_their_labels();
    void deviations_start_at_zero();
};

void GeometryClassesTest::a_box_has_corners_ridges_and_sides() {
    const Mesh<3> mesh = shapes::cube(4);
    const GeometryClasses<3> classes = classify_geometry(mesh);
    for (const NodeId v : mesh.points.ids()) {
        constexpr std::array by_sides{NodeClass::interior, NodeClass::patch, NodeClass::ridge,
                                      NodeClass::frozen};
        QCOMPARE(classes.node[v], by_sides[static_cast<std::size_t>(sides_at<3>(mesh.points[v]))]);
    }
    QCOMPARE(classes.ridges.size(), std::size_t{12 * 4});
    for (const RidgeEdge& r : classes.ridges) {
        const Vec<3> middle = (mesh.points[r.nodes[0]] + mesh.points[r.nodes[1]]) / 2;
        QCOMPARE(sides_at<3>(middle), 2);
        QVERIFY(r.nodes[0] < r.nodes[1]);
        QVERIFY(!r.listed);
    }
    QVERIFY(
        std::is_sorted(classes.ridges.begin(), classes.ridges.end(),
                       [](const RidgeEdge& a, const RidgeEdge& b) { return a.nodes < b.nodes; }));
}

void GeometryClassesTest::a_square_has_four_corners() {
    const GeometryClasses<2> classes = classify_geometry(shapes::square(4));
    QVERIFY((counts(classes) ==
             Counts{{NodeClass::interior, 9}, {NodeClass::patch, 12}, {NodeClass::frozen, 4}}));
    QVERIFY(classes.ridges.empty());
}

void GeometryClassesTest::sharp_edges_are_found_without_patches() {
    Mesh<3> cube = shapes::cube(3);
    cube.patch.assign(cube.faces.size(), 1);
    QVERIFY((counts(classify_geometry(cube)) == counts(classify_geometry(shapes::cube(3)))));
    // 90 degrees are not sharp for everybody.
    const auto smooth = classify_geometry(cube, {.ridge_angle_deg = 91, .frozen_patches = {}});
    QVERIFY(smooth.ridges.empty());
    QVERIFY((counts(smooth) == Counts{{NodeClass::interior, 8}, {NodeClass::patch, 56}}));
    Mesh<2> square = shapes::square(3);
    square.patch.assign(square.faces.size(), 1);
    QCOMPARE(counts(classify_geometry(square))[NodeClass::frozen], 4);
    QCOMPARE(counts(classify_geometry(
                 square, {.corner_angle_deg = 91, .frozen_patches = {}}))[NodeClass::frozen],
             0);
}

void GeometryClassesTest::smooth_surfaces_have_no_ridges() {
    const GeometryClasses<3> classes = classify_geometry(ball_of(4));
    QVERIFY(classes.ridges.empty());
    QVERIFY((counts(classes) == Counts{{NodeClass::interior, 1}, {NodeClass::patch, 162}}));
    // A change of patch is a line on the smoothest surface.
    Mesh<3> halves = ball_of(4);
    for (const FaceId f : halves.faces.ids()) {
        Vec<3> centre = Vec<3>::Zero();
        for (const NodeId v : halves.faces[f]) {
            centre += halves.points[v];
        }
        halves.patch[f] = centre[2] > 0 ? 2 : 1;
    }
    const GeometryClasses<3> split = classify_geometry(halves);
    QCOMPARE_GT(split.ridges.size(), std::size_t{10});
    for (const RidgeEdge& r : split.ridges) {
        QVERIFY(split.node[r.nodes[0]] == NodeClass::ridge ||
                split.node[r.nodes[0]] == NodeClass::frozen);
    }
}

void GeometryClassesTest::lines_with_a_sharp_turn_have_a_corner_there() {
    // 45 degrees at each node of an octagon, 60 at those of a hexagon.
    QCOMPARE(counts(classify_geometry(polygon(8)))[NodeClass::frozen], 0);
    QCOMPARE(counts(classify_geometry(polygon(8)))[NodeClass::patch], 8);
    QCOMPARE(counts(classify_geometry(polygon(6)))[NodeClass::frozen], 6);
    // Between two patches there is a corner on the straightest line.
    Mesh<2> strip = shapes::square(4);
    for (const FaceId f : strip.faces.ids()) {
        const Vec<2> middle = (strip.points[strip.faces[f][0]] + strip.points[strip.faces[f][1]]);
        if (middle[1] == 0 && middle[0] > 1) {
            strip.patch[f] = 9;
        }
    }
    QCOMPARE(classify_geometry(strip).node[NodeId(2)], NodeClass::frozen);
    QCOMPARE(classify_geometry(strip).node[NodeId(1)], NodeClass::patch);
}

void GeometryClassesTest::frozen_patches_are_frozen() {
    const Mesh<3> mesh = shapes::cube(3);
    const GeometryClasses<3> classes = classify_geometry(mesh, {.frozen_patches = {5}});
    const GeometryClasses<3> free = classify_geometry(mesh);
    for (const NodeId v : mesh.points.ids()) {
        QCOMPARE(classes.node[v], mesh.points[v][2] == 0 ? NodeClass::frozen : free.node[v]);
    }
    const Mesh<2> square = shapes::square(3);
    const GeometryClasses<2> classes2 = classify_geometry(square, {.frozen_patches = {3}});
    QCOMPARE(classes2.node[NodeId(1)], NodeClass::frozen);
    QCOMPARE(classes2.node[NodeId(13)], NodeClass::patch);
}

void GeometryClassesTest::all_patches_are_frozen_when_the_boundary_is_kept() {
    const Mesh<3> mesh = shapes::cube(3);
    const FeatureOptions keep{.frozen_patches = {5}, .boundary = BoundaryChoice::keep};
    const GeometryClasses<3> classes = classify_geometry(mesh, keep);
    QCOMPARE(classes.frozen_patches, (std::vector<int>{1, 2, 3, 4, 5, 6}));
    const GeometryClasses<3> free = classify_geometry(mesh);
    QVERIFY(free.frozen_patches.empty());
    for (const NodeId v : mesh.points.ids()) {
        QCOMPARE(classes.node[v] == NodeClass::frozen, free.node[v] != NodeClass::interior);
    }
}

void GeometryClassesTest::required_and_listed_entities_are_frozen() {
    const auto frozen = [](const Mesh<3>& mesh) {
        const GeometryClasses<3> classes = classify_geometry(mesh);
        const GeometryClasses<3> bare = classify_geometry(shapes::cube(4));
        std::set<int> extra;
        for (const NodeId v : mesh.points.ids()) {
            if (classes.node[v] == NodeClass::frozen && bare.node[v] != NodeClass::frozen) {
                extra.insert(v.value());
            }
        }
        return extra;
    };
    const NodeId inside(62); // the centre
    Mesh<3> mesh = shapes::cube(4);
    mesh.features.required_nodes = {inside};
    QVERIFY((frozen(mesh) == std::set<int>{62}));
    mesh = shapes::cube(4);
    mesh.features.corners = {NodeId(31)};
    QVERIFY((frozen(mesh) == std::set<int>{31}));
    mesh = shapes::cube(4);
    mesh.features.required_elements = {7};
    for (const NodeId v : mesh.elements[ElementId(7)]) {
        QCOMPARE(classify_geometry(mesh).node[v], NodeClass::frozen);
    }
    mesh = shapes::cube(4);
    mesh.features.required_faces = {7};
    for (const NodeId v : mesh.faces[FaceId(7)]) {
        QCOMPARE(classify_geometry(mesh).node[v], NodeClass::frozen);
    }
    // In two dimensions edges are faces.
    Mesh<2> square = shapes::square(4);
    square.features.required_edges = {5};
    square.features.ridges = {8};
    for (const int f : {5, 8}) {
        for (const NodeId v : square.faces[FaceId(f)]) {
            QCOMPARE(classify_geometry(square).node[v], NodeClass::frozen);
        }
    }
}

void GeometryClassesTest::interfaces_between_regions_are_frozen() {
    Mesh<3> mesh = shapes::cube(4);
    split_regions(mesh, 0.5);
    const GeometryClasses<3> free = classify_geometry(shapes::cube(4));
    for (const bool listed : {true, false}) {
        if (!listed) {
            mesh.faces.raw().resize(shapes::cube(4).faces.size());
            mesh.patch.raw().resize(mesh.faces.size());
        }
        const GeometryClasses<3> classes = classify_geometry(mesh);
        for (const NodeId v : mesh.points.ids()) {
            QCOMPARE(classes.node[v], mesh.points[v][0] == 0.5 ? NodeClass::frozen : free.node[v]);
        }
    }
    // A wall with the same region on both sides.
    Mesh<2> square = shapes::square(4);
    square.faces.push_back(nodes(7, 12));
    square.patch.push_back(8);
    const GeometryClasses<2> classes = classify_geometry(square);
    QCOMPARE(classes.node[NodeId(7)], NodeClass::frozen);
    QCOMPARE(classes.node[NodeId(12)], NodeClass::frozen);
    QCOMPARE(classes.node[NodeId(13)], NodeClass::interior);
}

void GeometryClassesTest::listed_edges_are_kept_with_their_labels() {
    Mesh<3> mesh = shapes::cube(4);
    // Two edges in a row on the bottom, one of them declared a ridge, and one on the box's own
    // edge.
    mesh.features.edges = {nodes(7, 6), nodes(7, 8), nodes(1, 2)};
    mesh.features.edge_labels = {4, 4, 9};
    mesh.features.ridges = {1};
    const GeometryClasses<3> classes = classify_geometry(mesh);
    QCOMPARE(classes.ridges.size(), std::size_t{12 * 4 + 2});
    const auto find = [&](const Edge& e) {
        const auto at = std::find_if(classes.ridges.begin(), classes.ridges.end(),
                                     [&](const RidgeEdge& r) { return r.nodes == e; });
        return at == classes.ridges.end() ? RidgeEdge{} : *at;
    };
    QVERIFY((find(nodes(6, 7)) == RidgeEdge{nodes(6, 7), 4, true, false}));
    QVERIFY((find(nodes(7, 8)) == RidgeEdge{nodes(7, 8), 4, true, true}));
    QVERIFY((find(nodes(1, 2)) == RidgeEdge{nodes(1, 2), 9, true, false}));
    QVERIFY((find(nodes(2, 3)) == RidgeEdge{nodes(2, 3), 0, false, false}));
    QCOMPARE(classes.node[NodeId(7)], NodeClass::ridge);
    QCOMPARE(classes.node[NodeId(6)], NodeClass::frozen); // the line's ends
    QCOMPARE(classes.node[NodeId(8)], NodeClass::frozen);
    QCOMPARE(classes.node[NodeId(2)], NodeClass::frozen); // the label changes
    QCOMPARE(classes.node[NodeId(3)], NodeClass::ridge);
}

void GeometryClassesTest::deviations_start_at_zero() {
    const Mesh<3> mesh = shapes::cube(2);
    const GeometryClasses<3> classes = classify_geometry(mesh);
    QCOMPARE(classes.deviation.size(), mesh.faces.size());
    QVERIFY(std::all_of(classes.deviation.begin(), classes.deviation.end(),
                        [](double d) { return d == 0; }));
}

QTEST_APPLESS_MAIN(GeometryClassesTest)
#include "geometry_classes_test.moc"
