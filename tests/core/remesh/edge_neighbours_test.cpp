// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/edge_neighbours.h"

#include "core/cases/cube.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

#include <bit>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

/// Which of the corners of `s` an element has, as bits.
template <int D>
unsigned shared_corners(const Simplex<D>& s, const Simplex<D>& other) {
    unsigned shared = 0;
    for (int i = 0; i <= D; ++i) {
        shared |= std::count(other.begin(), other.end(), s[i]) > 0 ? 1U << i : 0U;
    }
    return shared;
}

template <int D>
void compare_with_all_elements() {
    const Workbench<D> bench(make_cube<D>({.n = 3}));
    const EditMesh<D>& mesh = bench.edit;
    EdgeNeighbours<D> around;
    int behind_ghosts = 0;
    for (std::size_t k = 0; k < mesh.slot_count(); ++k) {
        const ElementId e(k);
        if (mesh.is_ghost(e)) {
            continue;
        }
        around.find(mesh, e);
        const Simplex<D>& s = mesh.nodes(e);
        for (int i = 0; i <= D; ++i) {
            std::vector<std::pair<ElementId, unsigned>> expected, found;
            for (const ElementId f : mesh.ball(s[i])) {
                const unsigned shared = shared_corners<D>(s, mesh.nodes(f));
                if (std::popcount(shared) >= 2) {
                    expected.emplace_back(f, shared);
                }
                if (std::popcount(shared) == D && (shared & (1U << (i == 0 ? 1 : 0))) == 0) {
                    QCOMPARE(around.behind(i == 0 ? 1 : 0), f);
                }
            }
            for (const auto& n : around.at(i)) {
                found.emplace_back(n.element, n.shared);
            }
            QCOMPARE(found, expected);
            QVERIFY(around.behind(i).valid()); // ghosts close the mesh
            behind_ghosts += mesh.is_ghost(around.behind(i));
            for (int j = 0; j <= D; ++j) {
                const int end = around.quicker_end(i, j);
                QCOMPARE(mesh.ball(s[end]).size(),
                         std::min(mesh.ball(s[i]).size(), mesh.ball(s[j]).size()));
            }
        }
    }
    QVERIFY(behind_ghosts > 0);
}

} // namespace

class EdgeNeighboursTest : public QObject {
    Q_OBJECT
private slots:
    void are_the_elements_with_two_nodes_in_common() {
        compare_with_all_elements<2>();
        compare_with_all_elements<3>();
    }
};

QTEST_APPLESS_MAIN(EdgeNeighboursTest)
#include "edge_neighbours_test.moc"
