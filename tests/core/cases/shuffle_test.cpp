// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/shuffle.h"

#include "core/cases/layer.h"
#include "core/mesh/check.h"
#include "core/mesh/simplex.h"
#include "tests/core/cases/patches.h"

#include <QtTest>

using namespace ameco;

namespace {

/// The mesh as a set of its elements' corner coordinates, whatever the numbering.
template <int D>
std::multiset<std::vector<double>> as_set(const Mesh<D>& mesh) {
    std::multiset<std::vector<double>> all;
    for (const Simplex<D>& s : mesh.elements) {
        std::vector<std::vector<double>> corners;
        for (const Vec<D>& p : corners_of(mesh, s)) {
            corners.emplace_back(p.begin(), p.end());
        }
        std::sort(corners.begin(), corners.end());
        std::vector<double> flat;
        for (const auto& c : corners) {
            flat.insert(flat.end(), c.begin(), c.end());
        }
        all.insert(flat);
    }
    return all;
}

LayerOptions small_layer() {
    LayerOptions o;
    o.nx = o.ny = 4;
    o.nz = 5;
    return o;
}

} // namespace

class ShuffleTest : public QObject {
    Q_OBJECT
private slots:
    void keeps_the_mesh_and_its_validity_data();
    void keeps_the_mesh_and_its_validity();
    void leaves_no_trace_of_the_old_order();
    void is_the_same_for_the_same_seed();
};

void ShuffleTest::keeps_the_mesh_and_its_validity_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed < 6; ++seed) {
        QTest::addRow("seed %d", seed) << seed;
    }
}

void ShuffleTest::keeps_the_mesh_and_its_validity() {
    QFETCH(int, seed);
    const Mesh<3> ordered = make_layer<3>(small_layer());
    Mesh<3> mesh = ordered;
    shuffle(mesh, static_cast<std::uint64_t>(seed));
    QVERIFY2(check(mesh).valid(), check(mesh).summary().c_str());
    QVERIFY(as_set(mesh) == as_set(ordered));
    for (const auto& [name, normal] : patch_normals(ordered)) {
        QVERIFY(patch_normals(mesh).at(name).isApprox(normal));
    }
    const Mesh<2> flat = make_layer<2>(small_layer());
    Mesh<2> shuffled = flat;
    shuffle(shuffled, static_cast<std::uint64_t>(seed));
    QVERIFY2(check(shuffled).valid(), check(shuffled).summary().c_str());
    QVERIFY(as_set(shuffled) == as_set(flat));
}

void ShuffleTest::leaves_no_trace_of_the_old_order() {
    const Mesh<3> ordered = make_layer<3>(small_layer());
    Mesh<3> mesh = ordered;
    shuffle(mesh, 1);
    int unmoved = 0;
    for (const NodeId v : mesh.points.ids()) {
        unmoved += mesh.points[v] == ordered.points[v];
    }
    QVERIFY(unmoved < 5); // one is expected of a random order
}

void ShuffleTest::is_the_same_for_the_same_seed() {
    Mesh<3> a = make_layer<3>(small_layer()), b = a, c = a;
    shuffle(a, 1);
    shuffle(b, 1);
    shuffle(c, 2);
    QVERIFY(a == b);
    QVERIFY(!(a == c));
}

QTEST_APPLESS_MAIN(ShuffleTest)
#include "shuffle_test.moc"
