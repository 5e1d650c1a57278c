// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/mtc.h"

#include "core/adapt/adapt.h"
#include "core/adapt/quality_order.h"
#include "tests/core/adapt/adapt_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::adapt_test;

namespace {

struct Counts {
    VerdictCounts collapses, moves, swaps, splits;
    MtcVerdicts refer() { return {collapses, moves, swaps, splits}; }
    [[nodiscard]] std::int64_t made() const {
        return collapses[Verdict::accepted] + moves[Verdict::accepted] + swaps[Verdict::accepted] +
               splits[Verdict::accepted];
    }
};

Metric<3> tilted() {
    Metric<3> metric;
    metric.sizes << 0.1, 0.4, 0.4;
    metric.directions << 1, 1, 0, -1, 1, 0, 0, 0, std::sqrt(2.0);
    metric.directions /= std::sqrt(2.0);
    return metric;
}

AdaptOptions mtc_options(std::optional<Quality> quality = {}) {
    AdaptOptions options;
    options.engine = Engine::mtc;
    options.quality = quality;
    return options;
}

} // namespace

class MtcTest : public QObject {
    Q_OBJECT

    /// Sweeps until nothing changes; after each the mesh is valid and its set of qualities better.
    template <int D, class Source>
    static void sweeps_to_stagnation(int n, const Source& source, Quality quality,
                                     bool new_places) {
        for (int seed = 1; seed <= 3; ++seed) {
            Bench<D> bench(n, source, seed, quality);
            const MtcOptions options{.new_places = new_places};
            Counts counts;
            std::vector<float> before = bench.qualities();
            std::int64_t total = 0;
            int since = 0, sweep = 0;
            for (; sweep < 200; ++sweep) {
                const int now = bench.unit.tick();
                const std::int64_t made =
                    mtc_sweep(bench.unit, options, plane_sides, since, counts.refer());
                since = now;
                total += made;
                QCOMPARE(counts.made(), total);
                QVERIFY2(bench.complaint().empty(), bench.complaint().c_str());
                const std::vector<float> after = bench.qualities();
                QCOMPARE(is_worse(before, after), made > 0);
                QVERIFY(!is_worse(after, before));
                if (made == 0) {
                    break;
                }
                before = after;
            }
            QVERIFY(total > 0);
            QVERIFY(sweep < 200);
            // Nothing was passed over: a look at all cavities finds nothing either.
            QCOMPARE(mtc_sweep(bench.unit, options, plane_sides, 0, counts.refer()),
                     std::int64_t{0});
        }
    }

private slots:
    void every_sweep_leaves_a_better_valid_mesh_until_none_does_data() {
        QTest::addColumn<Quality>("quality");
        QTest::addColumn<bool>("new_places");
        QTest::newRow("original") << Quality::original << true;
        QTest::newRow("modified") << Quality::modified << true;
        QTest::newRow("modified, old nodes only") << Quality::modified << false;
    }
    void every_sweep_leaves_a_better_valid_mesh_until_none_does() {
        QFETCH(Quality, quality);
        QFETCH(bool, new_places);
        sweeps_to_stagnation<2>(6, UniformMetric<2>(0.3), quality, new_places);
        sweeps_to_stagnation<3>(4, UniformMetric<3>(0.5), quality, new_places);
        sweeps_to_stagnation<3>(3, UniformMetric<3>(tilted()), quality, new_places);
    }

    void a_mesh_that_is_too_fine_loses_nodes_and_one_that_is_too_coarse_gets_some() {
        const Mesh<3> mesh = make_cube<3>({.n = 4});
        AdaptReport coarser, finer;
        (void)adapt(mesh, UniformMetric<3>(0.5), mtc_options(), coarser);
        QVERIFY(coarser.nodes_after < coarser.nodes_before / 2);
        QVERIFY(coarser.conformity.in_band > coarser.conformity_before.in_band);
        (void)adapt(mesh, UniformMetric<3>(0.15), mtc_options(), finer);
        QVERIFY(finer.nodes_after > finer.nodes_before);
        QVERIFY(finer.conformity.in_band > 0.8);
    }

    void node_nested_meshes_have_nodes_of_the_mesh_only() {
        const Mesh<3> mesh = make_cube<3>({.n = 4});
        AdaptOptions options = mtc_options();
        options.node_nested = true;
        AdaptReport report;
        const auto adapted = adapt(mesh, UniformMetric<3>(0.5), options, report);
        QVERIFY(adapted.mesh.points.size() < mesh.points.size());
        QVERIFY(has_nodes_of(adapted.mesh, mesh));
    }

    void regions_and_the_faces_between_them_stay() {
        Mesh<3> mesh = make_cube<3>({.n = 4, .displace = 0});
        remesh_test::split_regions(mesh, 0.5);
        AdaptReport report;
        const auto adapted = adapt(mesh, UniformMetric<3>(0.15), mtc_options(), report);
        QVERIFY(report.nodes_after != report.nodes_before);
        QVERIFY(difference(remesh_test::extent(adapted.mesh), remesh_test::extent(mesh)) < 1e-12);
    }

    void faces_of_frozen_patches_stay_to_the_bit() {
        const Mesh<3> mesh = make_cube<3>({.n = 4, .displace = 0.2});
        AdaptOptions options = mtc_options();
        const int frozen = mesh.patch[FaceId(0)];
        options.features.frozen_patches = {frozen};
        AdaptReport report;
        const auto adapted = adapt(mesh, UniformMetric<3>(0.5), options, report);
        QVERIFY(report.nodes_after < report.nodes_before);
        const auto faces = [&](const Mesh<3>& m) {
            std::set<std::vector<std::array<double, 3>>> out;
            for (const FaceId f : m.faces.ids()) {
                if (m.patch[f] == frozen) {
                    out.insert(remesh_test::place_of(m, m.faces[f]));
                }
            }
            return out;
        };
        QVERIFY(faces(adapted.mesh) == faces(mesh));
    }

    void the_same_mesh_comes_out_every_time() {
        const Mesh<3> mesh = make_cube<3>({.n = 3});
        AdaptReport report;
        const auto first = adapt(mesh, LayerMetric<3>(0.05, 0.3, 0.4), mtc_options(), report);
        const auto second = adapt(mesh, LayerMetric<3>(0.05, 0.3, 0.4), mtc_options(), report);
        QVERIFY(first.mesh == second.mesh);
    }

    void the_shape_alone_is_refused() {
        AdaptReport report;
        QVERIFY_THROWS_EXCEPTION(UsageError,
                                 (void)adapt(make_cube<2>({.n = 2}), UniformMetric<2>(0.5),
                                             mtc_options(Quality::shape), report));
        QVERIFY(quality_of({}) == Quality::shape);
        QVERIFY(quality_of(mtc_options()) == Quality::modified);
    }
};

QTEST_APPLESS_MAIN(MtcTest)
#include "mtc_test.moc"
