// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/move_nodes.h"

#include "core/mesh/boundary_projection.h"
#include "tests/core/adapt/adapt_support.h"
#include "tests/core/adapt/curved_walls.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

namespace {

template <int D>
double inverse_sum(const UnitMesh<D>& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.edit.slot_count(); ++i) {
        const ElementId e(i);
        if (!mesh.edit.is_free(e) && !mesh.edit.is_ghost(e)) {
            sum += 1 / static_cast<double>(mesh.edit.element(e).measure);
        }
    }
    return sum;
}

/// A domain under edit, and where its nodes were.
struct DomainBench {
    Mesh<3> mesh;
    UniformMetric<3> source;
    UnitMesh<3> unit;

    DomainBench(const Mesh<3>& m, double size, const FeatureOptions& features = {})
        : mesh(m), source(size), unit(mesh, classify_geometry(mesh, features), source,
                                      IdVector<NodeId, NodeId>(mesh.points.size(), NodeId(0))) {}

    /// Nodes that are not where they were, of some class.
    [[nodiscard]] int moved(NodeClass node_class) const {
        int count = 0;
        for (const NodeId v : mesh.points.ids()) {
            count += unit.edit.node_class(v) == node_class && unit.edit.point(v) != mesh.points[v]
                         ? 1
                         : 0;
        }
        return count;
    }
};

} // namespace

class MoveNodesTest : public QObject {
    Q_OBJECT

    template <int D>
    void improves(int n) {
        for (int seed = 1; seed <= 20; ++seed) {
            Bench<D> bench(n, UniformMetric<D>(1.0 / n), seed);
            VerdictCounts verdicts;
            const double before = inverse_sum(bench.unit);
            const std::int64_t made = move_nodes(bench.unit, {}, 0, verdicts);
            QVERIFY(made > 0);
            QCOMPARE(verdicts[Verdict::accepted], made);
            QVERIFY(inverse_sum(bench.unit) < before);
            QVERIFY2(bench.complaint().empty(), bench.complaint().c_str());
        }
    }

private slots:
    void the_harmonic_mean_grows_and_the_mesh_stays_valid() {
        improves<2>(6);
        improves<3>(4);
    }

    void by_excess_no_move_raises_the_sum_nor_spoils_an_element() {
        for (int seed = 1; seed <= 5; ++seed) {
            Bench<3> bench(4, LayerMetric<3>(0.15, 0.3, 0.3), seed);
            const MoveOptions options{.below = 1, .by_excess = true, .excess_quality = 0.4};
            const double first = total_excess(bench.unit);
            double before = first;
            int made = 0;
            for (const NodeId v : bench.mesh.points.ids()) {
                const double worst = bench.worst();
                made += move_node(bench.unit, v, options) == Verdict::accepted ? 1 : 0;
                const double now = total_excess(bench.unit);
                QVERIFY(now <= before + 1e-9 * (1 + before));
                QVERIFY(bench.worst() >= std::min(worst, 0.3));
                before = now;
            }
            QVERIFY(made > 0);
            QVERIFY(before < 0.9 * first);
            QVERIFY2(bench.complaint().empty(), bench.complaint().c_str());
        }
    }

    void nodes_that_are_not_tried_again_have_no_better_place() {
        for (int seed = 1; seed <= 5; ++seed) {
            for (const bool by_excess : {false, true}) {
                Bench<3> bench(4, LayerMetric<3>(0.1, 0.3, 0.3), seed);
                const MoveOptions options{.gain = 1.02, .by_excess = by_excess};
                VerdictCounts verdicts;
                std::int64_t tried = 0;
                do {
                    tried = verdicts[Verdict::no_improvement];
                } while (move_nodes(bench.unit, options, 0, verdicts) > 0);
                QVERIFY(verdicts[Verdict::no_improvement] - tried <
                        static_cast<std::int64_t>(bench.nodes()));
                Fresh<3> fresh(bench.unit, *bench.source);
                verdicts = {};
                QCOMPARE(move_nodes(fresh.unit, options, 0, verdicts), std::int64_t{0});
                QVERIFY(verdicts[Verdict::no_improvement] > 0);
            }
        }
    }

    void planes_and_lines_are_kept_to_the_bit() {
        Bench<3> bench(4, UniformMetric<3>(0.25), 7);
        VerdictCounts verdicts;
        (void)move_nodes(bench.unit, {}, 0, verdicts);
        std::size_t moved_on_boundary = 0;
        for (const NodeId v : bench.mesh.points.ids()) {
            const Vec<3>& old = bench.mesh.points[v];
            const Vec<3>& now = bench.unit.edit.point(v);
            for (int k = 0; k < 3; ++k) {
                if (old[k] == 0 || old[k] == 1) {
                    QCOMPARE(now[k], old[k]);
                    moved_on_boundary += now == old ? 0 : 1;
                }
            }
        }
        QVERIFY(moved_on_boundary > 0);
    }

    void oblique_planes_and_lines_are_kept_to_rounding() {
        Mesh<3> cube = make_cube<3>({.n = 4, .displace = 0.2, .seed = 7});
        const Mat<3> turn = Eigen::AngleAxisd(0.7, Vec<3>(1, 2, 3).normalized()).matrix();
        for (Vec<3>& p : cube.points) {
            p = turn * p;
        }
        for (const bool by_excess : {false, true}) {
            for (const auto& curved : {std::optional<SurfaceRules>(), std::optional(plane_sides)}) {
                DomainBench bench(cube, 0.3);
                VerdictCounts verdicts;
                for (int pass = 0; pass < 3; ++pass) {
                    (void)move_nodes(bench.unit, {.by_excess = by_excess, .curved = curved}, 0,
                                     verdicts);
                }
                QVERIFY(bench.moved(NodeClass::patch) > 0);
                QVERIFY(bench.moved(NodeClass::ridge) > 0);
                QCOMPARE_LE(off_surface(bench.unit.edit.compact().mesh, cube).farthest, 1e-15);
            }
        }
    }

    void nodes_of_curved_walls_move_on_the_original_surface_data() {
        QTest::addColumn<Mesh<3>>("given");
        QTest::addColumn<bool>("has_ridges");
        QTest::newRow("sphere") << between_spheres() << false;
        QTest::newRow("cylinder") << between_cylinders() << true;
        QTest::newRow("cylinder of one patch") << between_cylinders_of_one_patch() << true;
    }

    void nodes_of_curved_walls_move_on_the_original_surface() {
        QFETCH(Mesh<3>, given);
        QFETCH(bool, has_ridges);
        DomainBench bench(given, 0.4);
        const SurfaceRules rules;
        const double volume = check(bench.mesh).volume, before = inverse_sum(bench.unit);
        for (int pass = 0; pass < 3; ++pass) {
            for (const NodeId v : bench.mesh.points.ids()) {
                if (move_node(bench.unit, v, {.below = 1, .curved = rules}) != Verdict::accepted) {
                    continue;
                }
                for (const ElementId e : bench.unit.edit.ball(v)) {
                    QVERIFY(bench.unit.edit.is_ghost(e) ||
                            is_positive(bench.unit.edit, bench.unit.edit.nodes(e)));
                }
            }
        }
        const auto now = bench.unit.edit.compact();
        QVERIFY2(check(now.mesh).valid(), check(now.mesh).summary().c_str());
        QVERIFY(inverse_sum(bench.unit) < before);
        QVERIFY(bench.moved(NodeClass::patch) > 10);
        QCOMPARE_LE(off_surface(now.mesh, bench.mesh).farthest, 1e-14);
        QCOMPARE_LE(std::abs(check(now.mesh).volume / volume - 1), 0.02);
        const BoundaryProjection<3> projection(bench.mesh);
        for (const FaceId f : now.mesh.faces.ids()) {
            const Facet<3>& n = now.mesh.faces[f];
            const Vec<3> middle =
                (now.mesh.points[n[0]] + now.mesh.points[n[1]] + now.mesh.points[n[2]]) / 3;
            QCOMPARE_LE(projection.project(middle).distance, now.classes.deviation[f] + 1e-14);
        }
        if (has_ridges) { // circles around the ends, planes across the y axis
            QVERIFY(bench.moved(NodeClass::ridge) > 0);
            for (const NodeId v : bench.mesh.points.ids()) {
                const double y = bench.mesh.points[v][1];
                if (y == bench.mesh.points[NodeId(0)][1]) {
                    QCOMPARE(bench.unit.edit.point(v)[1], y);
                }
            }
        }
    }

    void nodes_of_curved_patches_stay_without_rules_and_where_they_are_frozen() {
        for (const bool frozen : {false, true}) {
            FeatureOptions features;
            MoveOptions options{.below = 1};
            if (frozen) {
                features.boundary = BoundaryChoice::keep;
                options.curved = SurfaceRules{};
            }
            DomainBench bench(between_spheres(), 0.4, features);
            VerdictCounts verdicts;
            QVERIFY(move_nodes(bench.unit, options, 0, verdicts) > 0);
            for (const NodeId v : bench.mesh.points.ids()) {
                QVERIFY(!bench.unit.edit.on_boundary(v) ||
                        bench.unit.edit.point(v) == bench.mesh.points[v]);
            }
        }
    }

    void curved_walls_do_not_pass_a_share_of_the_layer() {
        // No move of a node on a sphere leaves the faces around it where they were.
        DomainBench bench(between_spheres(), 0.4);
        const SurfaceRules none{.layer_share = 1e-9};
        VerdictCounts verdicts;
        QVERIFY(move_nodes(bench.unit, {.below = 1, .curved = none}, 0, verdicts) > 0);
        QCOMPARE(bench.moved(NodeClass::patch), 0);
    }

    void the_metric_is_that_of_the_new_place() {
        const LayerMetric<3> source(0.05, 0.5, 0.4);
        Bench<3> bench(4, source, 2);
        VerdictCounts verdicts;
        (void)move_nodes(bench.unit, {}, 0, verdicts);
        for (const NodeId v : bench.unit.edit.nodes()) {
            NodeId near;
            QCOMPARE(bench.unit.short_size(v), source.at(bench.unit.edit.point(v), near).sizes[0]);
        }
    }
};

QTEST_APPLESS_MAIN(MoveNodesTest)
#include "move_nodes_test.moc"
