// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/surface_columns.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/geometry/predicates.h"
#include "core/surface/surface_normals.h"
#include "tests/core/surface/surfaces.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace ameco;

namespace {

SurfaceLayerOptions options_with(double first_height, double growth, int layers) {
    SurfaceLayerOptions options;
    options.first_height = first_height;
    options.growth = growth;
    options.layers = layers;
    return options;
}

SurfaceColumns columns_of(const Mesh<3>& surface, const SurfaceLayerOptions& options) {
    return find_columns(surface, options, "body.stl", Monitor::silent());
}

Mesh<3> body(const QString& name) {
    return name == "sphere"  ? surfaces::sphere(5)
           : name == "torus" ? surfaces::torus(24, 12)
                             : surfaces::cube(3);
}

} // namespace

class SurfaceColumnsTest : public QObject {
    Q_OBJECT

    static void add_bodies() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"sphere", "torus", "cube"}) {
            QTest::newRow(name) << QString(name);
        }
    }

private slots:
    void distances_are_a_geometric_series() {
        const auto columns = columns_of(surfaces::sphere(4), options_with(1e-6, 1.3, 12));
        QCOMPARE(columns.distance.size(), std::size_t{13});
        QCOMPARE(columns.distance[0], 0.0);
        for (std::size_t k = 0; k < columns.distance.size(); ++k) {
            const double expected = 1e-6 * (std::pow(1.3, static_cast<double>(k)) - 1) / 0.3;
            QVERIFY(std::abs(columns.distance[k] - expected) <= 1e-12 * expected);
        }
    }

    void feet_are_the_nodes_to_the_bit_data() { add_bodies(); }
    void feet_are_the_nodes_to_the_bit() {
        QFETCH(QString, name);
        const Mesh<3> surface = body(name);
        const auto columns = columns_of(surface, options_with(1e-4, 1.2, 6));
        for (const NodeId v : surface.points.ids()) {
            QVERIFY(columns.point(surface, v, 0) == surface.points[v]);
            QVERIFY(columns.share[v] >= 0 && columns.share[v] <= 1);
            QCOMPARE(columns.collapsed(v), columns.share[v] == 0);
        }
    }

    /// A step leads as far from each face at the node as from the one it is steepest on, and no
    /// farther than twice that.
    void steps_lead_away_from_all_faces_data() { add_bodies(); }
    void steps_lead_away_from_all_faces() {
        QFETCH(QString, name);
        const Mesh<3> surface = body(name);
        const auto columns = columns_of(surface, options_with(1e-4, 1.2, 6));
        const auto normals = face_normals(surface);
        for (const FaceId f : surface.faces.ids()) {
            for (const NodeId v : surface.faces[f]) {
                QVERIFY(columns.step[v].dot(normals[f]) > 0);
                QVERIFY(columns.step[v].norm() >= 1 - 1e-12);
                QVERIFY(columns.step[v].norm() <= 2 + 1e-12);
            }
        }
    }

    /// The first tet that a prism is cut into, whatever its diagonals: a face and a node above it.
    void tets_on_every_layer_are_positive_data() { add_bodies(); }
    void tets_on_every_layer_are_positive() {
        QFETCH(QString, name);
        const Mesh<3> surface = body(name);
        const auto columns = columns_of(surface, options_with(1e-5, 1.4, 15));
        for (const FaceId f : surface.faces.ids()) {
            for (std::size_t k = 0; k + 1 < columns.distance.size(); ++k) {
                const auto at = [&](std::size_t i, std::size_t layer) {
                    return columns.point(surface, surface.faces[f][i], layer);
                };
                for (std::size_t i = 0; i < 3; ++i) {
                    if (!columns.collapsed(surface.faces[f][i])) {
                        QVERIFY(orientation(at(0, k), at(1, k), at(2, k), at(i, k + 1)) > 0);
                    }
                }
            }
        }
    }

    void ranks_are_an_order_that_depends_on_the_seed_only() {
        const Mesh<3> surface = surfaces::sphere(4);
        SurfaceLayerOptions options = options_with(1e-3, 1.2, 3);
        const auto ranks = column_ranks(surface, options);
        QCOMPARE(ranks.size(), surface.points.size());
        QCOMPARE((std::set<std::uint64_t>(ranks.begin(), ranks.end()).size()), ranks.size());
        QVERIFY(column_ranks(surface, options) == ranks);
        options.seed = 2;
        QVERIFY(column_ranks(surface, options) != ranks);
    }

    void threads_do_not_change_them() {
        const Mesh<3> surface = surfaces::torus(30, 16);
        const auto options = options_with(1e-4, 1.3, 10);
        set_thread_count(1);
        const auto one = columns_of(surface, options);
        set_thread_count(4);
        const auto four = columns_of(surface, options);
        set_thread_count(0);
        QVERIFY(one.share == four.share);
        QVERIFY(one.step == four.step);
    }
};

QTEST_APPLESS_MAIN(SurfaceColumnsTest)
#include "surface_columns_test.moc"
