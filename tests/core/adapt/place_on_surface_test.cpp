// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/place_on_surface.h"

#include "core/adapt/adapt.h"
#include "tests/core/adapt/adapt_support.h"
#include "tests/core/adapt/curved_walls.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

namespace {

/// Share of the ridge edges that are in band where all lengths are to be `size`.
double ridges_in_band(const Mesh<3>& mesh, double size) {
    const auto ridges = classify_geometry(mesh).ridges;
    const auto count = std::count_if(ridges.begin(), ridges.end(), [&](const RidgeEdge& r) {
        const double l = (mesh.points[r.nodes[1]] - mesh.points[r.nodes[0]]).norm() / size;
        return l >= shortest_in_band && l <= longest_in_band;
    });
    return static_cast<double>(count) / static_cast<double>(ridges.size());
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

    /// The circles of cylinders, and where there are several patches these, are in the planes they
    /// were given in, to the bit.
    static void is_cut_at_the_same_planes(const Mesh<3>& mesh, const Mesh<3>& given) {
        const auto [low, high] =
            std::minmax_element(given.points.begin(), given.points.end(),
                                [](const Vec<3>& a, const Vec<3>& b) { return a[1] < b[1]; });
        const auto patches = node_patches(mesh);
        const bool one_patch = given.patch_names.size() == 1;
        const std::set<NodeId> on_ridges = ridge_nodes(mesh);
        for (const NodeId v : mesh.points.ids()) {
            const double y = mesh.points[v][1];
            const auto has = [&](int patch) {
                return std::binary_search(patches[v].begin(), patches[v].end(), patch);
            };
            QVERIFY(!on_ridges.contains(v) || y == low->y() || y == high->y());
            QVERIFY(one_patch || has(patch_y_min) == (y == low->y()));
            QVERIFY(one_patch || has(patch_y_max) == (y == high->y()));
        }
    }

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

    void ridges_inside_a_patch_are_lines_of_their_own() {
        const Mesh<3> mesh = between_cylinders_of_one_patch();
        const auto classes = classify_geometry(mesh);
        const RidgeEdge& ridge = classes.ridges.front();
        const Vec<3>&a = mesh.points[ridge.nodes[0]], &b = mesh.points[ridge.nodes[1]];
        SurfaceSite<3> site;
        site.patches = {mesh.patch[FaceId(0)]};
        site.on_ridge = true;
        site.direction = (b - a).normalized();
        const Vec<3> beside = 0.7 * a + 0.3 * b + Vec<3>(0, 0.05, 0);
        const auto place = place_on_surface(*classes.original, site, beside, 30);
        QVERIFY(place.has_value());
        QCOMPARE_LE((*place - (0.7 * a + 0.3 * b)).norm(), 1e-14);
        site.direction = Vec<3>::UnitY();
        QVERIFY(!place_on_surface(*classes.original, site, beside, 30).has_value());
        const OriginalSurface<3> without(mesh, outer_faces(mesh));
        QVERIFY(!place_on_surface(without, site, beside, 90).has_value());
    }

    void splits_put_their_nodes_on_the_original_surface_data() {
        QTest::addColumn<Mesh<3>>("given");
        QTest::newRow("sphere") << between_spheres();
        QTest::newRow("cylinder") << between_cylinders();
        QTest::newRow("cylinder of one patch") << between_cylinders_of_one_patch();
    }

    void splits_put_their_nodes_on_the_original_surface() {
        QFETCH(Mesh<3>, given);
        const SurfaceRules rules, none{.layer_share = 1e-9};
        int on_chords = -1;
        for (const auto& curved :
             {std::optional<SurfaceRules>(), std::optional(none), std::optional(rules)}) {
            MovedBench bench(given);
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
            const int count = off_surface(now, bench.mesh).count;
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
        QTest::addColumn<Mesh<3>>("given");
        QTest::addColumn<double>("corner_angle_deg");
        QTest::newRow("sphere") << between_spheres() << 50.0;
        QTest::newRow("cylinder") << between_cylinders() << 50.0;
        QTest::newRow("cylinder with corners") << between_cylinders() << 10.0;
        QTest::newRow("cylinder of one patch") << between_cylinders_of_one_patch() << 50.0;
        QTest::newRow("one patch with corners") << between_cylinders_of_one_patch() << 10.0;
    }

    void a_finer_mesh_is_on_the_surface_that_was_given() {
        QFETCH(Mesh<3>, given);
        QFETCH(double, corner_angle_deg);
        AdaptOptions options;
        options.features.corner_angle_deg = corner_angle_deg;
        AdaptReport report;
        const Mesh<3> mesh = adapt(given, UniformMetric<3>(0.28), options, report).mesh;
        QVERIFY(report.check.valid());
        QCOMPARE_GT(report.nodes_after, report.nodes_before);
        const Off before = off_surface(given, given), now = off_surface(mesh, given);
        QCOMPARE(now.count, 0);
        QCOMPARE(now.ridge_nodes > before.ridge_nodes, before.ridge_nodes > 0);
        if (before.ridge_nodes > 0) {
            is_cut_at_the_same_planes(mesh, given);
        }
        // The circles turn by 22.5 degrees at their nodes.
        const auto& node_class = classify_geometry(given, options.features).node;
        std::set<std::array<double, 3>> places;
        for (const Vec<3>& p : mesh.points) {
            places.insert(remesh_test::key_of<3>(p));
        }
        for (const NodeId v : given.points.ids()) {
            QVERIFY(node_class[v] != NodeClass::frozen ||
                    places.contains(remesh_test::key_of<3>(given.points[v])));
        }
    }

    void ridges_side_by_side_inside_a_patch_are_told_apart() {
        // Rims much nearer to each other than the middles of their edges are to the circle.
        constexpr int around = 16;
        constexpr double height = 1e-4;
        Mesh<3> given = layered_cases::cylinder(around, 1, {0, 0.4, 0.8});
        layered_cases::join_patches(given);
        for (const NodeId v : given.points.ids()) { // row 0 of a layer, row 1, next layer
            const int row = v.value() / around % 2;
            const Vec<3> below = given.points[NodeId(v.value() - around * row)];
            given.points[v] = {below[0], row * height, below[2]};
        }
        Metric<3> metric;
        metric.sizes << height, 0.28, 0.28;
        metric.directions << 0, 1, 0, 1, 0, 0, 0, 0, 1;
        AdaptReport report;
        const Mesh<3> mesh = adapt(given, UniformMetric<3>(metric), {}, report).mesh;
        const Off before = off_surface(given, given), now = off_surface(mesh, given);
        QCOMPARE_GT(now.ridge_nodes, before.ridge_nodes);
        QCOMPARE(now.count, 0);
        is_cut_at_the_same_planes(mesh, given);
    }

    void edges_of_ridges_come_into_band_inside_a_patch_too() {
        const auto in_band = [](bool move) {
            constexpr double size = 0.5;
            AdaptOptions options;
            options.move_curved = move;
            AdaptReport report;
            return ridges_in_band(
                adapt(between_cylinders_of_one_patch(), UniformMetric<3>(size), options, report)
                    .mesh,
                size);
        };
        QCOMPARE_GT(in_band(true), in_band(false));
    }
};

QTEST_APPLESS_MAIN(PlaceOnSurfaceTest)
#include "place_on_surface_test.moc"
