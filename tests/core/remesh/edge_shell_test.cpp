// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/edge_shell.h"

#include "core/cases/cube.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

#include <set>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

/// Calls `visit(a, b, shell)` for every edge.
template <int D, class Visit>
void for_each_edge(const Workbench<D>& bench, const Visit& visit) {
    Cavity<D> shell;
    for (const Edge& e : edges_of(node_neighbours(bench.mesh))) {
        gather_shell(bench.edit, e[0], e[1], shell);
        visit(e[0], e[1], shell);
    }
}

/// Whether both points lie on the same side of the unit cube.
bool on_one_side(const Vec<3>& a, const Vec<3>& b) {
    for (int k = 0; k < 3; ++k) {
        if (a[k] == b[k] && (a[k] == 0 || a[k] == 1)) {
            return true;
        }
    }
    return false;
}

} // namespace

class EdgeShellTest : public QObject {
    Q_OBJECT
private slots:
    void edges_of_the_boundary_are_those_with_both_ends_on_one_side() {
        const Workbench<3> bench(make_cube<3>({.n = 3, .displace = 0}));
        int inside = 0, outside = 0;
        for_each_edge(bench, [&](NodeId a, NodeId b, const Cavity<3>& shell) {
            const bool expected = on_one_side(bench.mesh.points[a], bench.mesh.points[b]);
            QCOMPARE(is_boundary_edge(bench.edit, a, b), expected);
            QCOMPARE(at_boundary(bench.edit, shell), expected);
            (expected ? outside : inside) += 1;
        });
        QVERIFY(inside > 0 && outside > 0);
    }

    void stars_that_are_dropped_are_those_of_a_node_that_stays() {
        const Workbench<3> bench(make_cube<3>({.n = 4}));
        const auto elements_from = [&](const Cavity<3>& shell, NodeId node) {
            Star<3> star;
            join_star(bench.edit, shell, node, star);
            std::set<Simplex<3>> elements;
            for (const EditElement<3>& e : star.elements) {
                elements.insert(sorted(e.nodes));
            }
            return elements;
        };
        int dropped = 0, all_stay = 0;
        for_each_edge(bench, [&](NodeId a, NodeId b, const Cavity<3>& shell) {
            std::vector<NodeId> ring;
            shell_ring(bench.edit, a, b, shell, ring);
            std::vector<NodeId> left = ring;
            drop_equal_stars(bench.edit, shell, left);
            QVERIFY(std::includes(ring.begin(), ring.end(), left.begin(), left.end()));
            std::set<std::set<Simplex<3>>> stars, of_left;
            for (const NodeId v : ring) {
                stars.insert(elements_from(shell, v));
            }
            for (const NodeId v : left) {
                of_left.insert(elements_from(shell, v));
            }
            if (!at_boundary(bench.edit, shell)) {
                QCOMPARE(of_left, stars);
                QCOMPARE(left.size(), stars.size());
            } else {
                QCOMPARE(left, ring);
            }
            (left.size() < ring.size() ? dropped : all_stay) += 1;
        });
        QVERIFY(dropped > 0 && all_stay > 0);
    }

    void the_ring_goes_once_around_the_edge() {
        const Workbench<3> bench(make_cube<3>({.n = 3}));
        for_each_edge(bench, [&](NodeId a, NodeId b, const Cavity<3>& shell) {
            std::vector<NodeId> ring;
            shell_ring(bench.edit, a, b, shell, ring);
            QVERIFY(std::is_sorted(ring.begin(), ring.end()));
            if (at_boundary(bench.edit, shell)) {
                QCOMPARE(ring.size(), std::size_t{2}); // one behind each boundary face
            } else {
                QCOMPARE(ring.size(), shell.elements.size());
            }
            for (const NodeId v : ring) {
                QVERIFY(v != a && v != b && v != bench.edit.ghost());
            }
        });
    }

    void ridges_get_nodes_but_do_not_leave() {
        const Workbench<3> bench(make_cube<3>({.n = 2, .displace = 0}));
        int ridges = 0;
        for_each_edge(bench, [&](NodeId a, NodeId b, const Cavity<3>& shell) {
            const bool ridge = bench.edit.is_ridge(a, b);
            ridges += ridge ? 1 : 0;
            QCOMPARE(allowed_to_change(bench.edit, a, b, shell), Verdict::accepted);
            QCOMPARE(allowed_to_leave(bench.edit, a, b, shell),
                     ridge ? Verdict::geometry_class : Verdict::accepted);
        });
        QCOMPARE(ridges, 24);
    }

    void edges_of_frozen_patches_stay() {
        const Mesh<3> mesh = make_cube<3>({.n = 2, .displace = 0});
        FeatureOptions features;
        features.frozen_patches = {mesh.patch[FaceId(0)]};
        const Workbench<3> bench(mesh, nodal_metric(mesh), features);
        int kept = 0;
        for_each_edge(bench, [&](NodeId a, NodeId b, const Cavity<3>& shell) {
            const bool frozen =
                std::any_of(shell.elements.begin(), shell.elements.end(), [&](ElementId e) {
                    return bench.edit.is_ghost(e) &&
                           bench.edit.element(e).label == features.frozen_patches[0];
                });
            kept += frozen ? 1 : 0;
            QCOMPARE(allowed_to_change(bench.edit, a, b, shell),
                     frozen ? Verdict::geometry_class : Verdict::accepted);
        });
        QVERIFY(kept > 0);
    }

    void edges_between_regions_do_not_leave() {
        Mesh<3> mesh = make_cube<3>({.n = 2, .displace = 0});
        split_regions(mesh, 0.5);
        const Workbench<3> bench(mesh);
        int between = 0;
        for_each_edge(bench, [&](NodeId a, NodeId b, const Cavity<3>& shell) {
            std::set<int> regions;
            for (const ElementId e : shell.elements) {
                if (!bench.edit.is_ghost(e)) {
                    regions.insert(bench.edit.element(e).label);
                }
            }
            if (regions.size() > 1) {
                ++between;
                QVERIFY(!has_one_label(bench.edit, shell));
                QVERIFY(allowed_to_leave(bench.edit, a, b, shell) != Verdict::accepted);
            }
        });
        QVERIFY(between > 0);
    }

    void a_box_of_corners_only_may_change() {
        // All nodes are frozen corners, but no face is.
        const Workbench<2> bench(make_cube<2>({.n = 1, .displace = 0}));
        for_each_edge(bench, [&](NodeId a, NodeId b, const Cavity<2>& shell) {
            QCOMPARE(bench.edit.node_class(a), NodeClass::frozen);
            QCOMPARE(allowed_to_change(bench.edit, a, b, shell), Verdict::accepted);
        });
    }
};

QTEST_APPLESS_MAIN(EdgeShellTest)
#include "edge_shell_test.moc"
