// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/place_on_surface.h"

#include "core/adapt/adapt.h"
#include "tests/core/adapt/adapt_support.h"
#include "tests/core/adapt/curved_walls.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

namespace {

/// How far the nodes of a boundary are from another one, patch by patch, those between two patches
/// from the line between them.
struct Off {
    int count = 0;                              ///< nodes off it beyond rounding
    int nodes = 0;                              ///< all of the boundary
    int count_of_lines = 0, nodes_of_lines = 0; ///< the same of those between two patches
};

Off off(const Mesh<3>& mesh, const Mesh<3>& original) {
    const BoundaryProjection<3> projection(original);
    const auto patches = node_patches(mesh);
    Off off;
    for (const NodeId v : mesh.points.ids()) {
        if (patches[v].empty()) {
            continue;
        }
        const Vec<3>& p = mesh.points[v];
        const bool on_line = patches[v].size() == 2;
        const double distance = on_line ? projection.project_on_line(p, patches[v]).distance
                                        : projection.project(p, patches[v]).distance;
        const int is_off = distance > 1e-12 ? 1 : 0;
        off.count += is_off;
        ++off.nodes;
        off.count_of_lines += on_line ? is_off : 0;
        off.nodes_of_lines += on_line ? 1 : 0;
    }
    return off;
}

/// A domain with curved walls under edit whose edges are no longer those that were given: its nodes
/// have moved along the walls.
struct MovedBench {
    Mesh<3> mesh;
    UniformMetric<3> source{0.3};
    UnitMesh<3> unit;

    explicit MovedBench(const Mesh<3>& m)
        : mesh(m), unit(mesh, classify_geometry(mesh, {}), source,
                        IdVector<NodeId, NodeId>(mesh.points.size(), NodeId(0))) {
        for (const NodeId v : mesh.points.ids()) {
            (void)move_node(unit, v, {.below = 1, .curved = SurfaceRules{}});
        }
    }

    [[nodiscard]] Mesh<3> now() const { return unit.edit.compact().mesh; }
};

} // namespace

class PlaceOnSurfaceTest : public QObject {
    Q_OBJECT

private slots:
    void a_place_is_on_the_patch_and_keeps_common_coordinates_to_the_bit() {
        const Mesh<3> mesh = make_cube<3>({.n = 2, .displace = 0.2});
        const OriginalSurface<3> original(mesh, outer_faces(mesh));
        const Facet<3>& face = mesh.faces[FaceId(0)];
        const Vec<3> corner = mesh.points[face[0]];
        SurfaceSite<3> site;
        site.patches = {mesh.patch[FaceId(0)]};
        site.direction =
            unit_normal(std::array<Vec<3>, 3>{corner, mesh.points[face[1]], mesh.points[face[2]]});
        const Vec<3> p = Vec<3>(0.3, 0.4, 0.6) + 0.01 * site.direction;
        const auto place = place_on_surface(original, site, p, 30);
        QVERIFY(place.has_value());
        int axis;
        (void)site.direction.cwiseAbs().maxCoeff(&axis);
        QCOMPARE((*place)[axis], corner[axis]);
        QCOMPARE_LE((*place - p).norm(), 1.0);
    }

    void there_is_no_place_on_the_far_side_of_something_thin() {
        const Mesh<3> mesh = between_spheres();
        const OriginalSurface<3> original(mesh, outer_faces(mesh));
        const UniformMetric<3> source(0.4);
        const UnitMesh<3> unit(mesh, classify_geometry(mesh, {}), source,
                               IdVector<NodeId, NodeId>(mesh.points.size(), NodeId(0)));
        for (const NodeId v : mesh.points.ids()) {
            if (unit.edit.on_boundary(v)) {
                SurfaceSite<3> site;
                gather_site(unit.edit, v, site);
                QCOMPARE(site.patches.size(), std::size_t(1));
                QVERIFY(place_on_surface(original, site, mesh.points[v], 45).has_value());
                site.direction *= -1;
                QVERIFY(!place_on_surface(original, site, mesh.points[v], 45).has_value());
            }
        }
    }

    void splits_put_their_nodes_on_the_original_surface_data() {
        QTest::addColumn<bool>("cylinder");
        QTest::newRow("sphere") << false;
        QTest::newRow("cylinder") << true;
    }

    void splits_put_their_nodes_on_the_original_surface() {
        QFETCH(bool, cylinder);
        const SurfaceRules rules, none{.layer_share = 1e-9};
        int on_chords = -1;
        for (const auto& curved :
             {std::optional<SurfaceRules>(), std::optional(none), std::optional(rules)}) {
            MovedBench bench(cylinder ? between_cylinders() : between_spheres());
            VerdictCounts verdicts;
            const SplitOptions options{
                .above = 1, .shortest = 0, .shortest_among_long = 0, .curved = curved};
            QVERIFY(split_long_edges(bench.unit, options, 0, verdicts) > 20);
            const Mesh<3> now = bench.now();
            QVERIFY2(check(now).valid(), check(now).summary().c_str());
            for (std::size_t i = 0; i < bench.unit.edit.slot_count(); ++i) {
                const ElementId e(i);
                if (!bench.unit.edit.is_free(e) && !bench.unit.edit.is_ghost(e)) {
                    const Simplex<3>& s = bench.unit.edit.nodes(e);
                    QVERIFY(is_positive(bench.unit.edit, s));
                    QCOMPARE(bench.unit.edit.element(e).measure,
                             static_cast<float>(bench.unit.quality(s)));
                }
            }
            const int count = off(now, bench.mesh).count;
            if (!curved) {
                QCOMPARE_GT(count, 10);
                on_chords = count;
            } else if (curved->layer_share < 0.5) { // refused, so they stay on the chords
                QCOMPARE(count, on_chords);
            } else {
                QCOMPARE_LT(3 * count, on_chords);
            }
        }
    }

    void planes_and_lines_stay_as_without() {
        const auto split = [](const std::optional<SurfaceRules>& curved) {
            Bench<3> bench(3, UniformMetric<3>(0.15), 5);
            VerdictCounts verdicts;
            (void)split_long_edges(bench.unit, {.curved = curved}, 0, verdicts);
            return bench.unit.edit.compact().mesh.points;
        };
        QVERIFY(split({}) == split(SurfaceRules{}));
    }

    void a_finer_mesh_is_on_the_surface_that_was_given_data() {
        QTest::addColumn<bool>("cylinder");
        QTest::addColumn<double>("corner_angle_deg");
        QTest::newRow("sphere") << false << 50.0;
        QTest::newRow("cylinder") << true << 50.0;
        QTest::newRow("cylinder with corners") << true << 10.0;
    }

    void a_finer_mesh_is_on_the_surface_that_was_given() {
        QFETCH(bool, cylinder);
        QFETCH(double, corner_angle_deg);
        const Mesh<3> given = cylinder ? between_cylinders() : between_spheres();
        AdaptOptions options;
        options.features.corner_angle_deg = corner_angle_deg;
        AdaptReport report;
        const Mesh<3> mesh = adapt(given, UniformMetric<3>(0.28), options, report).mesh;
        QVERIFY(report.check.valid());
        QCOMPARE_GT(report.nodes_after, report.nodes_before);
        const Off now = off(mesh, given);
        // A few may stay in the middle of edges, where elements would be bad on the surface.
        QCOMPARE_LE(200 * now.count, now.nodes);
        QCOMPARE_LE(now.count_of_lines, 1);
        if (!cylinder) {
            return;
        }
        QCOMPARE_GT(now.nodes_of_lines, off(given, given).nodes_of_lines);
        const auto patches = node_patches(mesh);
        const double low = given.points[NodeId(0)][1];
        const double high =
            std::max_element(given.points.begin(), given.points.end(),
                             [](const Vec<3>& a, const Vec<3>& b) { return a[1] < b[1]; })
                ->y();
        for (const NodeId v : mesh.points.ids()) {
            const auto has = [&](int patch) {
                return std::binary_search(patches[v].begin(), patches[v].end(), patch);
            };
            const double y = mesh.points[v][1];
            QCOMPARE(has(patch_y_min), y == low);
            QCOMPARE(has(patch_y_max), y == high);
        }
        if (corner_angle_deg < 22.5) { // the turn of the circles at their nodes
            std::set<std::array<double, 3>> places;
            for (const Vec<3>& p : mesh.points) {
                places.insert(remesh_test::key_of<3>(p));
            }
            const auto given_patches = node_patches(given);
            for (const NodeId v : given.points.ids()) {
                QVERIFY(given_patches[v].size() < 2 ||
                        places.contains(remesh_test::key_of<3>(given.points[v])));
            }
        }
    }
};

QTEST_APPLESS_MAIN(PlaceOnSurfaceTest)
#include "place_on_surface_test.moc"
