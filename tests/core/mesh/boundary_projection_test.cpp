// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/boundary_projection.h"

#include "core/cases/random.h"
#include "core/geometry/distance.h"
#include "tests/core/remesh/remesh_support.h"
#include "tests/support/shapes.h"

#include <QTest>

#include <cmath>

using namespace ameco;

namespace {

template <int D>
Vec<D> random_point(std::uint64_t i, double scale) {
    Vec<D> p;
    for (int k = 0; k < D; ++k) {
        p[k] = 0.5 + scale * random_signed({i, static_cast<std::uint64_t>(k)});
    }
    return p;
}

template <int D>
std::array<Vec<D>, D> corners(const Mesh<D>& mesh, const Facet<D>& f) {
    std::array<Vec<D>, D> x;
    for (std::size_t i = 0; i < D; ++i) {
        x[i] = mesh.points[f[i]];
    }
    return x;
}

template <int D>
Vec<D> place(const Mesh<D>& mesh, const BoundaryPoint<D>& point) {
    Vec<D> p = Vec<D>::Zero();
    for (std::size_t i = 0; i < D; ++i) {
        p += point.weights[i] * mesh.points[point.nodes[i]];
    }
    return p;
}

template <int D>
void verify_weights(const BoundaryPoint<D>& point) {
    double sum = 0;
    for (const double w : point.weights) {
        QVERIFY(w >= 0 && w <= 1);
        sum += w;
    }
    QVERIFY(std::abs(sum - 1) < 1e-14);
}

} // namespace

class BoundaryProjectionTest : public QObject {
    Q_OBJECT

    /// The distance is the least of all faces wanted, and that to the place the weights give.
    template <int D>
    static void compare_with_all_faces(const Mesh<D>& mesh) {
        const BoundaryProjection<D> projection(mesh);
        std::array<std::int32_t, 2 * D + 1> near; // kept from point to point
        near.fill(-1);
        for (std::uint64_t i = 0; i < 100; ++i) {
            const Vec<D> p = random_point<D>(i, i % 2 == 0 ? 0.5 : 2.0);
            for (int patch = 0; patch <= 2 * D; ++patch) {
                const BoundaryPoint<D> found =
                    patch == 0 ? projection.project(p) : projection.project(p, {patch});
                double least = INFINITY;
                for (const FaceId f : mesh.faces.ids()) {
                    if (patch == 0 || mesh.patch[f] == patch) {
                        least = std::min(least, distance(p, corners<D>(mesh, mesh.faces[f])));
                    }
                }
                QVERIFY(std::abs(found.distance - least) < 1e-13);
                QVERIFY(std::abs((place(mesh, found) - p).norm() - found.distance) < 1e-13);
                verify_weights(found);
                if (patch > 0) {
                    QCOMPARE(projection.distance(p, patch, near[static_cast<std::size_t>(patch)]),
                             found.distance);
                }
            }
        }
    }

private slots:
    void the_nearest_point_is_that_of_brute_force() {
        compare_with_all_faces(shapes::square(5));
        compare_with_all_faces(shapes::cube(3));
        compare_with_all_faces(shapes::stretched_slab(3, 3, 1e-6));
    }

    void places_between_patches_are_edges_and_corners() {
        const Mesh<3> mesh = shapes::cube(3);
        const BoundaryProjection<3> projection(mesh);
        const Vec<3> p(0.3, 0.4, 0.45);
        // Patches 1 and 3 are the sides x = 0 and y = 0.
        const auto edge = projection.project(p, {1, 3});
        QVERIFY((place(mesh, edge) - Vec<3>(0, 0, 0.45)).norm() < 1e-15);
        verify_weights(edge);
        QVERIFY(std::abs(edge.distance - 0.5) < 1e-15);
        const auto corner = projection.project(Vec<3>(0, 0, 0), {1, 3, 5});
        QVERIFY(place(mesh, corner) == Vec<3>(0, 0, 0));

        const Mesh<2> square = shapes::square(4);
        const auto end = BoundaryProjection<2>(square).project({0.3, 0.4}, {2, 4});
        QVERIFY((place(square, end) - Vec<2>(1, 1)).norm() < 1e-15);
    }

    void ridges_inside_a_patch_are_lines_too() {
        Mesh<3> mesh = shapes::cube(2);
        for (int& patch : mesh.patch) {
            patch = patch <= 2 ? 1 : patch; // the sides x = 0 and x = 1, which do not meet
        }
        std::vector<Edge> ridges;
        const auto is_middle = [&](NodeId v) { return mesh.points[v][1] == 0.5; };
        for (const Facet<3>& f : mesh.faces) {
            for (std::size_t i = 0; i < 3; ++i) {
                const NodeId a = f[i], b = f[(i + 1) % 3];
                if (is_middle(a) && is_middle(b) && a < b) {
                    ridges.push_back({a, b}); // also of sides z = 0 and z = 1
                }
            }
        }
        const NodeId inside(13);
        QVERIFY(mesh.points[inside] == Vec<3>::Constant(0.5));
        ridges.push_back(sorted(Edge{inside, ridges.front()[0]})); // of no face
        const BoundaryProjection<3> projection(mesh, outer_faces(mesh), ridges);
        const Vec<3> p(0.45, 0.3, 0.2);
        const auto line = projection.project_on_line(p, {1});
        QVERIFY((place(mesh, line) - Vec<3>(0, 0.5, 0.2)).norm() < 1e-15);
        verify_weights(line);
        QVERIFY(!projection.project_on_line(p, {3}).nodes[0].valid());
        QVERIFY((place(mesh, projection.project_on_line(p, {1, 3})) - Vec<3>(0, 0, 0.2)).norm() <
                1e-15);
        QVERIFY(projection.project(p, {1}).distance < line.distance); // patches are faces
    }

    void patches_that_do_not_meet_give_the_first_one_and_unknown_ones_any() {
        const Mesh<3> mesh = shapes::cube(2);
        const BoundaryProjection<3> projection(mesh);
        const Vec<3> p(0.4, 0.1, 0.6);
        QVERIFY((place(mesh, projection.project(p, {1, 2})) - Vec<3>(0, 0.1, 0.6)).norm() < 1e-15);
        QVERIFY((place(mesh, projection.project(p, {77})) - Vec<3>(0.4, 0, 0.6)).norm() < 1e-15);
    }

    void faces_inside_the_domain_do_not_bound_it() {
        Mesh<3> mesh = shapes::cube(2);
        const std::size_t outer = mesh.faces.size();
        remesh_test::split_regions(mesh, 0.5);
        QVERIFY(mesh.faces.size() > outer);
        QCOMPARE(outer_faces(mesh).size(), outer);
        QVERIFY(std::abs(BoundaryProjection<3>(mesh).project(Vec<3>(0.5, 0.5, 0.4)).distance -
                         0.4) < 1e-15);
    }

    void nodes_know_the_patches_around_them() {
        const Mesh<3> mesh = shapes::cube(2);
        const auto patches = node_patches(mesh);
        for (const NodeId v : mesh.points.ids()) {
            std::vector<int> expected;
            for (int k = 0; k < 3; ++k) {
                if (mesh.points[v][k] == 0) {
                    expected.push_back(2 * k + 1);
                } else if (mesh.points[v][k] == 1) {
                    expected.push_back(2 * k + 2);
                }
            }
            QVERIFY(patches[v] == expected);
        }
    }

    void weights_are_right_on_needles() {
        for (const double h : {1.0, 1e-3, 1e-6}) {
            const std::array<Vec<3>, 3> face{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0, h, 0)};
            const auto [w, d] = nearest_on_face(face, Vec<3>(0.25, 0.25 * h, 0.5));
            QVERIFY(std::abs(w[0] - 0.5) < 1e-9 && std::abs(w[1] - 0.25) < 1e-9);
            QVERIFY(std::abs(d - 0.5) < 1e-15);
        }
    }
};

QTEST_APPLESS_MAIN(BoundaryProjectionTest)
#include "boundary_projection_test.moc"
