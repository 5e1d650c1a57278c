// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/mixed_mesh.h"
#include "core/mesh/boundary.h"
#include "core/mesh/check.h"
#include "tests/core/io/io_support.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

using namespace ameco;
using namespace ameco::test;
using namespace ameco::shapes;

class MixedMeshTest : public QObject {
    Q_OBJECT
private slots:
    void fills_each_cell_with_positive_tets_data();
    void fills_each_cell_with_positive_tets();
    void cuts_cells_of_all_kinds_so_that_they_fit_data();
    void cuts_cells_of_all_kinds_so_that_they_fit();
    void turns_a_kind_of_cells_that_is_numbered_the_other_way();
    void leaves_parts_of_degenerate_cells_out();
    void cuts_quadrilaterals_in_2d_where_they_allow_it();
    void takes_cells_in_a_plane_as_2d();
    void refuses_surfaces_unless_asked_for();
    void names_a_node_that_is_not_there();
};

namespace {

/// The reference cell of each kind, in the numbering of cell_type.h.
std::vector<Vec<3>> reference_points(CellType type) {
    switch (type) {
    case CellType::tetrahedron:
        return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    case CellType::pyramid:
        return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.5, 1}};
    case CellType::prism:
        return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    default:
        return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    }
}

double reference_volume(CellType type) {
    switch (type) {
    case CellType::tetrahedron:
        return 1.0 / 6;
    case CellType::pyramid:
        return 1.0 / 3;
    case CellType::prism:
        return 0.5;
    default:
        return 1;
    }
}

/// n x n x n cubes of the unit box, each one hexahedron, two prisms or six pyramids around its
/// middle, as chance will have it, with the quads of the box as patch 1 ... 6; nodes in random
/// order. Neighbours of pyramids and hexahedra meet in quads; prisms are cut along x-y diagonals,
/// so they stand in whole columns, and their triangles at the ends are listed as such.
MixedMesh<3> random_cells(int n, unsigned seed) {
    Random random(seed);
    MixedMesh<3> mixed;
    const int m = n + 1;
    std::vector<int> order(static_cast<std::size_t>(m * m * m + n * n * n));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size() - 1; i > 0; --i) {
        std::swap(order[i], order[static_cast<std::size_t>(random.below(static_cast<int>(i + 1)))]);
    }
    mixed.points.resize(order.size(), Vec<3>::Zero());
    const auto node = [&](int i, int j, int k) {
        const NodeId id(order[static_cast<std::size_t>(i + m * (j + m * k))]);
        mixed.points[id] = Vec<3>(i, j, k) / n;
        return id;
    };
    int centre = m * m * m;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const bool prisms = random.below(3) == 0;
            for (int k = 0; k < n; ++k) {
                const std::array<NodeId, 8> c{node(i, j, k),
                                              node(i + 1, j, k),
                                              node(i + 1, j + 1, k),
                                              node(i, j + 1, k),
                                              node(i, j, k + 1),
                                              node(i + 1, j, k + 1),
                                              node(i + 1, j + 1, k + 1),
                                              node(i, j + 1, k + 1)};
                const NodeId middle(order[static_cast<std::size_t>(centre++)]);
                mixed.points[middle] = (Vec<3>(i, j, k) + Vec<3>::Constant(0.5)) / n;
                if (prisms) {
                    mixed.prisms.add({c[0], c[1], c[2], c[4], c[5], c[6]}, 3);
                    mixed.prisms.add({c[0], c[2], c[3], c[4], c[6], c[7]}, 4);
                } else if (random.below(2) == 0) {
                    mixed.hexahedra.add(c, 5);
                } else {
                    for (const CellFace& f : faces_of(CellType::hexahedron)) {
                        const auto at = [&](int q) {
                            return c[static_cast<std::size_t>(f.node[static_cast<std::size_t>(q)])];
                        };
                        mixed.pyramids.add({at(0), at(3), at(2), at(1), middle}, 6);
                    }
                }
            }
        }
    }
    // Four of the box's sides; at low and high z, prisms show triangles.
    for (int a = 0; a < n; ++a) {
        for (int k = 0; k < n; ++k) {
            mixed.quadrilaterals.add(
                {node(0, a, k), node(0, a, k + 1), node(0, a + 1, k + 1), node(0, a + 1, k)}, 1);
            mixed.quadrilaterals.add(
                {node(n, a, k), node(n, a + 1, k), node(n, a + 1, k + 1), node(n, a, k + 1)}, 2);
            mixed.quadrilaterals.add(
                {node(a, 0, k), node(a + 1, 0, k), node(a + 1, 0, k + 1), node(a, 0, k + 1)}, 3);
            mixed.quadrilaterals.add(
                {node(a, n, k), node(a, n, k + 1), node(a + 1, n, k + 1), node(a + 1, n, k)}, 4);
        }
    }
    return mixed;
}

Mesh<3> finished(MixedMesh<3> mixed, MeshFile& file) {
    finish_mesh(std::move(mixed), {"a.mesh", 1, false}, file);
    return std::get<Mesh<3>>(file.mesh);
}

} // namespace

void MixedMeshTest::fills_each_cell_with_positive_tets_data() {
    QTest::addColumn<int>("type");
    for (const CellTypeInfo& entry : cell_types) {
        if (entry.dimension == 3) {
            QTest::newRow(std::string(entry.name).c_str()) << static_cast<int>(entry.type);
        }
    }
}

/// For every order of the nodes' numbers that matters: the smallest and second smallest anywhere.
void MixedMeshTest::fills_each_cell_with_positive_tets() {
    QFETCH(int, type);
    const auto kind = static_cast<CellType>(type);
    const std::vector<Vec<3>> x = reference_points(kind);
    std::vector<int> numbers(x.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    Random random(7);
    for (int trial = 0; trial < 500; ++trial) {
        for (std::size_t i = numbers.size() - 1; i > 0; --i) {
            std::swap(numbers[i],
                      numbers[static_cast<std::size_t>(random.below(static_cast<int>(i + 1)))]);
        }
        std::vector<NodeId> nodes;
        IdVector<NodeId, Vec<3>> points(x.size(), Vec<3>::Zero());
        for (std::size_t i = 0; i < x.size(); ++i) {
            nodes.emplace_back(numbers[i]);
            points[nodes[i]] = x[i];
        }
        std::vector<Simplex<3>> parts;
        split_cell(kind, nodes, parts);
        double volume = 0;
        for (const Simplex<3>& s : parts) {
            const Vec<3> a = points[s[1]] - points[s[0]];
            const Vec<3> b = points[s[2]] - points[s[0]];
            const Vec<3> c = points[s[3]] - points[s[0]];
            const double v = a.cross(b).dot(c) / 6;
            QVERIFY(v > 0);
            volume += v;
        }
        QVERIFY(std::abs(volume - reference_volume(kind)) < 1e-12);
    }
}

void MixedMeshTest::cuts_cells_of_all_kinds_so_that_they_fit_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 10; ++seed) {
        QTest::newRow(("box " + std::to_string(seed)).c_str()) << seed;
    }
}

/// The check finds every facet that two elements share in different ways. Faces of the boundary
/// must be facets of the elements, with the same diagonals.
void MixedMeshTest::cuts_cells_of_all_kinds_so_that_they_fit() {
    QFETCH(int, seed);
    MixedMesh<3> mixed = random_cells(3, static_cast<unsigned>(seed));
    const std::size_t quads = mixed.quadrilaterals.size();
    MeshFile file;
    Mesh<3> mesh = finished(std::move(mixed), file);
    QCOMPARE(mesh.faces.size(), 2 * quads);
    const BoundaryRepair repair = complete_boundary(mesh);
    QCOMPARE(repair.faces_added, std::int64_t{2 * 2 * 9}); // low and high z
    const CheckReport report = check(mesh);
    QVERIFY2(report.valid(), report.summary().c_str());
    QVERIFY(std::abs(report.volume - 1) < 1e-12);
    for (const FaceId f : mesh.faces.ids()) {
        if (mesh.patch[f] == 1) {
            for (const NodeId v : mesh.faces[f]) {
                QCOMPARE(mesh.points[v][0], 0.0);
            }
        }
    }
    QCOMPARE(file.changes.size(), 1U);
    QVERIFY(contains(file.changes[0], "were split into"));
    QVERIFY(contains(file.changes[0], "36 quadrilaterals into triangles") || quads != 36);
}

void MixedMeshTest::turns_a_kind_of_cells_that_is_numbered_the_other_way() {
    MixedMesh<3> mixed = random_cells(3, 3);
    for (auto& p : mixed.prisms.nodes) {
        p = {p[3], p[4], p[5], p[0], p[1], p[2]};
    }
    MeshFile file;
    Mesh<3> mesh = finished(std::move(mixed), file);
    complete_boundary(mesh);
    QVERIFY(check(mesh).valid());
}

void MixedMeshTest::leaves_parts_of_degenerate_cells_out() {
    MixedMesh<3> mixed;
    for (const Vec<3>& x : reference_points(CellType::prism)) {
        mixed.points.push_back(x);
    }
    // A prism as a hexahedron with an edge of no length.
    mixed.hexahedra.add(nodes(0, 1, 2, 2, 3, 4, 5, 5), 1);
    MeshFile file;
    const Mesh<3> mesh = finished(std::move(mixed), file);
    QCOMPARE(mesh.elements.size(), 3U);
}

void MixedMeshTest::cuts_quadrilaterals_in_2d_where_they_allow_it() {
    MixedMesh<2> mixed;
    // A square, and an arrow head that only its diagonal through the notch cuts well.
    mixed.points.raw() = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.2, 0.5}};
    mixed.quadrilaterals.add(nodes(1, 2, 3, 4), 2);
    mixed.triangles.add(nodes(0, 1, 4), 1);
    mixed.triangles.add(nodes(0, 4, 3), 1);
    mixed.lines.add(nodes(0, 1), 5);
    MeshFile file;
    finish_mesh(std::move(mixed), {"a.mesh", 1, false}, file);
    auto mesh = std::get<Mesh<2>>(file.mesh);
    QCOMPARE(mesh.elements.size(), 4U);
    QCOMPARE(mesh.patch[FaceId(0)], 5);
    complete_boundary(mesh);
    QVERIFY2(check(mesh).valid(), check(mesh).summary().c_str());
    QCOMPARE(file.changes[0], std::string("1 quadrilateral was split into 2 triangles"));
}

void MixedMeshTest::takes_cells_in_a_plane_as_2d() {
    MixedMesh<3> mixed;
    mixed.points.raw() = {{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}};
    mixed.quadrilaterals.add(nodes(0, 1, 2, 3), 2);
    mixed.lines.add(nodes(0, 1), 5);
    mixed.line_names[5] = "wall";
    mixed.face_names[2] = "fluid";
    MeshFile file;
    finish_mesh(std::move(mixed), {"a.mesh", 1, false}, file);
    const auto& mesh = std::get<Mesh<2>>(file.mesh);
    QCOMPARE(mesh.elements.size(), 2U);
    QVERIFY((mesh.patch_names == std::map<int, std::string>{{5, "wall"}}));
}

void MixedMeshTest::refuses_surfaces_unless_asked_for() {
    MixedMesh<3> mixed;
    mixed.points.raw() = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mixed.triangles.add(nodes(0, 1, 2), 1);
    mixed.triangles.add(nodes(0, 1, 3), 1);
    MeshFile file;
    QVERIFY(contains(message_of<InputError>([&] {
                         finish_mesh(MixedMesh<3>(mixed), {"a.mesh", 1, false}, file);
                     }),
                     "a.mesh: is a surface of 2 triangles"));
    finish_mesh(std::move(mixed), {"a.mesh", 1, true}, file);
    QCOMPARE(std::get<Mesh<3>>(file.mesh).faces.size(), 2U);
    QVERIFY(std::get<Mesh<3>>(file.mesh).elements.empty());
}

void MixedMeshTest::names_a_node_that_is_not_there() {
    MixedMesh<3> mixed;
    mixed.points.raw() = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mixed.tetrahedra.add(nodes(0, 1, 2, 4), 1);
    MeshFile file;
    QVERIFY(contains(message_of<InputError>([&] {
                         finish_mesh(std::move(mixed), {"a.su2", 0, false}, file);
                     }),
                     "a.su2: tetrahedron 0 uses node 4, but the file has 4 nodes"));
}

QTEST_APPLESS_MAIN(MixedMeshTest)
#include "mixed_mesh_test.moc"
