// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/original_surface.h"

#include "core/base/parallel.h"
#include "core/remesh/collapse.h"
#include "tests/core/remesh/round_shapes.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

/// For collapses that may move the boundary far.
constexpr SurfaceRules loose{.largest_turn_deg = 60, .relative_distance = 9, .layer_share = 1e9};

struct Bounds {
    double largest = 0, sum = 0;
};

template <int D>
Bounds bounds_of(const GeometryClasses<D>& classes) {
    Bounds b;
    for (const double d : classes.deviation) {
        b.largest = std::max(b.largest, d);
        b.sum += d;
    }
    return b;
}

/// Largest distance of the nodes of one mesh's boundary to that of another.
template <int D>
double farthest_node(const Mesh<D>& from, const Mesh<D>& to) {
    const BoundaryProjection<D> projection(to);
    double largest = 0;
    for (const Facet<D>& face : from.faces) {
        for (const NodeId v : face) {
            largest = std::max(largest, projection.project(from.points[v]).distance);
        }
    }
    return largest;
}

template <int D>
void measure_often(const Mesh<D>& mesh) {
    Workbench<D> bench(mesh);
    std::mt19937 random(3);
    BoundaryDistance<D> again;
    bool less = false;
    for (int pass = 0; pass < 5; ++pass) {
        (void)collapse_boundary_nodes(bench, random, 200, loose);
        const double summed = bounds_of(bench.edit.compact().classes).sum;
        again.measure(bench.edit);
        const auto now = bench.edit.compact();
        for (const FaceId f : now.mesh.faces.ids()) {
            // Rounding of the distance.
            QCOMPARE_GE(now.classes.deviation[f], sampled_distance(now.mesh, f, mesh) - 1e-15);
        }
        const Bounds bounds = bounds_of(now.classes);
        QCOMPARE_GE(bounds.largest, farthest_node(mesh, now.mesh) - 1e-15);
        less = less || bounds.sum < 0.8 * summed;

        EditMesh<D> copy(now.mesh, now.classes);
        BoundaryDistance<D>().measure(copy);
        // Attached nodes are those of the nearest faces now, which are at most as far away.
        QCOMPARE_LE(bounds_of(copy.compact().classes).largest, bounds.largest * (1 + 1e-6));
    }
    QVERIFY2(less, "never below what was summed");
}

} // namespace

class OriginalSurfaceTest : public QObject {
    Q_OBJECT
private slots:
    void what_is_measured_is_a_bound_and_below_the_sum() {
        measure_often<2>(polygon(96));
        measure_often<3>(ball_of(6));
    }

    void planes_do_not_move() {
        Workbench<3> bench(shapes::cube(4));
        std::mt19937 random(1);
        (void)collapse_boundary_nodes(bench, random, 200, loose);
        BoundaryDistance<3>().measure(bench.edit);
        QCOMPARE_LE(bounds_of(bench.edit.compact().classes).largest, 1e-15);
    }

    void the_number_of_threads_makes_no_difference() {
        std::array<IdVector<FaceId, double>, 2> made;
        for (std::size_t k = 0; k < 2; ++k) {
            set_thread_count(k == 0 ? 1 : 3);
            Workbench<3> bench(ball_of(8));
            std::mt19937 random(2);
            BoundaryDistance<3> distance;
            for (int pass = 0; pass < 2; ++pass) {
                (void)collapse_boundary_nodes(bench, random, 300, loose);
                distance.measure(bench.edit);
            }
            made[k] = bench.edit.compact().classes.deviation;
        }
        set_thread_count(0);
        QVERIFY(bounds_of(GeometryClasses<3>{{}, {}, made[0], {}, {}}).largest > 0);
        QCOMPARE(made[0].raw(), made[1].raw());
    }

    void nothing_is_changed_where_the_original_is_not_known() {
        Workbench<2> bench(polygon(48));
        GeometryClasses<2> classes = bench.classes;
        classes.original.reset();
        classes.deviation.assign(bench.mesh.faces.size(), 0.5);
        EditMesh<2> mesh(bench.mesh, classes);
        BoundaryDistance<2>().measure(mesh);
        QCOMPARE(mesh.compact().classes.deviation.raw(), classes.deviation.raw());
    }
};

QTEST_APPLESS_MAIN(OriginalSurfaceTest)
#include "original_surface_test.moc"
