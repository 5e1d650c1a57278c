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

/// What is found at an element, compared with its corners' balls.
/// \param corners   that are wanted, as bits
/// \param is_worse  of elements
template <int D, class Worse>
void compare_at(const EditMesh<D>& mesh, ElementId e, const EdgeNeighbours<D>& around,
                unsigned corners, const Worse& is_worse) {
    const Simplex<D>& s = mesh.nodes(e);
    for (int i = 0; i <= D; ++i) {
        std::vector<std::pair<ElementId, unsigned>> expected, found;
        ElementId behind_other;
        const int other = i == 0 ? 1 : 0;
        for (const ElementId f : mesh.ball(s[i])) {
            const unsigned shared = shared_corners<D>(s, mesh.nodes(f));
            if (std::popcount(shared) >= 2) {
                expected.emplace_back(f, shared);
            }
            if (std::popcount(shared) == D && (shared >> other & 1U) == 0) {
                behind_other = f;
            }
        }
        QVERIFY(behind_other.valid()); // ghosts close the mesh
        const auto unwanted = static_cast<unsigned>(~corners & ((1U << (D + 1)) - 1));
        QCOMPARE(around.has_facet(other), (unwanted & ~(1U << other)) == 0);
        if (around.has_facet(other)) {
            QCOMPARE(around.behind(other), behind_other);
        }
        for (const auto& n : around.at(i)) {
            found.emplace_back(n.element, n.shared);
        }
        QVERIFY(found.empty() || found == expected);
        for (int j = 0; j <= D; ++j) {
            if (j == i) {
                continue;
            }
            const bool worse = std::any_of(expected.begin(), expected.end(), [&](const auto& n) {
                return (n.second >> j & 1U) != 0 && is_worse(n.first);
            });
            const bool wanted = (corners >> i & corners >> j & 1U) != 0;
            QCOMPARE(around.is_open(i, j), wanted && !worse);
            if (around.is_open(i, j)) {
                const int end = around.quicker_end(i, j);
                QVERIFY(!around.at(end).empty());
                QCOMPARE(mesh.ball(s[end]).size(),
                         std::min(mesh.ball(s[i]).size(), mesh.ball(s[j]).size()));
            }
        }
    }
}

/// \param one_in  so many elements are worse than the one looked at
template <int D>
void compare_with_all_elements(std::size_t one_in) {
    const Workbench<D> bench(make_cube<D>({.n = 3}));
    const EditMesh<D>& mesh = bench.edit;
    EdgeNeighbours<D> around;
    for (std::size_t k = 0; k < mesh.slot_count(); ++k) {
        const ElementId e(k);
        if (mesh.is_ghost(e)) {
            continue;
        }
        const auto is_worse = [&](ElementId f) {
            return one_in > 0 && f != e && f.index() * 7919 % one_in == 0;
        };
        for (unsigned corners = 1; corners < 1U << (D + 1); ++corners) {
            if (std::popcount(corners) >= 2) {
                around.find(mesh, e, corners, is_worse);
                compare_at(mesh, e, around, corners, is_worse);
            }
        }
    }
}

} // namespace

class EdgeNeighboursTest : public QObject {
    Q_OBJECT
private slots:
    void are_the_elements_with_two_nodes_in_common() {
        compare_with_all_elements<2>(0);
        compare_with_all_elements<3>(0);
    }
    void close_the_edges_where_one_of_them_is_worse() {
        for (const std::size_t one_in : {2, 5, 20}) {
            compare_with_all_elements<2>(one_in);
            compare_with_all_elements<3>(one_in);
        }
    }
};

QTEST_APPLESS_MAIN(EdgeNeighboursTest)
#include "edge_neighbours_test.moc"
