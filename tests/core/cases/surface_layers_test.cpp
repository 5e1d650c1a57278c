// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/surface_layers.h"

#include "core/base/error.h"
#include "core/cases/surface_columns.h"
#include "core/mesh/check.h"
#include "core/metric/aspect_ratio.h"
#include "core/metric/nodal_metric.h"
#include "tests/core/surface/surfaces.h"

#include "core/surface/surface_normals.h"

#include <QtTest>

using namespace ameco;

class SurfaceLayersTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void columns_of_a_sphere_are_its_radii();
    void layers_keep_their_distance_from_the_faces();
    void bodies_are_meshed_without_overlap_data();
    void bodies_are_meshed_without_overlap();
    void columns_that_face_each_other_share_the_gap();
    void a_node_that_sees_not_all_of_its_faces_has_no_layers();
    void patches_of_the_body_are_kept();
    void refuses_what_it_cannot_do();
};

namespace {

SurfaceLayerOptions options_with(double first_height, double growth, int layers) {
    SurfaceLayerOptions options;
    options.first_height = first_height;
    options.growth = growth;
    options.layers = layers;
    options.farfield = farfield_from("sphere:20");
    return options;
}

SurfaceColumns columns_of(const Mesh<3>& surface, const SurfaceLayerOptions& options) {
    return find_columns(surface, options, "a.stl", Monitor::silent());
}

/// The boundary of the cubes of a 3 x 3 x 3 block that are listed, each cut n times.
Mesh<3> blocks(const std::vector<std::array<int, 3>>& kept, int n) {
    Mesh<3> mesh = shapes::cube(3 * n);
    IdVector<ElementId, Simplex<3>> elements;
    for (const Simplex<3>& s : mesh.elements) {
        const Vec<3> x =
            (mesh.points[s[0]] + mesh.points[s[1]] + mesh.points[s[2]] + mesh.points[s[3]]) * 0.75;
        const std::array<int, 3> block{static_cast<int>(x[0]), static_cast<int>(x[1]),
                                       static_cast<int>(x[2])};
        if (std::find(kept.begin(), kept.end(), block) != kept.end()) {
            elements.push_back(s);
        }
    }
    mesh.elements = elements;
    mesh.region.assign(elements.size(), 1);
    mesh.faces.clear();
    mesh.patch.clear();
    shapes::add_boundary(mesh);
    return boundary_surface(mesh);
}

/// Among others an L, a U (two legs that face each other), and a corner where a bar turns twice:
/// the sides at the node in its middle look along +y and along -y.
Mesh<3> body(const QString& name) {
    if (name == "sphere") {
        return surfaces::sphere(6);
    }
    if (name == "torus") {
        return surfaces::torus(30, 16);
    }
    if (name == "cube") {
        return surfaces::cube(4);
    }
    if (name == "L") {
        return blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2);
    }
    if (name == "U") {
        return blocks({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}, 2);
    }
    return blocks({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}, 2);
}

} // namespace

void SurfaceLayersTest::initTestCase() {
    if (!can_recover()) {
        QSKIP("built without TetGen");
    }
}

void SurfaceLayersTest::columns_of_a_sphere_are_its_radii() {
    const Mesh<3> surface = surfaces::sphere(12);
    const SurfaceColumns columns = columns_of(surface, options_with(1e-6, 1.3, 20));
    QCOMPARE(columns.distance.size(), std::size_t{21});
    QVERIFY(std::abs(columns.distance[2] - 2.3e-6) < 1e-20);
    for (const NodeId v : surface.points.ids()) {
        QCOMPARE(columns.share[v], 1.0);
        QVERIFY(columns.step[v].normalized().dot(surface.points[v]) > 0.9999);
    }
}

void SurfaceLayersTest::layers_keep_their_distance_from_the_faces() {
    const Mesh<3> surface = surfaces::cube(4);
    SurfaceLayerOptions options = options_with(1e-3, 1, 1);
    options.smoothing = 0;
    const SurfaceColumns columns = columns_of(surface, options);
    for (const NodeId v : surface.points.ids()) {
        // Outside by the same distance from each side the node is on.
        const Vec<3> x = columns.point(surface, v, 1);
        for (int i = 0; i < 3; ++i) {
            if (surface.points[v][i] == 1) {
                QVERIFY(std::abs(x[i] - 1.001) < 1e-12);
            }
        }
    }
}

void SurfaceLayersTest::bodies_are_meshed_without_overlap_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("height");
    for (const char* name : {"sphere", "torus", "cube", "L", "U", "corner"}) {
        QTest::addRow("%s, thin", name) << name << 1e-7;
        QTest::addRow("%s, thick", name) << name << 1e-2; // 0.26 together
    }
}

void SurfaceLayersTest::bodies_are_meshed_without_overlap() {
    QFETCH(QString, name);
    QFETCH(double, height);
    const Mesh<3> surface = body(name);
    const SurfaceLayers made = make_surface_layers(surface, options_with(height, 1.2, 10), "a.stl");
    // All volumes positive within a boundary that does not intersect itself: every point of the
    // space is covered once.
    const CheckReport report = check(made.mesh);
    QVERIFY2(report.valid(), report.summary().c_str());
    QCOMPARE(made.columns, static_cast<std::int64_t>(surface.points.size()));
    QCOMPARE(made.layer_nodes, made.columns + 10 * (made.columns - made.collapsed));
    QVERIFY(made.collapsed < made.columns / 10);
    QCOMPARE(std::count(made.share.begin(), made.share.end(), 0.0), made.collapsed);
    if (height < 1e-6) {
        QVERIFY(summarise_aspect_ratios(nodal_metric(made.mesh)).max > 1e4);
    }
    if (name == "sphere") {
        QCOMPARE(made.shrunk + made.collapsed, std::int64_t{0});
    }
}

void SurfaceLayersTest::columns_that_face_each_other_share_the_gap() {
    const Mesh<3> surface = body("U"); // its legs are 1/3 apart
    const SurfaceColumns columns = columns_of(surface, options_with(1, 1, 1));
    int between = 0;
    for (const NodeId v : surface.points.ids()) {
        const Vec<3>& x = surface.points[v];
        if (x[0] > 0.32 && x[0] < 0.34 && x[1] > 0.4 && x[1] < 0.6 && x[2] > 0.1 && x[2] < 0.3) {
            ++between;
            const double height = (columns.point(surface, v, 1) - x).norm();
            // 0.3 of the way, which is a little longer than the gap where the column leans.
            QVERIFY2(height < 0.12 && height > 0.01, qPrintable(QString::number(height)));
        }
    }
    QVERIFY(between > 0);
}

void SurfaceLayersTest::a_node_that_sees_not_all_of_its_faces_has_no_layers() {
    const Mesh<3> surface = body("corner");
    const SurfaceColumns columns = columns_of(surface, options_with(1e-4, 1.2, 5));
    const HalfEdges half_edges(surface);
    const auto directions = node_directions(surface, half_edges);
    int blind = 0;
    for (const NodeId v : surface.points.ids()) {
        blind += directions[v].visibility < 0.1 ? 1 : 0;
        if (directions[v].visibility < 0.1) {
            QVERIFY(columns.collapsed(v));
            QCOMPARE(columns.point(surface, v, 3), surface.points[v]);
        }
    }
    QVERIFY(blind > 0);
}

void SurfaceLayersTest::patches_of_the_body_are_kept() {
    Mesh<3> surface = surfaces::cube(2);
    surface.patch_names[surface.patch[FaceId(0)]] = "front";
    const Mesh<3> mesh = make_surface_layers(surface, options_with(1e-3, 1.2, 3), "a.stl").mesh;
    for (const FaceId f : surface.faces.ids()) {
        QCOMPARE(mesh.patch[f], surface.patch[f]);
        QVERIFY(sorted(mesh.faces[f]) == sorted(surface.faces[f]));
    }
    QCOMPARE(mesh.patch_names.at(surface.patch[FaceId(0)]), std::string("front"));
    QCOMPARE(mesh.patch_names.rbegin()->second, std::string("farfield"));
}

void SurfaceLayersTest::refuses_what_it_cannot_do() {
    const Mesh<3> good = surfaces::cube(2);
    QVERIFY_THROWS_EXCEPTION(UsageError,
                             (void)make_surface_layers(good, options_with(0, 1.2, 3), "a"));
    QVERIFY_THROWS_EXCEPTION(UsageError,
                             (void)make_surface_layers(good, options_with(1e-3, 0.9, 3), "a"));
    QVERIFY_THROWS_EXCEPTION(UsageError,
                             (void)make_surface_layers(good, options_with(1e-3, 1.2, 0), "a"));
    Mesh<3> inwards = good;
    for (const FaceId f : inwards.faces.ids()) {
        surfaces::turn(inwards, f);
    }
    QVERIFY_THROWS_EXCEPTION(InputError,
                             (void)make_surface_layers(inwards, options_with(1e-3, 1.2, 3), "a"));
    Mesh<3> open = good;
    surfaces::remove_face(open, FaceId(0));
    QVERIFY_THROWS_EXCEPTION(InputError,
                             (void)make_surface_layers(open, options_with(1e-3, 1.2, 3), "a"));
}

QTEST_APPLESS_MAIN(SurfaceLayersTest)
#include "surface_layers_test.moc"
