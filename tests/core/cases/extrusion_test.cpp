// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/extrusion.h"

#include "core/cases/grid_wall.h"
#include "core/mesh/check.h"
#include "core/mesh/simplex.h"
#include "tests/core/cases/patches.h"

#include <QtTest>

using namespace ameco;

namespace {

/// One triangle or edge with two layers over it.
template <int D>
Mesh<D> single_prism(const ColumnRank& rank) {
    Wall<D> wall;
    std::vector<Vec<D>> points;
    if constexpr (D == 3) {
        wall = {3, {{0, 1, 2}}, {{0, 0, 3}, {0, 1, 4}, {0, 2, 5}}};
        for (const double z : {0.0, 1.0, 2.0}) {
            points.insert(points.end(), {{0, 0, z}, {1, 0, z}, {0, 1, z}});
        }
    } else {
        wall = {2, {{0, 1}}, {{0, 0, 3}, {0, 1, 4}}};
        for (const double z : {0.0, 1.0, 2.0}) {
            points.insert(points.end(), {{0, z}, {1, z}});
        }
    }
    return extrude(wall, points, rank, 1, 2);
}

bool has_edge(const Mesh<2>& mesh, std::size_t a, std::size_t b) {
    for (const Simplex<2>& s : mesh.elements) {
        if (std::count(s.begin(), s.end(), NodeId(a)) &&
            std::count(s.begin(), s.end(), NodeId(b))) {
            return true;
        }
    }
    return false;
}

} // namespace

class ExtrusionTest : public QObject {
    Q_OBJECT
private slots:
    void splits_a_prism_for_every_order_of_its_columns();
    void leads_diagonals_from_the_foot_of_the_lower_rank();
    void gives_each_side_its_patch_and_outward_faces();
    void alternates_diagonals_as_a_union_jack();
    void varies_random_diagonals_from_layer_to_layer_only_when_asked();
    void keeps_the_wall_and_the_last_layer();
};

void ExtrusionTest::splits_a_prism_for_every_order_of_its_columns() {
    std::vector<std::uint64_t> order{0, 1, 2};
    do {
        const ColumnRank rank = [order](std::size_t c, std::size_t) { return order[c]; };
        const Mesh<3> prism = single_prism<3>(rank);
        QCOMPARE(prism.elements.size(), 6u);
        const CheckReport report = check(prism);
        QVERIFY2(report.valid(), report.summary().c_str());
        QCOMPARE(report.volume, 1.0);
        const CheckReport flat = check(single_prism<2>(rank));
        QVERIFY2(flat.valid(), flat.summary().c_str());
        QCOMPARE(flat.volume, 2.0);
    } while (std::next_permutation(order.begin(), order.end()));
}

void ExtrusionTest::leads_diagonals_from_the_foot_of_the_lower_rank() {
    const Mesh<2> rising = single_prism<2>([](std::size_t c, std::size_t) { return c; });
    QVERIFY(has_edge(rising, 0, 3) && !has_edge(rising, 1, 2));
    const Mesh<2> falling = single_prism<2>([](std::size_t c, std::size_t) { return 1 - c; });
    QVERIFY(has_edge(falling, 1, 2) && !has_edge(falling, 0, 3));
    const Mesh<2> tied = single_prism<2>([](std::size_t, std::size_t) { return 5; });
    QVERIFY(has_edge(tied, 0, 3));
}

void ExtrusionTest::gives_each_side_its_patch_and_outward_faces() {
    Mesh<3> prism = single_prism<3>(column_rank(Diagonals::random, 3));
    prism.patch_names = {{1, "wall"}, {2, "top"}, {3, "slant"}, {4, "x"}, {5, "y"}};
    const auto normals = patch_normals(prism);
    QVERIFY(normals.at("wall").isApprox(Vec<3>(0, 0, -0.5)));
    QVERIFY(normals.at("top").isApprox(Vec<3>(0, 0, 0.5)));
    QVERIFY(normals.at("slant").isApprox(Vec<3>(2, 2, 0)));
    QVERIFY(normals.at("x").isApprox(Vec<3>(-2, 0, 0)));
    QVERIFY(normals.at("y").isApprox(Vec<3>(0, -2, 0)));
}

void ExtrusionTest::alternates_diagonals_as_a_union_jack() {
    const auto grid = grid_wall<2>(2, 0, Diagonals::alternating, 1);
    std::vector<Vec<2>> points;
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
            points.emplace_back(i, k);
        }
    }
    const Mesh<2> mesh =
        extrude(grid.wall, points, grid_rank(grid, Diagonals::alternating, 1), 1, 2);
    for (const std::size_t corner : {0u, 2u, 6u, 8u}) {
        QVERIFY(has_edge(mesh, 4, corner)); // all four diagonals meet in the middle
    }
}

void ExtrusionTest::varies_random_diagonals_from_layer_to_layer_only_when_asked() {
    const ColumnRank columns = column_rank(Diagonals::columns, 1);
    const ColumnRank random = column_rank(Diagonals::random, 1);
    int differ = 0;
    for (std::size_t layer = 1; layer < 20; ++layer) {
        QCOMPARE(columns(0, layer) < columns(1, layer), columns(0, 0) < columns(1, 0));
        differ += (random(0, layer) < random(1, layer)) != (random(0, 0) < random(1, 0));
    }
    QVERIFY(differ > 0);
}

void ExtrusionTest::keeps_the_wall_and_the_last_layer() {
    using Layers = std::vector<std::size_t>;
    QCOMPARE(kept_layers(4, 1), (Layers{0, 1, 2, 3, 4}));
    QCOMPARE(kept_layers(4, 2), (Layers{0, 2, 4}));
    QCOMPARE(kept_layers(5, 2), (Layers{0, 2, 4, 5}));
    QCOMPARE(kept_layers(2, 7), (Layers{0, 2}));
}

QTEST_APPLESS_MAIN(ExtrusionTest)
#include "extrusion_test.moc"
