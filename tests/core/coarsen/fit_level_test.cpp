// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/fit_level.h"

#include "core/base/error.h"
#include "core/cases/cases.h"
#include "core/multigrid/transfer.h"

#include <QTest>

#include <map>

#include <Eigen/Geometry>

using namespace ameco;

namespace {

const Level<3>& small_wing() {
    static const Level<3> wing =
        finest_level(std::get<Mesh<3>>(make_case("onera-m6", {{"preset", "m6-8k"}})), {});
    return wing;
}

const Level<3>& isotropic_cube() {
    static const Level<3> cube =
        finest_level(std::get<Mesh<3>>(make_case("cube", {{"n", "14"}, {"displace", "0.2"}})), {});
    return cube;
}

template <int D>
struct Made {
    Level<D> level;
    CoarsenReport report;
};

template <int D>
Made<D> make_level(const Level<D>& fine, CoarseNodes nodes, double factor = 2) {
    CoarsenOptions options;
    options.nodes = nodes;
    options.target.factor = factor;
    Made<D> made;
    made.level = coarsen(fine, options, made.report);
    return made;
}

/// [L^(D-1)] by patch
std::map<int, double> patch_areas(const Mesh<3>& mesh) {
    std::map<int, double> areas;
    for (const FaceId f : mesh.faces.ids()) {
        const auto& n = mesh.faces[f];
        const Vec<3>& a = mesh.points[n[0]];
        areas[mesh.patch[f]] += (mesh.points[n[1]] - a).cross(mesh.points[n[2]] - a).norm() / 2;
    }
    return areas;
}

class StopAtMoves : public Monitor {
public:
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view step) override {
        stop_ = stop_ || step.find("moving") != std::string_view::npos;
    }
    [[nodiscard]] bool stop_requested() const override { return stop_; }

private:
    bool stop_ = false;
};

} // namespace

class FitLevelTest : public QObject {
    Q_OBJECT

private slots:
    void more_edges_are_in_band_and_no_node_comes_or_goes();
    void nodes_in_layers_stay_to_the_bit();
    void planar_patches_keep_their_area_and_corners_stay();
    void every_coarse_node_is_seen_by_a_fine_one();
    void injection_knows_only_nodes_that_stayed();
    void levels_of_several_steps_are_moved_once_at_their_end();
    void triangles_are_fitted_too();
    void a_stop_request_is_obeyed();
};

void FitLevelTest::more_edges_are_in_band_and_no_node_comes_or_goes() {
    for (const Level<3>* fine : {&small_wing(), &isotropic_cube()}) {
        const auto nested = make_level(*fine, CoarseNodes::nested);
        const auto moved = make_level(*fine, CoarseNodes::moved);
        QVERIFY(moved.report.check.valid());
        QVERIFY(moved.report.moves[Verdict::accepted] > 0);
        QCOMPARE(nested.report.moves[Verdict::accepted], 0);
        QCOMPARE(moved.level.parent.raw(), nested.level.parent.raw());
        QVERIFY(moved.report.conformity.in_band > nested.report.conformity.in_band + 0.04);
        QVERIFY(moved.report.conformity.mean_quality > nested.report.conformity.mean_quality);
    }
}

void FitLevelTest::nodes_in_layers_stay_to_the_bit() {
    const Level<3>& fine = small_wing();
    const MetricField<3> target = target_metric(fine.mesh, fine.natural, {});
    const auto moved = make_level(fine, CoarseNodes::moved);
    int in_layers = 0, gone = 0;
    for (const NodeId v : moved.level.parent.ids()) {
        const NodeId p = moved.level.parent[v];
        const bool same = moved.level.mesh.points[v] == fine.mesh.points[p];
        gone += same ? 0 : 1;
        if (target[p].sizes[2] >= FitOptions().stretched * target[p].sizes[0]) {
            ++in_layers;
            QVERIFY(same);
        }
    }
    QVERIFY(in_layers > 500);
    QVERIFY(gone > 500);
}

void FitLevelTest::planar_patches_keep_their_area_and_corners_stay() {
    const Level<3>& fine = isotropic_cube();
    const auto moved = make_level(fine, CoarseNodes::moved);
    const auto before = patch_areas(fine.mesh);
    const auto after = patch_areas(moved.level.mesh);
    QCOMPARE(after.size(), before.size());
    for (const auto& [patch, area] : before) {
        QVERIFY(std::abs(after.at(patch) - area) < 1e-12 * area);
    }
    QVERIFY(std::abs(moved.report.check.volume - 1) < 1e-12);
    int corners = 0, moved_on_patches = 0;
    for (const NodeId v : moved.level.parent.ids()) {
        const bool same = moved.level.mesh.points[v] == fine.mesh.points[moved.level.parent[v]];
        if (moved.level.geometry.node[v] == NodeClass::frozen) {
            ++corners;
            QVERIFY(same);
        }
        moved_on_patches += moved.level.geometry.node[v] == NodeClass::patch && !same ? 1 : 0;
    }
    QCOMPARE(corners, 8);
    QVERIFY(moved_on_patches > 0);
}

void FitLevelTest::every_coarse_node_is_seen_by_a_fine_one() {
    Level<3> fine = small_wing();
    for (int k = 0; k < 3; ++k) {
        auto moved = make_level(fine, CoarseNodes::moved);
        const Transfer transfer = make_transfer(fine.mesh, moved.level.mesh, moved.level.parent);
        const TransferCheck checked = check(transfer, fine.mesh, moved.level.mesh);
        QVERIFY2(checked.passed(), checked.failures().c_str());
        fine = std::move(moved.level);
    }
}

void FitLevelTest::injection_knows_only_nodes_that_stayed() {
    const Level<3>& fine = isotropic_cube();
    const auto moved = make_level(fine, CoarseNodes::moved);
    const Transfer transfer = make_transfer(fine.mesh, moved.level.mesh, moved.level.parent);
    int none = 0;
    for (const NodeId c : transfer.parent.ids()) {
        const NodeId p = transfer.parent[c];
        none += p.valid() ? 0 : 1;
        QVERIFY(!p.valid() || fine.mesh.points[p] == moved.level.mesh.points[c]);
    }
    QVERIFY(none > 0);
    // The same as if nobody had told which node came from where.
    const Transfer matched = make_transfer(fine.mesh, moved.level.mesh);
    QCOMPARE(transfer.parent.raw(), matched.parent.raw());
    QCOMPARE((transfer.P - matched.P).norm(), 0.0);
}

void FitLevelTest::levels_of_several_steps_are_moved_once_at_their_end() {
    const Level<3>& fine = isotropic_cube();
    const auto nested = make_level(fine, CoarseNodes::nested, 4);
    const auto moved = make_level(fine, CoarseNodes::moved, 4);
    QCOMPARE(moved.level.parent.raw(), nested.level.parent.raw());
    QVERIFY(moved.report.conformity.in_band > nested.report.conformity.in_band + 0.04);
}

void FitLevelTest::triangles_are_fitted_too() {
    const auto mesh =
        std::get<Mesh<2>>(make_case("cube", {{"dim", "2"}, {"n", "24"}, {"displace", "0.2"}}));
    const Level<2> fine = finest_level(Mesh<2>(mesh), {});
    const auto nested = make_level(fine, CoarseNodes::nested);
    const auto moved = make_level(fine, CoarseNodes::moved);
    QCOMPARE(moved.level.parent.raw(), nested.level.parent.raw());
    QVERIFY(moved.report.conformity.in_band > nested.report.conformity.in_band);
    QVERIFY(std::abs(moved.report.check.volume - 1) < 1e-12);
}

void FitLevelTest::a_stop_request_is_obeyed() {
    const Level<3>& fine = isotropic_cube();
    CoarsenOptions options;
    options.nodes = CoarseNodes::moved;
    CoarsenReport report;
    StopAtMoves monitor;
    QVERIFY_THROWS_EXCEPTION(Cancelled, (void)coarsen(fine, options, report, monitor));
}

QTEST_GUILESS_MAIN(FitLevelTest)
#include "fit_level_test.moc"
