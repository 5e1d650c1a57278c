// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/collapse.h"

#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "core/cases/shell.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;
using shapes::nodes;

namespace {

/// Rules that stop nothing but what would make the mesh invalid or move a plane side.
constexpr SurfaceRules free_surface{
    .largest_turn_deg = 60, .relative_distance = 1e-9, .layer_share = 1e9};
constexpr QualityFloor no_floor{.floor = 0, .share = 0};

/// Collapses along edges picked at random.
template <int D>
class RandomCollapses {
public:
    RandomCollapses(Workbench<D>& bench, const SurfaceRules& surface, unsigned seed)
        : bench_(bench), surface_(surface), random_(seed) {}

    /// Tries one edge; true if it was collapsed.
    bool attempt() {
        const NodeId v(
            std::uniform_int_distribution<std::size_t>(0, bench_.edit.node_count() - 1)(random_));
        if (bench_.edit.is_removed(v)) {
            return false;
        }
        const auto around = neighbours(bench_.edit, v);
        const NodeId w =
            around[std::uniform_int_distribution<std::size_t>(0, around.size() - 1)(random_)];
        gather_ball(bench_.edit, v, ball_);
        const Verdict verdict =
            propose_collapse(bench_.edit, bench_.sizes, surface_, no_floor,
                             static_cast<double>(bench_.short_size[v]), {v, w}, ball_, star_);
        if (verdict == Verdict::accepted) {
            apply_collapse(bench_.edit, {v, w}, ball_, star_);
            return true;
        }
        return false;
    }

private:
    Workbench<D>& bench_;
    SurfaceRules surface_;
    std::mt19937 random_;
    Cavity<D> ball_;
    Star<D> star_;
};

/// Thousands of collapses at random, with a look at the whole mesh after every `stride` of them.
/// Returns how many were accepted.
template <int D>
int collapse_at_random(const Mesh<D>& mesh, int attempts, int stride, unsigned seed,
                       double tolerance = 1e-12) {
    Workbench<D> bench(mesh);
    RandomCollapses<D> collapses(bench, free_surface, seed);
    const Extent before = extent(mesh);
    int accepted = 0;
    for (int i = 0; i < attempts; ++i) {
        if (!collapses.attempt() || ++accepted % stride != 0) {
            continue;
        }
        const auto compact = bench.edit.compact();
        const CheckReport report = check(compact.mesh);
        const double changed = difference(before, extent(compact.mesh));
        if (!report.valid() || !(changed <= tolerance)) {
            qWarning("after %d collapses: %s, extent changed by %g", accepted,
                     report.summary().c_str(), changed);
            return -1;
        }
    }
    return accepted;
}

/// Where the frozen entities of a mesh are.
template <int D>
std::vector<std::vector<std::array<double, D>>> protected_places(const Mesh<D>& mesh) {
    std::vector<std::vector<std::array<double, D>>> places;
    const Features& f = mesh.features;
    for (const NodeId v : f.corners) {
        places.push_back(place_of<D>(mesh, std::array{v}));
    }
    for (const NodeId v : f.required_nodes) {
        places.push_back(place_of<D>(mesh, std::array{v}));
    }
    for (const int e : f.required_edges) {
        if constexpr (D == 2) {
            places.push_back(place_of<D>(mesh, mesh.faces[FaceId(e)]));
        } else {
            places.push_back(place_of<D>(mesh, f.edges[static_cast<std::size_t>(e)]));
        }
    }
    for (const int id : f.required_faces) {
        places.push_back(place_of<D>(mesh, mesh.faces[FaceId(id)]));
    }
    for (const int e : f.required_elements) {
        places.push_back(place_of<D>(mesh, mesh.elements[ElementId(e)]));
    }
    std::sort(places.begin(), places.end());
    return places;
}

/// Entities of all kinds in the middle of a list.
template <int D>
void require_some(Mesh<D>& mesh) {
    const NodeId middle(mesh.points.size() / 2);
    mesh.features.required_nodes = {middle};
    mesh.features.corners = {NodeId(mesh.points.size() / 3)};
    mesh.features.required_elements = {static_cast<int>(mesh.elements.size() / 4),
                                       static_cast<int>(mesh.elements.size() / 2)};
    if constexpr (D == 2) {
        mesh.features.required_edges = {3, static_cast<int>(mesh.faces.size()) - 1};
    } else {
        mesh.features.required_faces = {3, static_cast<int>(mesh.faces.size()) / 2};
        mesh.features.edges = {{mesh.faces[FaceId(7)][0], mesh.faces[FaceId(7)][1]}};
        mesh.features.edge_labels = {4};
        mesh.features.required_edges = {0};
    }
}

template <int D>
void keep_protected_entities(unsigned seed) {
    Mesh<D> mesh = make_cube<D>({.n = D == 2 ? 10 : 5, .diagonals = Diagonals::random});
    require_some(mesh);
    Workbench<D> bench(mesh);
    RandomCollapses<D> collapses(bench, free_surface, seed);
    int accepted = 0;
    for (int i = 0; i < 3000; ++i) {
        accepted += collapses.attempt();
    }
    QCOMPARE_GT(accepted, static_cast<int>(mesh.points.size()) / 4);
    const auto compact = bench.edit.compact();
    QVERIFY2(check(compact.mesh).valid(), check(compact.mesh).summary().c_str());
    QVERIFY(protected_places(compact.mesh) == protected_places(mesh));
}

template <int D>
Mesh<D> cube_of(int n, unsigned seed) {
    return make_cube<D>({.n = n,
                         .displace = 0.2,
                         .diagonals = Diagonals::random,
                         .seed = static_cast<int>(seed),
                         .shuffle = static_cast<int>(seed) + 1});
}

template <int D>
Mesh<D> layer_of(double aspect_ratio, unsigned seed) {
    return make_layer<D>({.nx = D == 2 ? 12 : 4,
                          .ny = 4,
                          .nz = 10,
                          .aspect_ratio = aspect_ratio,
                          .jitter = 0.2,
                          .diagonals = Diagonals::random,
                          .seed = static_cast<int>(seed),
                          .shuffle = static_cast<int>(seed) + 1});
}

} // namespace

class CollapseTest : public QObject {
    Q_OBJECT
private slots:
    void corners_never_leave();
    void ridge_nodes_leave_along_their_ridge_only();
    void patch_nodes_leave_along_the_boundary_only();
    void ridges_stay_joined_when_a_node_leaves_them();
    void refuses_what_falls_below_the_quality_floor();
    void boxes_stay_valid_and_whole_data();
    void boxes_stay_valid_and_whole();
    void layers_stay_valid_and_whole_data();
    void layers_stay_valid_and_whole();
    void notched_boxes_stay_valid_and_whole();
    void regions_keep_their_volume_and_interface();
    void curved_layers_and_shells_stay_valid();
    void protected_entities_stay();
};

void CollapseTest::corners_never_leave() {
    const Workbench<3> cube(shapes::cube(2));
    for (const NodeId v : cube.mesh.points.ids()) {
        if ((cube.mesh.points[v].array() == 1).count() +
                (cube.mesh.points[v].array() == 0).count() ==
            3) {
            for (const NodeId w : neighbours(cube.edit, v)) {
                QCOMPARE(allowed_by_geometry(cube.edit, {v, w}), Verdict::geometry_class);
            }
        }
    }
    const Workbench<2> square(shapes::square(2));
    for (const NodeId w : neighbours(square.edit, NodeId(0))) {
        QCOMPARE(allowed_by_geometry(square.edit, {NodeId(0), w}), Verdict::geometry_class);
    }
}

void CollapseTest::ridge_nodes_leave_along_their_ridge_only() {
    const Workbench<3> cube(shapes::cube(3));
    const NodeId v(1); // (1/3, 0, 0)
    for (const NodeId w : neighbours(cube.edit, v)) {
        const bool along = w == NodeId(0) || w == NodeId(2);
        QCOMPARE(allowed_by_geometry(cube.edit, {v, w}),
                 along ? Verdict::accepted : Verdict::geometry_class);
    }
}

void CollapseTest::patch_nodes_leave_along_the_boundary_only() {
    const Workbench<3> cube(shapes::cube(3));
    const NodeId v(5); // (1/3, 1/3, 0)
    int along = 0, inwards = 0;
    for (const NodeId w : neighbours(cube.edit, v)) {
        const bool on_side = cube.mesh.points[w][2] == 0;
        (on_side ? along : inwards) += 1;
        QCOMPARE(allowed_by_geometry(cube.edit, {v, w}),
                 on_side ? Verdict::accepted : Verdict::geometry_class);
    }
    QCOMPARE(along, 6);
    QCOMPARE_GT(inwards, 0);
    // An edge through the inside from one node of the boundary to another is no way out.
    const Workbench<2> strip(shapes::rectangle(shapes::uniform(4), {0, 1}));
    const NodeId low(2), high(7); // (1/2, 0), (1/2, 1)
    QCOMPARE(strip.edit.node_class(low), NodeClass::patch);
    QVERIFY(strip.edit.on_boundary(high));
    QCOMPARE(allowed_by_geometry(strip.edit, {low, high}), Verdict::geometry_class);
    QCOMPARE(allowed_by_geometry(strip.edit, {low, NodeId(1)}), Verdict::accepted);
}

void CollapseTest::ridges_stay_joined_when_a_node_leaves_them() {
    Workbench<3> cube(shapes::cube(3));
    const Collapse collapse{NodeId(1), NodeId(0)};
    Cavity<3> ball;
    Star<3> star;
    gather_ball(cube.edit, collapse.removed, ball);
    QCOMPARE(
        propose_collapse(cube.edit, cube.sizes, free_surface, no_floor, 1, collapse, ball, star),
        Verdict::accepted);
    QVERIFY(!cube.edit.is_ridge(NodeId(0), NodeId(2)));
    apply_collapse(cube.edit, collapse, ball, star);
    QVERIFY(cube.edit.is_removed(NodeId(1)));
    QVERIFY(cube.edit.is_ridge(NodeId(0), NodeId(2)));
    QVERIFY(!cube.edit.is_ridge(NodeId(0), NodeId(1)));
    QCOMPARE(cube.edit.compact().classes.ridges.size(), cube.classes.ridges.size() - 1);
}

void CollapseTest::refuses_what_falls_below_the_quality_floor() {
    const Workbench<2> square(shapes::square(4), isotropic<2>(25, 0.25));
    const Collapse collapse{NodeId(12), NodeId(13)};
    Cavity<2> ball;
    Star<2> star;
    gather_ball(square.edit, collapse.removed, ball);
    const auto verdict = [&](double floor, double share) {
        return propose_collapse(square.edit, square.sizes, free_surface, {floor, share}, 1,
                                collapse, ball, star);
    };
    QCOMPARE(verdict(0, 1), Verdict::accepted);
    const double left = star.worst_quality, before = worst_quality(square.edit, ball);
    QCOMPARE_LT(left, before);
    // The lower of the two bounds counts.
    QCOMPARE(verdict(1.001 * left, 1), Verdict::low_quality);
    QCOMPARE(verdict(0.999 * left, 1), Verdict::accepted);
    QCOMPARE(verdict(1, 1.001 * left / before), Verdict::low_quality);
    QCOMPARE(verdict(1, 0.999 * left / before), Verdict::accepted);
}

void CollapseTest::boxes_stay_valid_and_whole_data() {
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 4; ++seed) {
        QTest::addRow("seed %u", seed) << seed;
    }
}

void CollapseTest::boxes_stay_valid_and_whole() {
    QFETCH(unsigned, seed);
    // Nothing but the corners and what holds them apart is left in the end.
    QCOMPARE_GT(collapse_at_random<2>(cube_of<2>(12, seed), 4000, 10, seed), 100);
    QCOMPARE_GT(collapse_at_random<3>(cube_of<3>(5, seed), 4000, 10, seed), 130);
    // Every single step on a small one.
    QCOMPARE_GT(collapse_at_random<2>(cube_of<2>(4, seed), 1000, 1, seed), 10);
    QCOMPARE_GT(collapse_at_random<3>(cube_of<3>(2, seed), 1000, 1, seed), 10);
}

void CollapseTest::layers_stay_valid_and_whole_data() {
    QTest::addColumn<double>("aspect_ratio");
    for (const double ratio : {1e2, 1e4, 1e6, 1e8}) {
        QTest::addRow("%g", ratio) << ratio;
    }
}

void CollapseTest::layers_stay_valid_and_whole() {
    QFETCH(double, aspect_ratio);
    // Heights are so small that their rounding decides about the digits of the volumes.
    QCOMPARE_GT(collapse_at_random<2>(layer_of<2>(aspect_ratio, 1), 3000, 10, 5, 1e-11), 60);
    QCOMPARE_GT(collapse_at_random<3>(layer_of<3>(aspect_ratio, 1), 3000, 10, 5, 1e-11), 100);
}

void CollapseTest::notched_boxes_stay_valid_and_whole() {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        // A square and a cube without the quarter and the eighth at their high corner.
        const auto notched = [&](auto mesh) {
            auto result = mesh;
            result.elements.clear();
            result.region.clear();
            for (const auto& s : mesh.elements) {
                auto centre = mesh.points[s[0]];
                centre.setZero();
                for (const NodeId v : s) {
                    centre += mesh.points[v] / static_cast<double>(s.size());
                }
                if (centre.minCoeff() < 0.5) {
                    result.elements.push_back(s);
                    result.region.push_back(1);
                }
            }
            result.faces.clear();
            result.patch.clear();
            shapes::add_boundary(result);
            shapes::number_box_sides(result);
            return result;
        };
        const auto without_orphans = [](auto mesh) {
            decltype(mesh) result = mesh;
            result.points.clear();
            IdVector<NodeId, NodeId> id(mesh.points.size());
            for (auto& s : result.elements) {
                for (NodeId& v : s) {
                    if (!id[v].valid()) {
                        id[v] = result.points.next_id();
                        result.points.push_back(mesh.points[v]);
                    }
                    v = id[v];
                }
            }
            for (auto& f : result.faces) {
                for (NodeId& v : f) {
                    v = id[v];
                }
            }
            return result;
        };
        QCOMPARE_GT(
            collapse_at_random<2>(without_orphans(notched(shapes::square(8))), 3000, 10, seed), 30);
        QCOMPARE_GT(
            collapse_at_random<3>(without_orphans(notched(shapes::cube(4))), 3000, 10, seed), 50);
    }
}

void CollapseTest::regions_keep_their_volume_and_interface() {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        Mesh<2> square = cube_of<2>(10, seed);
        split_regions(square, 0.45);
        QCOMPARE_GT(collapse_at_random<2>(square, 3000, 10, seed), 40);
        Mesh<3> cube = cube_of<3>(5, seed);
        split_regions(cube, 0.45);
        QCOMPARE_GT(collapse_at_random<3>(cube, 3000, 10, seed), 60);
    }
}

void CollapseTest::curved_layers_and_shells_stay_valid() {
    const auto collapse_all = [](const auto& mesh, unsigned seed) {
        constexpr int D = std::decay_t<decltype(mesh)>::dimension;
        Workbench<D> bench(mesh);
        RandomCollapses<D> collapses(
            bench, {.largest_turn_deg = 45, .relative_distance = 0.5, .layer_share = 1}, seed);
        int accepted = 0;
        for (int i = 0; i < 6000; ++i) {
            if (collapses.attempt() && ++accepted % 20 == 0) {
                const CheckReport report = check(bench.edit.compact().mesh);
                QVERIFY2(report.valid(), report.summary().c_str());
            }
        }
        QCOMPARE_GT(accepted, static_cast<int>(mesh.points.size()) / 3);
    };
    collapse_all(make_layer<2>({.nx = 16, .nz = 10, .aspect_ratio = 100, .curvature = 0.7}), 1);
    collapse_all(make_layer<3>({.nx = 5, .ny = 5, .nz = 8, .aspect_ratio = 30, .curvature = 0.7}),
                 2);
    collapse_all(make_layer<3>({.nx = 6, .ny = 4, .nz = 6, .aspect_ratio = 100, .curvature = -2}),
                 3);
    collapse_all(make_shell({.frequency = 5, .aspect_ratio = 10, .growth = 2, .far_field = 3}), 4);
}

void CollapseTest::protected_entities_stay() {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        keep_protected_entities<2>(seed);
        keep_protected_entities<3>(seed);
    }
}

QTEST_APPLESS_MAIN(CollapseTest)
#include "collapse_test.moc"
