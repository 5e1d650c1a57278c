// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh/locate.h"

#include "core/cases/layer.h"
#include "core/cases/random.h"
#include "tests/support/shapes.h"

#include <QTest>

using namespace ameco;

namespace {

/// A point inside an element, by its barycentric coordinates; well off its facets.
template <int D>
Vec<D> inside(const Mesh<D>& mesh, ElementId e) {
    Vec<D> p = Vec<D>::Zero();
    double sum = 0;
    for (int i = 0; i <= D; ++i) {
        const double w = 1.5 + random_signed({e.index(), static_cast<std::uint64_t>(i)});
        p += w * mesh.points[mesh.elements[e][i]];
        sum += w;
    }
    return p / sum;
}

} // namespace

class LocateTest : public QObject {
    Q_OBJECT

    /// \param convex  a straight way to a point never leaves the domain: any start will do
    template <int D>
    static void find_all(const Mesh<D>& mesh, bool convex = true) {
        const Locator<D> locator(mesh);
        for (const ElementId e : mesh.elements.ids()) {
            const Vec<D> p = inside(mesh, e);
            const NodeId start =
                convex ? NodeId(mix({e.index()}) % mesh.points.size()) : mesh.elements[e][0];
            const auto found = locator.walk(p, start);
            QVERIFY(found.has_value());
            QCOMPARE(found->value(), e.value());
            QVERIFY(locator.contains(e, p));
        }
    }

private slots:
    void points_inside_elements_are_found_from_everywhere() {
        find_all(shapes::shuffled(shapes::square(8), 3));
        find_all(shapes::shuffled(shapes::cube(4), 4));
    }

    void layers_of_any_height_are_told_apart_data() {
        QTest::addColumn<double>("aspect");
        QTest::newRow("1e2") << 1e2;
        QTest::newRow("1e4") << 1e4;
        QTest::newRow("1e6") << 1e6;
    }
    void layers_of_any_height_are_told_apart() {
        QFETCH(double, aspect);
        LayerOptions layer;
        layer.nx = layer.ny = 5;
        layer.nz = 12;
        layer.aspect_ratio = aspect;
        find_all(make_layer<2>(layer));
        find_all(make_layer<3>(layer));
        layer.curvature = 1;
        find_all(make_layer<2>(layer), false);
        find_all(make_layer<3>(layer), false);
    }

    void nodes_belong_to_the_elements_around_them() {
        const Mesh<3> mesh = shapes::cube(3);
        const Locator<3> locator(mesh);
        for (const NodeId v : mesh.points.ids()) {
            const auto found = locator.walk(mesh.points[v], NodeId(0));
            QVERIFY(found.has_value());
            const Simplex<3>& s = mesh.elements[*found];
            QVERIFY(std::find(s.begin(), s.end(), v) != s.end());
            for (const ElementId e : mesh.elements.ids()) {
                const Simplex<3>& t = mesh.elements[e];
                QCOMPARE(locator.contains(e, mesh.points[v]),
                         std::find(t.begin(), t.end(), v) != t.end());
            }
        }
    }

    void points_outside_are_in_no_element() {
        const Mesh<2> mesh = shapes::square(5);
        const Locator<2> locator(mesh);
        for (const Vec<2>& p : {Vec<2>(-1e-15, 0.5), Vec<2>(0.5, 1.1), Vec<2>(7, -3)}) {
            for (const NodeId v : mesh.points.ids()) {
                QVERIFY(!locator.walk(p, v).has_value());
            }
        }
    }

    void balls_are_the_elements_at_the_nodes() {
        const Mesh<2> mesh = shapes::square(3);
        const Locator<2> locator(mesh);
        QCOMPARE(&locator.mesh(), &mesh);
        std::size_t uses = 0;
        for (const NodeId v : mesh.points.ids()) {
            uses += locator.balls()[v].size();
        }
        QCOMPARE(uses, 3 * mesh.elements.size());
    }
};

QTEST_APPLESS_MAIN(LocateTest)
#include "locate_test.moc"
