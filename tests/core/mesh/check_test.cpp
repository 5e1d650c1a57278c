// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/check.h"

#include "core/base/parallel.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace ameco;
using shapes::nodes;

namespace {

/// What was found, and how often: {{Defect::flat_element, 1}, ...}.
std::map<Defect, std::int64_t> counts(const std::vector<Finding>& findings) {
    std::map<Defect, std::int64_t> result;
    for (const Finding& f : findings) {
        result[f.defect] = f.count;
    }
    return result;
}

using Counts = std::map<Defect, std::int64_t>;

/// Compares the errors of a mesh with the expected ones; the failure shows the whole summary.
#define EXPECT_ERRORS(report, ...)                                                                 \
    QVERIFY2(counts((report).errors) == Counts(__VA_ARGS__), (report).summary().c_str())
#define EXPECT_EXAMPLE(report, text) QCOMPARE((report).errors.at(0).example, std::string(text))

/// Two unit right triangles or tets that share nothing but `nodes`, by renumbering the second.
Mesh<3> touching_tets(int shared) {
    if (shared == 1) {
        return shapes::from_literals<3>(
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
            {nodes(0, 1, 2, 3), nodes(0, 5, 4, 6)});
    }
    return shapes::from_literals<3>(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, -1, -1}},
        {nodes(0, 1, 2, 3), nodes(0, 1, 4, 5)});
}

} // namespace

class CheckTest : public QObject {
    Q_OBJECT
private slots:
    void accepts_valid_meshes();
    void adds_up_volumes_of_stretched_meshes();
    void finds_no_elements();
    void finds_references_out_of_range_data();
    void finds_references_out_of_range();
    void finds_coordinates_that_are_not_finite();
    void finds_repeated_nodes();
    void finds_duplicate_elements();
    void finds_inverted_elements();
    void finds_flat_elements_exactly();
    void warns_of_orphans();
    void finds_facets_shared_by_three_elements();
    void finds_two_elements_on_the_same_side();
    void finds_missing_faces();
    void finds_faces_without_element();
    void finds_duplicate_faces();
    void finds_faces_turned_inward();
    void finds_boundaries_that_touch_themselves();
    void finds_volumes_that_do_not_add_up();
    void allows_interior_faces();
    void names_all_errors_in_one_line();
    void names_every_defect();
    void does_not_depend_on_the_number_of_threads();
};

void CheckTest::accepts_valid_meshes() {
    EXPECT_ERRORS(check(shapes::single_triangle()), {});
    EXPECT_ERRORS(check(shapes::single_tet()), {});
    EXPECT_ERRORS(check(shapes::two_tets()), {});
    const CheckReport square = check(shapes::square(5));
    EXPECT_ERRORS(square, {});
    QVERIFY(square.warnings.empty());
    QCOMPARE(square.volume, 1.0);
    QCOMPARE(square.boundary_flux, 1.0);
    const CheckReport cube = check(shapes::cube(4));
    EXPECT_ERRORS(cube, {});
    QVERIFY(cube.warnings.empty());
    QCOMPARE(cube.volume, 1.0);
    QCOMPARE(cube.boundary_flux, 1.0);
    QCOMPARE(cube.interior_faces, 0);
}

void CheckTest::adds_up_volumes_of_stretched_meshes() {
    EXPECT_ERRORS(check(shapes::stretched_slab(4, 30, 1e-9)), {});
    EXPECT_ERRORS(check(shapes::stretched_strip(4, 60, 1e-9)), {});
    // Far from the origin, where coordinates have fewer digits left for the layers.
    Mesh<3> far = shapes::stretched_slab(4, 30, 1e-9);
    for (Vec<3>& x : far.points) {
        x.array() += 1000;
    }
    const CheckReport report = check(far);
    for (const Finding& f : report.errors) {
        QCOMPARE(name(f.defect), name(Defect::flat_element)); // of layers that were rounded away
    }
}

void CheckTest::finds_no_elements() {
    EXPECT_ERRORS(check(Mesh<2>()), {{Defect::no_elements, 1}});
    Mesh<3> mesh = shapes::single_tet();
    mesh.elements.clear();
    EXPECT_ERRORS(check(mesh), {{Defect::no_elements, 1}});
}

void CheckTest::finds_references_out_of_range_data() {
    QTest::addColumn<Mesh<3>>("mesh");
    QTest::addColumn<QString>("example");
    const auto row = [](const char* name, const char* example, auto damage) {
        Mesh<3> mesh = shapes::two_tets();
        mesh.features.edges = {nodes(0, 1)};
        mesh.features.edge_labels = {1};
        damage(mesh);
        QTest::newRow(name) << mesh << example;
    };
    row("element", "element 1 refers to node 5, but there are 5",
        [](Mesh<3>& m) { m.elements[ElementId(1)][2] = NodeId(5); });
    row("none", "element 0 refers to node -1, but there are 5",
        [](Mesh<3>& m) { m.elements[ElementId(0)][2] = NodeId(); });
    row("face", "face 2 refers to node 1000000, but there are 5",
        [](Mesh<3>& m) { m.faces[FaceId(2)][0] = NodeId(1000000); });
    row("edge", "feature edge 0 refers to node 7, but there are 5",
        [](Mesh<3>& m) { m.features.edges[0][1] = NodeId(7); });
    row("corner", "corner 1 refers to node -2, but there are 5", [](Mesh<3>& m) {
        m.features.corners = {NodeId(4), NodeId(-2)};
    });
    row("required node", "required node 0 refers to node 5, but there are 5",
        [](Mesh<3>& m) { m.features.required_nodes = {NodeId(5)}; });
    row("ridge", "ridge 0 refers to edge 1, but there are 1",
        [](Mesh<3>& m) { m.features.ridges = {1}; });
    row("required edge", "required edge 1 refers to edge -1, but there are 1", [](Mesh<3>& m) {
        m.features.required_edges = {0, -1};
    });
    row("required face", "required face 0 refers to face 6, but there are 6",
        [](Mesh<3>& m) { m.features.required_faces = {6}; });
    row("required element", "required element 0 refers to element 2, but there are 2",
        [](Mesh<3>& m) { m.features.required_elements = {2}; });
}

void CheckTest::finds_references_out_of_range() {
    QFETCH(Mesh<3>, mesh);
    QFETCH(QString, example);
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::node_out_of_range, 1}});
    EXPECT_EXAMPLE(report, example.toStdString());
}

void CheckTest::finds_coordinates_that_are_not_finite() {
    Mesh<3> mesh = shapes::two_tets();
    mesh.points[NodeId(3)][1] = std::numeric_limits<double>::quiet_NaN();
    mesh.points[NodeId(4)][0] = std::numeric_limits<double>::infinity();
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::not_finite, 2}});
    EXPECT_EXAMPLE(report, "node 3");
}

void CheckTest::finds_repeated_nodes() {
    Mesh<3> mesh = shapes::two_tets();
    mesh.elements[ElementId(1)][3] = NodeId(0);
    mesh.faces[FaceId(2)][0] = mesh.faces[FaceId(2)][1];
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::repeated_node, 2}});
    EXPECT_EXAMPLE(report, "element 1 (nodes 0 2 1 0)");
    Mesh<2> flat = shapes::single_triangle();
    flat.faces[FaceId(1)] = nodes(2, 2);
    const CheckReport report_2d = check(flat);
    EXPECT_ERRORS(report_2d, {{Defect::repeated_node, 1}});
    EXPECT_EXAMPLE(report_2d, "face 1 (nodes 2 2)");
}

void CheckTest::finds_duplicate_elements() {
    Mesh<3> mesh = shapes::cube(2);
    const Simplex<3> s = mesh.elements[ElementId(20)];
    mesh.elements.push_back({s[1], s[2], s[0], s[3]}); // an even permutation
    mesh.region.push_back(1);
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::duplicate_element, 1}});
    QVERIFY(report.errors[0].example.starts_with("elements 20 and 48 (nodes "));
    Mesh<2> flat = shapes::single_triangle();
    flat.elements.push_back(nodes(1, 2, 0));
    flat.elements.push_back(nodes(2, 0, 1));
    EXPECT_ERRORS(check(flat), {{Defect::duplicate_element, 2}});
}

void CheckTest::finds_inverted_elements() {
    Mesh<3> mesh = shapes::cube(2);
    Simplex<3>& s = mesh.elements[ElementId(7)];
    std::swap(s[0], s[1]);
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::inverted_element, 1}});
    QVERIFY(report.errors[0].example.starts_with("element 7 (nodes "));

    // Pulled through the opposite facet: the numbering is right, the geometry is not.
    Mesh<2> tangled = shapes::square(4);
    tangled.points[NodeId(12)] = {-0.5, 0.5};
    const CheckReport report_2d = check(tangled);
    QCOMPARE(counts(report_2d.errors).size(), std::size_t{1});
    QVERIFY(counts(report_2d.errors)[Defect::inverted_element] >= 1);
}

void CheckTest::finds_flat_elements_exactly() {
    Mesh<2> mesh = shapes::from_literals<2>({{0, 0}, {1, 0}, {0.5, 0}}, {nodes(0, 1, 2)});
    EXPECT_ERRORS(check(mesh), {{Defect::flat_element, 1}});
    EXPECT_EXAMPLE(check(mesh), "element 0 (nodes 0 1 2)");
    mesh.points[NodeId(2)][1] = std::numeric_limits<double>::denorm_min();
    EXPECT_ERRORS(check(mesh), {});
    mesh.points[NodeId(2)][1] = -std::numeric_limits<double>::denorm_min();
    EXPECT_ERRORS(check(mesh), {{Defect::inverted_element, 1}});
    mesh.points[NodeId(2)] = {0.3, 0.3};
    mesh.points[NodeId(1)] = {0.1, 0.1};
    EXPECT_ERRORS(check(mesh), {{Defect::flat_element, 1}});

    Mesh<3> tet = shapes::from_literals<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.2, 0.3}},
                                           {nodes(0, 1, 2, 3)});
    tet.points[NodeId(3)][2] = 0;
    EXPECT_ERRORS(check(tet), {{Defect::flat_element, 1}});
}

void CheckTest::warns_of_orphans() {
    Mesh<3> mesh = shapes::cube(1);
    mesh.points.push_back({5, 5, 5});
    const CheckReport report = check(mesh);
    QVERIFY(report.valid());
    QCOMPARE(counts(report.warnings), (Counts{{Defect::orphan_node, 1}}));
    QCOMPARE(report.warnings[0].example, std::string("node 8"));
}

void CheckTest::finds_facets_shared_by_three_elements() {
    const Mesh<2> mesh = shapes::from_literals<2>({{0, 0}, {1, 0}, {0, 1}, {0, -1}, {0.5, 2}},
                                                  {nodes(0, 1, 2), nodes(1, 0, 3), nodes(0, 1, 4)});
    const auto found = counts(check(mesh).errors);
    QCOMPARE(found.at(Defect::facet_shared_too_often), 1);
    EXPECT_EXAMPLE(check(mesh), "element 0 (nodes 0 1 2) and element 1 (nodes 1 0 3)");
}

void CheckTest::finds_two_elements_on_the_same_side() {
    const Mesh<3> mesh =
        shapes::from_literals<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 2}},
                                 {nodes(0, 1, 2, 3), nodes(0, 1, 2, 4)});
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::facet_shared_too_often, 1}});
    EXPECT_EXAMPLE(report, "element 0 (nodes 0 1 2 3) and element 1 (nodes 0 1 2 4)");
}

void CheckTest::finds_missing_faces() {
    Mesh<3> mesh = shapes::single_tet();
    mesh.faces.raw().erase(mesh.faces.begin()); // nodes 0 1 2, opposite node 3
    mesh.patch.raw().erase(mesh.patch.begin());
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::boundary_without_face, 1}, {Defect::boundary_not_closed, 3}});
    EXPECT_EXAMPLE(report, "the side of element 0 (nodes 0 1 2 3) on nodes 0 2 1");
    QCOMPARE(report.errors[1].example, std::string("edge (nodes 0 1)"));

    Mesh<2> flat = shapes::square(2);
    flat.faces.raw().pop_back();
    flat.patch.raw().pop_back();
    EXPECT_ERRORS(check(flat),
                  {{Defect::boundary_without_face, 1}, {Defect::boundary_not_closed, 2}});
}

void CheckTest::finds_faces_without_element() {
    Mesh<3> mesh = shapes::cube(2);
    mesh.faces.push_back(nodes(0, 13, 26)); // not in any tet: its edges skip a cell
    mesh.patch.push_back(9);
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::face_without_element, 1}});
    EXPECT_EXAMPLE(report, "face 48 (nodes 0 13 26)");
}

void CheckTest::finds_duplicate_faces() {
    Mesh<3> mesh = shapes::single_tet();
    const Facet<3> f = mesh.faces[FaceId(2)];
    mesh.faces.push_back({f[2], f[0], f[1]});
    mesh.patch.push_back(1);
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::duplicate_face, 1}});
    EXPECT_EXAMPLE(report, "faces 2 and 4 (nodes 0 3 2)");
}

void CheckTest::finds_faces_turned_inward() {
    Mesh<3> mesh = shapes::cube(2);
    for (const int i : {3, 17}) {
        Facet<3>& f = mesh.faces[FaceId(i)];
        std::swap(f[0], f[1]);
    }
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {{Defect::face_turned_inward, 2}});
    QVERIFY(report.errors[0].example.starts_with("face 3 (nodes "));
    Mesh<2> flat = shapes::square(2);
    std::swap(flat.faces[FaceId(0)][0], flat.faces[FaceId(0)][1]);
    EXPECT_ERRORS(check(flat), {{Defect::face_turned_inward, 1}});
}

void CheckTest::finds_boundaries_that_touch_themselves() {
    const CheckReport at_node = check(touching_tets(1));
    EXPECT_ERRORS(at_node, {{Defect::node_not_manifold, 1}});
    EXPECT_EXAMPLE(at_node, "node 0, where 2 fans of boundary faces touch");
    const CheckReport at_edge = check(touching_tets(2));
    EXPECT_ERRORS(at_edge, {{Defect::boundary_not_manifold, 1}});
    EXPECT_EXAMPLE(at_edge, "edge (nodes 0 1)");
    const Mesh<2> bow_tie = shapes::from_literals<2>({{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}},
                                                     {nodes(0, 1, 2), nodes(0, 3, 4)});
    const CheckReport report_2d = check(bow_tie);
    EXPECT_ERRORS(report_2d, {{Defect::boundary_not_manifold, 1}});
    EXPECT_EXAMPLE(report_2d, "node 0");
}

void CheckTest::finds_volumes_that_do_not_add_up() {
    // Products of coordinates this large are infinite.
    Mesh<3> mesh = shapes::cube(1);
    for (Vec<3>& x : mesh.points) {
        x *= 1e120;
    }
    EXPECT_ERRORS(check(mesh), {{Defect::volumes_do_not_add_up, 1}});
}

void CheckTest::allows_interior_faces() {
    Mesh<3> mesh = shapes::box({0, 1, 2, 3}, {0, 1, 2}, {0, 1, 2});
    // The plane x = 1, from wall to wall: at its rim three faces meet, two of them boundary faces.
    std::map<Facet<3>, Facet<3>> inside;
    for (const Simplex<3>& s : mesh.elements) {
        for (int i = 0; i < 4; ++i) {
            const Facet<3> f = facet_of<3>(s, i);
            if (std::all_of(f.begin(), f.end(),
                            [&](NodeId v) { return mesh.points[v][0] == 1.0; })) {
                inside[sorted(f)] = f;
            }
        }
    }
    for (const auto& [key, f] : inside) {
        mesh.faces.push_back(f);
        mesh.patch.push_back(7);
    }
    const CheckReport report = check(mesh);
    EXPECT_ERRORS(report, {});
    QVERIFY(report.warnings.empty());
    QCOMPARE(report.interior_faces, 8);
    QCOMPARE(report.volume, 12.0);
}

void CheckTest::names_all_errors_in_one_line() {
    Mesh<3> mesh = shapes::single_tet();
    mesh.faces.clear();
    mesh.patch.clear();
    mesh.points[NodeId(3)][2] = -1;
    QCOMPARE(check(mesh).summary(),
             std::string("1 x inverted element, first: element 0 (nodes 0 1 2 3); 4 x boundary "
                         "facet without face, first: the side of element 0 (nodes 0 1 2 3) on "
                         "nodes 1 2 3"));
    QCOMPARE(check(shapes::single_tet()).summary(), std::string());
}

void CheckTest::names_every_defect() {
    std::vector<std::string_view> names;
    for (int d = 0; d <= static_cast<int>(Defect::volumes_do_not_add_up); ++d) {
        names.push_back(name(static_cast<Defect>(d)));
        QVERIFY(!names.back().empty());
    }
    std::sort(names.begin(), names.end());
    QVERIFY(std::adjacent_find(names.begin(), names.end()) == names.end());
    QCOMPARE(name(Defect::boundary_not_manifold), std::string_view("non-manifold boundary"));
}

void CheckTest::does_not_depend_on_the_number_of_threads() {
    Mesh<2> mesh = shapes::stretched_strip(150, 150, 1e-9, 1.1); // several pieces of everything
    for (const std::size_t i : {43210u, 20000u, 700u}) {
        std::swap(mesh.elements[ElementId(i)][0], mesh.elements[ElementId(i)][1]);
        mesh.elements.push_back(mesh.elements[ElementId(i + 100)]);
        mesh.region.push_back(1);
    }
    mesh.faces.raw().erase(mesh.faces.begin() + 17);
    mesh.patch.raw().erase(mesh.patch.begin() + 17);
    set_thread_count(1);
    const CheckReport one = check(mesh);
    set_thread_count(2);
    const CheckReport two = check(mesh);
    set_thread_count(0);
    EXPECT_ERRORS(one, {{Defect::duplicate_element, 3},
                        {Defect::inverted_element, 3},
                        {Defect::boundary_without_face, 1},
                        {Defect::boundary_not_closed, 2}});
    QCOMPARE(one.summary(), two.summary());
    QVERIFY(one.volume == two.volume); // to the bit
    QVERIFY(one.boundary_flux == two.boundary_flux);
}

QTEST_APPLESS_MAIN(CheckTest)
#include "check_test.moc"
