// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/recovery/fill.h"

#include "core/base/error.h"
#include "core/mesh/check.h"
#include "core/mesh/simplex.h"
#include "core/surface/self_intersections.h"
#include "tests/core/surface/surfaces.h"

#include <QRegularExpression>
#include <QtTest>

#include <set>

#include <Eigen/Geometry>

using namespace ameco;

class FillTest : public QObject {
    Q_OBJECT
private slots:
    void init();
    void contains_the_given_faces_data();
    void contains_the_given_faces();
    void leaves_bodies_and_cavities_empty();
    void fills_a_part_with_a_region_of_its_own();
    void a_size_makes_tets_of_that_size();
    void sizes_at_nodes_are_followed();
    void split_faces_cover_the_same_patches();
    void keeps_spacings_of_a_billionth();
    void the_same_surface_gives_the_same_mesh();
    void refuses_what_bounds_no_volume();
    void names_the_faces_that_tetgen_refuses();
    void a_stop_is_obeyed();
};

namespace {

void require_contains(const Mesh<3>& mesh, const Mesh<3>& surface) {
    std::set<std::pair<Facet<3>, int>> faces;
    for (const FaceId f : mesh.faces.ids()) {
        faces.insert({sorted(mesh.faces[f]), mesh.patch[f]});
    }
    for (const NodeId v : surface.points.ids()) {
        QVERIFY(mesh.points[v] == surface.points[v]);
    }
    for (const FaceId f : surface.faces.ids()) {
        QVERIFY(faces.count({sorted(surface.faces[f]), surface.patch[f]}) == 1);
    }
}

/// The cube with a square tunnel along z through its middle.
Mesh<3> cube_with_tunnel() {
    Mesh<3> mesh = shapes::cube(3);
    IdVector<ElementId, Simplex<3>> kept;
    for (const Simplex<3>& s : mesh.elements) {
        const Vec<3> x =
            (mesh.points[s[0]] + mesh.points[s[1]] + mesh.points[s[2]] + mesh.points[s[3]]) / 4;
        if (std::abs(x[0] - 0.5) > 1.0 / 6 || std::abs(x[1] - 0.5) > 1.0 / 6) {
            kept.push_back(s);
        }
    }
    mesh.elements = kept;
    mesh.region.assign(kept.size(), 1);
    mesh.faces.clear();
    mesh.patch.clear();
    shapes::add_boundary(mesh);
    return boundary_surface(mesh);
}

Mesh<3> ellipsoid(int frequency) {
    Mesh<3> mesh = surfaces::sphere(frequency);
    for (Vec<3>& x : mesh.points) {
        x = x.cwiseProduct(Vec<3>(4, 1, 0.5));
    }
    return mesh;
}

class Stopped : public Monitor {
public:
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view) override {}
    [[nodiscard]] bool stop_requested() const override { return true; }
};

} // namespace

void FillTest::init() {
    if (!can_recover()) {
        QSKIP("built without TetGen");
    }
}

void FillTest::contains_the_given_faces_data() {
    QTest::addColumn<QString>("shape");
    QTest::addColumn<bool>("around");
    for (const char* shape : {"cube", "sphere", "ellipsoid", "torus", "tunnel", "coarse cube"}) {
        QTest::addRow("in the %s", shape) << shape << false;
        QTest::addRow("around the %s", shape) << shape << true;
    }
}

void FillTest::contains_the_given_faces() {
    QFETCH(QString, shape);
    QFETCH(bool, around);
    const Mesh<3> surface = shape == "cube"          ? surfaces::cube(4)
                            : shape == "coarse cube" ? surfaces::cube(1)
                            : shape == "sphere"      ? surfaces::sphere(8)
                            : shape == "ellipsoid"   ? ellipsoid(8)
                            : shape == "torus"       ? surfaces::torus(24, 12)
                                                     : cube_with_tunnel();
    FillOptions options;
    if (around) {
        options.farfield = farfield_from(shape == "tunnel" ? "box:20" : "sphere:20");
    }
    const Fill fill = fill_surface(surface, options, "a.stl");
    const CheckReport report = check(fill.mesh);
    QVERIFY2(report.valid(), report.summary().c_str());
    require_contains(fill.mesh, surface);
    QCOMPARE(fill.empty.size(), std::size_t(around ? 1 : 0));
    QCOMPARE(fill.mesh.faces.size() > surface.faces.size(), around);
    QCOMPARE(report.interior_faces, std::int64_t{0});
}

void FillTest::leaves_bodies_and_cavities_empty() {
    // Outside in: a ball with a cavity, a ball in the cavity; beside it another ball.
    Mesh<3> surface = surfaces::both(surfaces::sphere(6, 3), surfaces::sphere(5, 2));
    surface = surfaces::both(surface, surfaces::sphere(4, 1));
    surface = surfaces::both(surface, surfaces::sphere(4, 1, {10, 0, 0}));
    const Fill inside = fill_surface(surface, {}, "a.stl");
    QCOMPARE(inside.empty.size(), std::size_t{1});
    QVERIFY(inside.empty[0].norm() > 1 && inside.empty[0].norm() < 2);
    FillOptions options;
    options.farfield = farfield_from("box:30");
    const Fill outside = fill_surface(surface, options, "a.stl");
    QCOMPARE(outside.empty.size(), std::size_t{3}); // the shell, the inner ball, the other ball
    const double both = check(inside.mesh).volume + check(outside.mesh).volume;
    QVERIFY(std::abs(both - 60 * 60 * 60) < 1e-9 * both);
}

void FillTest::fills_a_part_with_a_region_of_its_own() {
    const Mesh<3> surface = surfaces::both(surfaces::sphere(6, 3), surfaces::sphere(5, 1));
    FillOptions options;
    options.recovery.regions = {{{2, 0, 0}, 4, 0}, {{0.1, 0.2, 0.3}, 9, 0.2}};
    const Fill fill = fill_surface(surface, options, "a.stl");
    QVERIFY(fill.empty.empty());
    const CheckReport report = check(fill.mesh);
    QVERIFY2(report.valid(), report.summary().c_str());
    QCOMPARE(report.interior_faces, std::int64_t{20 * 25});
    for (const ElementId e : fill.mesh.elements.ids()) {
        Vec<3> x = Vec<3>::Zero();
        for (const NodeId v : fill.mesh[e]) {
            x += fill.mesh.points[v] / 4;
        }
        QCOMPARE(fill.mesh.region[e], x.norm() < 1 ? 9 : 4);
    }
    options.recovery.regions = {{{50, 0, 0}, 4, 0}};
    QVERIFY_THROWS_EXCEPTION(UsageError, (void)fill_surface(surface, options, "a.stl"));
}

void FillTest::a_size_makes_tets_of_that_size() {
    const auto tets = [](double size) {
        FillOptions options;
        options.recovery.size = size;
        return fill_surface(surfaces::cube(4), options, "a.stl").mesh.elements.size();
    };
    const std::size_t coarse = tets(0), fine = tets(0.1);
    QVERIFY(fine > 4 * coarse);
    // The mean tet is no larger than the regular one with edges of 0.1, but that the kept faces,
    // which are larger, make larger ones beside them.
    QVERIFY(static_cast<double>(fine) >= 0.5 * std::sqrt(72.0) / std::pow(0.1, 3));
}

void FillTest::sizes_at_nodes_are_followed() {
    const Mesh<3> surface = surfaces::cube(4);
    FillOptions options;
    for (const Vec<3>& x : surface.points) {
        options.recovery.sizes.push_back(0.05 + 0.3 * x[2]);
    }
    const Mesh<3> mesh = fill_surface(surface, options, "a.stl").mesh;
    int low = 0, high = 0;
    for (const Vec<3>& x : mesh.points) {
        ++(x[2] < 0.5 ? low : high);
    }
    QVERIFY(low > 2 * high);
}

void FillTest::split_faces_cover_the_same_patches() {
    const Mesh<3> surface = surfaces::cube(2);
    FillOptions options;
    options.recovery.faces = GivenFaces::split;
    options.recovery.size = 0.1;
    const Mesh<3> mesh = fill_surface(surface, options, "a.stl").mesh;
    QVERIFY(mesh.faces.size() > surface.faces.size());
    std::map<int, double> area;
    for (const FaceId f : mesh.faces.ids()) {
        const auto& [a, b, c] = mesh.faces[f];
        area[mesh.patch[f]] +=
            (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm() / 2;
    }
    QCOMPARE(area.size(), std::size_t{6});
    for (const auto& [patch, value] : area) {
        QVERIFY(std::abs(value - 1) < 1e-12);
    }
}

void FillTest::keeps_spacings_of_a_billionth() {
    // A plate of this thickness, as wide as its faces are long: every tet is a layer.
    Mesh<3> surface = surfaces::cube(3);
    for (Vec<3>& x : surface.points) {
        x[2] *= 1e-9;
    }
    FillOptions options;
    options.recovery.radius_edge = 0;
    const Fill fill = fill_surface(surface, options, "a.stl");
    require_contains(fill.mesh, surface);
    const CheckReport report = check(fill.mesh);
    QVERIFY2(report.valid(), report.summary().c_str());
    QVERIFY(std::abs(report.volume - 1e-9) < 1e-20);
}

void FillTest::the_same_surface_gives_the_same_mesh() {
    const Mesh<3> surface = surfaces::torus(20, 12);
    QVERIFY(fill_surface(surface, {}, "a.stl").mesh == fill_surface(surface, {}, "b.stl").mesh);
}

void FillTest::refuses_what_bounds_no_volume() {
    Mesh<3> surface = surfaces::cube(2);
    surfaces::remove_face(surface, FaceId(3));
    QVERIFY_THROWS_EXCEPTION(InputError, (void)fill_surface(surface, {}, "a.stl"));
    QVERIFY_THROWS_EXCEPTION(
        InputError,
        (void)fill_surface(surfaces::both(surfaces::sphere(4), surfaces::sphere(4, 1, {1, 0.1, 0})),
                           {}, "a.stl"));
}

void FillTest::names_the_faces_that_tetgen_refuses() {
    // Behind our own tests' back: two spheres that overlap.
    const Mesh<3> surface =
        surfaces::both(surfaces::sphere(4), surfaces::sphere(4, 1, {1, 0.1, 0.05}));
    try {
        (void)recover_boundary(surface, {}, "a.stl");
        QFAIL("accepted");
    } catch (const InputError& error) {
        const QString text = error.what();
        QVERIFY2(text.startsWith("a.stl: TetGen "), error.what());
        // One of the faces that do intersect.
        const auto named = QRegularExpression("it names face (\\d+)").match(text);
        QVERIFY2(named.hasMatch(), error.what());
        const FaceId face(named.captured(1).toInt());
        const auto pairs = self_intersections(surface);
        QVERIFY2(std::any_of(pairs.begin(), pairs.end(),
                             [&](const auto& p) { return p[0] == face || p[1] == face; }),
                 error.what());
    }
    Mesh<3> broken = surfaces::cube(2);
    broken.points[NodeId(3)][1] = std::numeric_limits<double>::quiet_NaN();
    QVERIFY_THROWS_EXCEPTION(InputError, (void)recover_boundary(broken, {}, "a.stl"));
}

void FillTest::a_stop_is_obeyed() {
    FillOptions options;
    options.recovery.size = 0.003; // would take minutes
    Stopped monitor;
    QVERIFY_THROWS_EXCEPTION(Cancelled,
                             (void)fill_surface(surfaces::cube(2), options, "a.stl", monitor));
}

QTEST_APPLESS_MAIN(FillTest)
#include "fill_test.moc"
