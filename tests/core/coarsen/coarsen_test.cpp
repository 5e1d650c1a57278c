// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/coarsen.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cases/box.h"
#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "core/cases/onera_m6.h"
#include "tests/support/faces.h"

#include <QTest>

#include <atomic>
#include <set>

using namespace ameco;

namespace {

/// Levels 1 ... n of a mesh, with their reports.
template <int D>
struct Run {
    std::vector<Level<D>> levels;
    std::vector<CoarsenReport> reports;
};

template <int D>
Run<D> run(Mesh<D> mesh, int levels, const CoarsenOptions& options = {}) {
    Run<D> out;
    out.levels.push_back(finest_level(std::move(mesh), options));
    for (int k = 0; k < levels; ++k) {
        CoarsenReport report;
        out.levels.push_back(coarsen(out.levels.back(), options, report));
        out.reports.push_back(report);
    }
    return out;
}

/// Ids on the finest level of the nodes of each level.
template <int D>
std::vector<std::vector<NodeId>> finest_ids(const Run<D>& run) {
    std::vector<std::vector<NodeId>> out(run.levels.size());
    for (const NodeId v : run.levels[0].mesh.points.ids()) {
        out[0].push_back(v);
    }
    for (std::size_t k = 1; k < run.levels.size(); ++k) {
        for (const NodeId parent : run.levels[k].parent) {
            out[k].push_back(out[k - 1][parent.index()]);
        }
    }
    return out;
}

/// Share of the nodes of level k that lie in a layer whose number is no multiple of 2^k.
template <int D>
double share_in_wrong_layers(const Run<D>& run, std::size_t k, int nodes_per_layer) {
    const auto ids = finest_ids(run);
    const auto wrong = std::count_if(ids[k].begin(), ids[k].end(), [&](NodeId v) {
        return (v.value() / nodes_per_layer) % (1 << k) != 0;
    });
    return static_cast<double>(wrong) / static_cast<double>(ids[k].size());
}

template <int D>
std::set<std::array<double, D>> corner_points(const Level<D>& level) {
    std::set<std::array<double, D>> out;
    for (const NodeId v : level.mesh.points.ids()) {
        if (level.geometry.node[v] == NodeClass::frozen) {
            std::array<double, D> x;
            std::copy_n(level.mesh.points[v].data(), D, x.begin());
            out.insert(x);
        }
    }
    return out;
}

/// Asks to stop after so many questions.
class ImpatientMonitor : public Monitor {
public:
    explicit ImpatientMonitor(int patience) : patience_(patience) {}
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view) override {}
    [[nodiscard]] bool stop_requested() const override { return --patience_ < 0; }

private:
    mutable std::atomic<int> patience_; ///< threads ask too
};

/// Asks to stop as soon as a step is reported.
class StopAt : public Monitor {
public:
    explicit StopAt(std::string_view step) : step_(step) {}
    void message(Severity, std::string_view) override {}
    void progress(double, std::string_view step) override { stop_ = stop_ || step == step_; }
    [[nodiscard]] bool stop_requested() const override { return stop_; }

private:
    std::string_view step_;
    std::atomic<bool> stop_ = false; ///< threads ask too
};

} // namespace

class CoarsenTest : public QObject {
    Q_OBJECT
private slots:
    void the_box_of_section_5_1_loses_its_middle_layer_data();
    void the_box_of_section_5_1_loses_its_middle_layer();
    void layers_lose_every_other_layer_data();
    void layers_lose_every_other_layer();
    void flat_layers_in_2d_lose_every_other_layer_data();
    void flat_layers_in_2d_lose_every_other_layer();
    void large_factors_keep_every_fourth_or_eighth_layer_data();
    void large_factors_keep_every_fourth_or_eighth_layer();
    void numbering_does_not_matter_for_layers();
    void graded_layers_coarsen_at_least_as_the_ideal_mesh_data();
    void graded_layers_coarsen_at_least_as_the_ideal_mesh();
    void coarse_nodes_are_fine_nodes_and_planar_geometry_stays();
    void a_small_wing_keeps_its_patches_and_stays_valid();
    void threads_do_not_change_the_result_data();
    void threads_do_not_change_the_result();
    void parts_do_not_show_in_layers();
    void parts_cost_no_quality();
    void frozen_patches_are_left_untouched();
    void the_boundary_is_kept_when_asked();
    void a_request_to_stop_is_answered_with_cancelled_data();
    void a_request_to_stop_is_answered_with_cancelled();
    void each_step_can_be_stopped_data();
    void each_step_can_be_stopped();
    void the_boundary_stays_within_its_tolerance();
    void isotropic_meshes_are_coarsened_in_all_directions();
};

void CoarsenTest::the_box_of_section_5_1_loses_its_middle_layer_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<double>("ratio");
    QTest::addColumn<bool>("alternating");
    for (const int dimension : {2, 3}) {
        for (const double ratio : {1e-3, 1e-4, 1e-5, 1e-6}) {
            for (const bool alternating : {false, true}) {
                QTest::addRow("%d-D, dz/dx %g, %s diagonals", dimension, ratio,
                              alternating ? "alternating" : "uniform")
                    << dimension << ratio << alternating;
            }
        }
    }
}

void CoarsenTest::the_box_of_section_5_1_loses_its_middle_layer() {
    QFETCH(int, dimension);
    QFETCH(double, ratio);
    QFETCH(bool, alternating);
    BoxOptions box;
    box.ratio = ratio;
    box.diagonals = alternating ? Diagonals::alternating : Diagonals::uniform;
    const auto expect = [&](auto mesh, std::int64_t before, std::int64_t after) {
        const int axis = decltype(mesh)::dimension - 1;
        const auto result = run(std::move(mesh), 1);
        QCOMPARE(result.reports[0].nodes_before, before);
        QCOMPARE(result.reports[0].nodes_after, after);
        for (const auto& x : result.levels[1].mesh.points) {
            QVERIFY(x[axis] == 0 || x[axis] == 2 * ratio);
        }
    };
    if (dimension == 2) {
        expect(make_box<2>(box), 9, 6);
    } else {
        expect(make_box<3>(box), 27, 18);
    }
}

void CoarsenTest::layers_lose_every_other_layer_data() {
    QTest::addColumn<double>("aspect_ratio");
    QTest::addColumn<double>("growth");
    QTest::addRow("AR 1e2") << 1e2 << 1.0;
    QTest::addRow("AR 1e4") << 1e4 << 1.0;
    QTest::addRow("AR 1e5") << 1e5 << 1.0;
    QTest::addRow("AR 1e6") << 1e6 << 1.0;
    // 1.2^32 = 342: these stay anisotropic to the top.
    QTest::addRow("AR 1e5, growth 1.2") << 1e5 << 1.2;
    QTest::addRow("AR 1e6, growth 1.2") << 1e6 << 1.2;
}

void CoarsenTest::layers_lose_every_other_layer() {
    QFETCH(double, aspect_ratio);
    QFETCH(double, growth);
    LayerOptions layer;
    layer.aspect_ratio = aspect_ratio;
    layer.growth = growth;
    const auto result = run(make_layer<3>(layer), 5);
    const int per_layer = (layer.nx + 1) * (layer.ny + 1);
    int layers = 33;
    for (std::size_t k = 1; k <= 5; ++k) {
        const int kept = (layers + 1) / 2;
        const auto& report = result.reports[k - 1];
        const double ratio =
            static_cast<double>(report.nodes_before) / static_cast<double>(report.nodes_after);
        const double ideal = static_cast<double>(layers) / kept;
        QVERIFY2(std::abs(ratio / ideal - 1) < 0.01,
                 qPrintable(
                     QStringLiteral("level %1: ratio %2, ideal %3").arg(k).arg(ratio).arg(ideal)));
        QVERIFY(share_in_wrong_layers(result, k, per_layer) < 0.01);
        layers = kept;
    }
}

void CoarsenTest::flat_layers_in_2d_lose_every_other_layer_data() {
    layers_lose_every_other_layer_data();
}

void CoarsenTest::flat_layers_in_2d_lose_every_other_layer() {
    QFETCH(double, aspect_ratio);
    QFETCH(double, growth);
    LayerOptions layer;
    layer.nx = 96;
    layer.aspect_ratio = aspect_ratio;
    layer.growth = growth;
    const auto result = run(make_layer<2>(layer), 5);
    int layers = 33;
    for (std::size_t k = 1; k <= 5; ++k) {
        const int kept = (layers + 1) / 2;
        QCOMPARE(result.reports[k - 1].nodes_after,
                 static_cast<std::int64_t>(kept * (layer.nx + 1)));
        QCOMPARE(share_in_wrong_layers(result, k, layer.nx + 1), 0.0);
        layers = kept;
    }
}

void CoarsenTest::large_factors_keep_every_fourth_or_eighth_layer_data() {
    QTest::addColumn<double>("factor");
    QTest::addColumn<int>("spacing");
    QTest::addRow("factor 4") << 4.0 << 4;
    QTest::addRow("factor 8") << 8.0 << 8;
}

void CoarsenTest::large_factors_keep_every_fourth_or_eighth_layer() {
    QFETCH(double, factor);
    QFETCH(int, spacing);
    LayerOptions layer;
    layer.nx = layer.ny = 10;
    layer.growth = 1;
    CoarsenOptions options;
    options.target.factor = factor;
    const auto result = run(make_layer<3>(layer), 1, options);
    const int per_layer = (layer.nx + 1) * (layer.ny + 1);
    const CoarsenReport& report = result.reports[0];
    QCOMPARE(report.nodes_before, std::int64_t{33 * per_layer});
    QCOMPARE(report.nodes_after, static_cast<std::int64_t>((32 / spacing + 1) * per_layer));
    QCOMPARE(report.factor, factor);
    QVERIFY(std::abs(static_cast<double>(report.nodes_after) / report.predicted_nodes - 1) < 0.05);
    // Parents are nodes of the fine mesh, not of one in between.
    const Level<3>& fine = result.levels[0];
    const Level<3>& coarse = result.levels[1];
    for (const NodeId v : coarse.mesh.points.ids()) {
        QCOMPARE(coarse.mesh.points[v], fine.mesh.points[coarse.parent[v]]);
        QCOMPARE((coarse.parent[v].value() / per_layer) % spacing, 0);
    }
}

void CoarsenTest::numbering_does_not_matter_for_layers() {
    LayerOptions layer;
    layer.growth = 1;
    for (const int seed : {1, 2, 3}) {
        layer.shuffle = seed;
        const auto result = run(make_layer<3>(layer), 2);
        QCOMPARE(result.reports[0].nodes_after, std::int64_t{17 * 25 * 25});
        QCOMPARE(result.reports[1].nodes_after, std::int64_t{9 * 25 * 25});
    }
}

void CoarsenTest::graded_layers_coarsen_at_least_as_the_ideal_mesh_data() {
    QTest::addColumn<double>("aspect_ratio");
    QTest::addRow("AR 1e2") << 1e2;
    QTest::addRow("AR 1e4") << 1e4;
}

void CoarsenTest::graded_layers_coarsen_at_least_as_the_ideal_mesh() {
    QFETCH(double, aspect_ratio);
    // Isotropic near the top: the ideal there is ratio 8, in the layers 2. The bound is the mesh
    // that keeps every 2^k-th layer of the same columns.
    LayerOptions layer;
    layer.growth = 1.2;
    layer.nz = 64;
    layer.aspect_ratio = aspect_ratio;
    const auto result = run(make_layer<3>(layer), 3);
    for (std::size_t k = 1; k <= 3; ++k) {
        LayerOptions ideal = layer;
        ideal.every = 1 << k;
        QVERIFY(static_cast<double>(result.reports[k - 1].nodes_after) <=
                1.01 * static_cast<double>(make_layer<3>(ideal).points.size()));
    }
}

void CoarsenTest::coarse_nodes_are_fine_nodes_and_planar_geometry_stays() {
    LayerOptions layer;
    layer.nx = layer.ny = 10;
    layer.growth = 1.3;
    layer.aspect_ratio = 1e3;
    const auto result = run(make_layer<3>(layer), 4);
    const Level<3>& fine = result.levels.front();
    const double volume = check(fine.mesh).volume;
    for (std::size_t k = 1; k < result.levels.size(); ++k) {
        const Level<3>& level = result.levels[k];
        QVERIFY(level.mesh.points.size() < result.levels[k - 1].mesh.points.size());
        for (const NodeId v : level.mesh.points.ids()) {
            QCOMPARE(level.mesh.points[v], result.levels[k - 1].mesh.points[level.parent[v]]);
        }
        QVERIFY(std::is_sorted(level.parent.begin(), level.parent.end()));
        QCOMPARE(level.mesh.patch_names, fine.mesh.patch_names);
        QVERIFY(std::abs(result.reports[k - 1].check.volume / volume - 1) < 1e-12);
        QCOMPARE(corner_points(level), corner_points(fine));
    }
}

void CoarsenTest::a_small_wing_keeps_its_patches_and_stays_valid() {
    const auto preset = onera_m6_presets().front();
    QCOMPARE(preset.name, std::string("m6-8k"));
    const auto result = run(make_onera_m6(preset.options), 4);
    for (std::size_t k = 1; k < result.levels.size(); ++k) {
        const Mesh<3>& mesh = result.levels[k].mesh;
        QVERIFY(result.reports[k - 1].check.valid());
        QCOMPARE(std::set<int>(mesh.patch.begin(), mesh.patch.end()), (std::set<int>{1, 2, 3}));
        for (const FaceId f : mesh.faces.ids()) {
            for (const NodeId v : mesh.faces[f]) {
                QVERIFY(mesh.patch[f] != 2 || mesh.points[v][1] == 0); // symmetry plane, exactly
            }
        }
    }
    QVERIFY(result.levels[4].mesh.points.size() * 8 < result.levels[0].mesh.points.size());
}

void CoarsenTest::threads_do_not_change_the_result_data() {
    QTest::addColumn<int>("nodes_per_part");
    QTest::addRow("whole mesh") << 1000000;
    QTest::addRow("8 parts") << 1000;
}

void CoarsenTest::threads_do_not_change_the_result() {
    QFETCH(int, nodes_per_part);
    const auto mesh = make_onera_m6(onera_m6_presets().front().options);
    CoarsenOptions options;
    options.nodes_per_part = static_cast<std::size_t>(nodes_per_part);
    set_thread_count(1);
    const auto one = run(mesh, 2, options);
    for (const int threads : {2, 3, 8}) {
        set_thread_count(threads);
        const auto several = run(mesh, 2, options);
        for (std::size_t k = 0; k < one.levels.size(); ++k) {
            QVERIFY(one.levels[k].mesh == several.levels[k].mesh);
            QVERIFY(one.levels[k].natural == several.levels[k].natural);
            QVERIFY(one.levels[k].geometry.deviation == several.levels[k].geometry.deviation);
        }
        QVERIFY(one.reports[0].removal.counts == several.reports[0].removal.counts);
        QVERIFY(one.reports[0].swaps.counts == several.reports[0].swaps.counts);
    }
    set_thread_count(0);
}

/// Lines across layers lie in one part each, and lose the nodes of the same layers in all of them.
void CoarsenTest::parts_do_not_show_in_layers() {
    CoarsenOptions options;
    options.nodes_per_part = 500;
    LayerOptions layer;
    layer.growth = 1;
    const auto result = run(make_layer<3>(layer), 2, options);
    QCOMPARE(result.reports[0].nodes_after, std::int64_t{17 * 25 * 25});
    QCOMPARE(result.reports[1].nodes_after, std::int64_t{9 * 25 * 25});
    for (const std::size_t k : {1, 2}) {
        QCOMPARE(share_in_wrong_layers(result, k, 25 * 25), 0.0);
    }
    layer.nx = 96;
    const auto flat = run(make_layer<2>(layer), 2, options);
    QCOMPARE(flat.reports[0].nodes_after, std::int64_t{17 * 97});
    QCOMPARE(flat.reports[1].nodes_after, std::int64_t{9 * 97});
}

void CoarsenTest::parts_cost_no_quality() {
    const auto mesh = make_onera_m6(onera_m6_presets().front().options);
    CoarsenOptions options;
    const auto whole = run(mesh, 2, options);
    options.nodes_per_part = 1000; // 8 parts
    const auto cut = run(mesh, 2, options);
    for (std::size_t k = 0; k < 2; ++k) {
        const CoarsenReport &a = whole.reports[k], &b = cut.reports[k];
        QVERIFY(std::abs(static_cast<double>(b.nodes_after) / static_cast<double>(a.nodes_after) -
                         1) < 0.03);
        QVERIFY(b.conformity.in_band > a.conformity.in_band - 0.02);
    }
}

void CoarsenTest::frozen_patches_are_left_untouched() {
    const auto mesh = make_onera_m6(onera_m6_presets().front().options);
    CoarsenOptions options;
    options.features.frozen_patches = {3};
    const auto result = run(mesh, 2, options);
    QCOMPARE(test::faces_of(result.levels[2].mesh, 3), test::faces_of(mesh, 3));
    QVERIFY(result.levels[2].mesh.points.size() * 2 < mesh.points.size());
}

void CoarsenTest::the_boundary_is_kept_when_asked() {
    CoarsenOptions options;
    options.features.boundary = BoundaryChoice::keep;
    const auto wing = make_onera_m6(onera_m6_presets().front().options);
    const auto levels = run(wing, 2, options).levels;
    const auto square = make_cube<2>({.n = 12, .displace = 0.2});
    const auto flat = run(square, 2, options).levels;
    for (std::size_t k = 1; k <= 2; ++k) {
        QCOMPARE(test::faces_of(levels[k].mesh), test::faces_of(wing));
        QCOMPARE(test::faces_of(flat[k].mesh), test::faces_of(square));
        QVERIFY(levels[k].mesh.points.size() < levels[k - 1].mesh.points.size());
        QVERIFY(flat[k].mesh.points.size() < flat[k - 1].mesh.points.size());
    }
}

void CoarsenTest::a_request_to_stop_is_answered_with_cancelled_data() {
    QTest::addColumn<int>("patience");
    QTest::addColumn<int>("nodes_per_part");
    for (const int nodes_per_part : {1000000, 1000}) {
        for (const int patience : {0, 1, 2, 4, 6, 20}) {
            QTest::addRow("after %d questions, %s", patience,
                          nodes_per_part == 1000 ? "parts" : "whole")
                << patience << nodes_per_part;
        }
    }
}

void CoarsenTest::a_request_to_stop_is_answered_with_cancelled() {
    QFETCH(int, patience);
    QFETCH(int, nodes_per_part);
    const Level<3> fine = finest_level(make_layer<3>({}), {});
    ImpatientMonitor monitor(patience);
    CoarsenReport report;
    CoarsenOptions options;
    options.nodes_per_part = static_cast<std::size_t>(nodes_per_part);
    QVERIFY_THROWS_EXCEPTION(Cancelled, (void)coarsen(fine, options, report, monitor));
}

void CoarsenTest::each_step_can_be_stopped_data() {
    QTest::addColumn<std::string>("step");
    for (const char* step :
         {"ordering nodes", "removing nodes", "swapping", "swapping for lengths"}) {
        QTest::newRow(step) << std::string(step);
    }
}

void CoarsenTest::each_step_can_be_stopped() {
    QFETCH(std::string, step);
    const Level<3> fine = finest_level(make_layer<3>({}), {});
    StopAt monitor(step);
    CoarsenReport report;
    QVERIFY_THROWS_EXCEPTION(Cancelled, (void)coarsen(fine, {}, report, monitor));
}

void CoarsenTest::the_boundary_stays_within_its_tolerance() {
    LayerOptions layer;
    layer.curvature = 2;
    layer.growth = 1.3;
    layer.aspect_ratio = 100;
    const auto result = run(make_layer<3>(layer), 3);
    const double volume = check(result.levels[0].mesh).volume;
    QVERIFY(std::abs(result.reports[2].check.volume / volume - 1) < 0.02);
    for (const CoarsenReport& report : result.reports) {
        QVERIFY(report.deviation < 0.05); // the cells are about 0.1 wide
    }
}

/// Displaced nodes and diagonals at random: 8 (4 in 2-D) would be ideal.
void CoarsenTest::isotropic_meshes_are_coarsened_in_all_directions() {
    const auto ratio = [](const auto& mesh, double below) {
        CoarsenOptions options;
        options.target.isotropic_below = below;
        CoarsenReport report;
        (void)coarsen(finest_level(mesh, options), options, report);
        return static_cast<double>(report.nodes_before) / static_cast<double>(report.nodes_after);
    };
    CubeOptions cube;
    cube.n = 14;
    cube.diagonals = Diagonals::random;
    const Mesh<3> solid = make_cube<3>(cube);
    QCOMPARE_GE(ratio(solid, CoarsenOptions().target.isotropic_below), 4.5);
    QCOMPARE_LE(ratio(solid, 1), 3.7); // the paper's Algorithm 1
    cube.n = 40;
    QCOMPARE_GE(ratio(make_cube<2>(cube), CoarsenOptions().target.isotropic_below), 3.5);
}

QTEST_APPLESS_MAIN(CoarsenTest)
#include "coarsen_test.moc"
