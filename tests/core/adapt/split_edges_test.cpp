// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/split_edges.h"

#include "core/adapt/edge_queue.h"
#include "tests/core/adapt/adapt_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

namespace {

template <int D>
double longest_edge(const UnitMesh<D>& mesh) {
    const auto edges = edges_by_length(mesh, 0, all_lengths);
    return edges.back().length;
}

} // namespace

class SplitEdgesTest : public QObject {
    Q_OBJECT

    template <int D>
    void refines(int n, double h) {
        for (int seed = 1; seed <= 20; ++seed) {
            Bench<D> bench(n, UniformMetric<D>(h), seed);
            const double longest = longest_edge(bench.unit);
            const std::string wrong = complaint_of_run(bench, 1, [](auto& unit, auto& verdicts) {
                return split_long_edges(unit, {}, 0, verdicts);
            });
            QVERIFY2(wrong.empty(), wrong.c_str());
            QVERIFY(longest_edge(bench.unit) <= longest);
        }
    }

private slots:
    void long_edges_get_a_node_and_the_mesh_stays_valid() {
        refines<2>(4, 0.1);
        refines<3>(3, 0.15);
    }

    void the_node_halves_the_length_where_the_metric_varies() {
        Bench<2> bench(1, LayerMetric<2>(0.01, 0.3, 0.5), 1);
        VerdictCounts verdicts;
        QVERIFY(split_long_edges(bench.unit, {}, 0, verdicts) > 0);
        // The side x = 0 from (0, 0), size 0.01, to (0, 1), size 0.31.
        bool found = false;
        for (const NodeId v : bench.unit.edit.nodes()) {
            const Vec<2>& p = bench.unit.edit.point(v);
            if (p[0] == 0 && p[1] > 0 && p[1] < 1) {
                found = true;
                QVERIFY2(p[1] < 0.3, std::to_string(p[1]).c_str());
            }
        }
        QVERIFY(found);
    }

    void nodes_that_are_near_to_others_are_not_put_in() {
        // Edges are just too long, and their midpoints one half from those across.
        Bench<2> bench(8, UniformMetric<2>(1.0 / 8 / 1.2), 1);
        VerdictCounts verdicts;
        (void)split_long_edges(bench.unit, {.shortest = 0.95}, 0, verdicts);
        const auto edges = edges_by_length(bench.unit, 0, all_lengths);
        QVERIFY(verdicts[Verdict::short_edge] > 0);
        QVERIFY(edges.front().length > 0.5);
    }

    void by_excess_the_sum_over_the_mesh_falls_with_each() {
        for (int seed = 1; seed <= 20; ++seed) {
            Bench<3> bench(3, LayerMetric<3>(0.1, 0.2, 0.3), seed);
            const std::string wrong = complaint_of_excess(bench, 1, [](auto& unit, auto& verdicts) {
                return split_long_edges(unit, {.by_excess = true}, 0, verdicts);
            });
            QVERIFY2(wrong.empty(), wrong.c_str());
        }
    }

    void a_ridge_stays_a_ridge() {
        Bench<3> bench(2, UniformMetric<3>(0.3), 1);
        VerdictCounts verdicts;
        QVERIFY(split_long_edges(bench.unit, {}, 0, verdicts) > 0);
        const auto compact = bench.unit.edit.compact();
        const auto again = classify_geometry(compact.mesh);
        QVERIFY(again.node == compact.classes.node);
        QVERIFY(again.ridges == compact.classes.ridges);
    }

    void frozen_patches_are_left_alone() {
        const Mesh<3> mesh = make_cube<3>({.n = 2, .displace = 0});
        FeatureOptions features;
        features.frozen_patches = {mesh.patch[FaceId(0)]};
        const UniformMetric<3> source(0.2);
        UnitMesh<3> unit(mesh, classify_geometry(mesh, features), source,
                         IdVector<NodeId, NodeId>(mesh.points.size(), NodeId(0)));
        VerdictCounts verdicts;
        QVERIFY(split_long_edges(unit, {}, 0, verdicts) > 0);
        QVERIFY(verdicts[Verdict::geometry_class] > 0);
        const auto count = [&](const Mesh<3>& m) {
            return std::count(m.patch.begin(), m.patch.end(), mesh.patch[FaceId(0)]);
        };
        QCOMPARE(count(unit.edit.compact().mesh), count(mesh));
    }
};

QTEST_APPLESS_MAIN(SplitEdgesTest)
#include "split_edges_test.moc"
