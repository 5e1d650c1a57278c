// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/partition.h"

#include "core/base/parallel.h"
#include "core/cases/layer.h"
#include "core/metric/nodal_metric.h"
#include "core/remesh/front_order.h"

#include <QTest>

using namespace ameco;

namespace {

/// A layer over a plate with what is asked about when it is cut.
template <int D>
struct Setting {
    explicit Setting(double growth = 1.2) {
        LayerOptions layer;
        layer.nx = 24;
        layer.ny = 12;
        layer.nz = 16;
        layer.aspect_ratio = 1e4;
        layer.growth = growth;
        mesh = make_layer<D>(layer);
        couplings = make_couplings(mesh);
        const auto front = front_order(mesh, nodal_metric(mesh), couplings.neighbours);
        lines = find_lines(mesh, couplings, front.key);
        everywhere.assign(mesh.points.size(), 1);
    }
    [[nodiscard]] Partition cut(std::size_t parts) const { return cut(parts, everywhere); }
    [[nodiscard]] Partition cut(std::size_t parts, const NodeMarks& counts) const {
        return cut_in_parts<D>(mesh.points, couplings.neighbours, lines, parts, counts);
    }

    Mesh<D> mesh;
    Couplings couplings;
    Lines lines;
    NodeMarks everywhere;
};

std::vector<std::size_t> sizes(const Partition& partition, const NodeMarks& counts) {
    std::vector<std::size_t> count(partition.parts, 0);
    for (const NodeId v : partition.part.ids()) {
        count[partition.part[v]] += counts[v];
    }
    return count;
}

std::size_t number(const NodeMarks& marks) {
    return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
}

} // namespace

class PartitionTest : public QObject {
    Q_OBJECT
private slots:
    void parts_have_equally_many_nodes_data();
    void parts_have_equally_many_nodes();
    void no_line_is_cut();
    void few_edges_are_cut();
    void a_second_partition_shares_out_the_borders_of_the_first();
    void threads_do_not_change_a_partition();
    void small_meshes_stay_whole_and_large_ones_get_a_power_of_two();
    void a_patch_holds_its_part_and_the_whole_mesh_holds_all();
};

void PartitionTest::parts_have_equally_many_nodes_data() {
    QTest::addColumn<int>("parts");
    for (const int parts : {1, 2, 4, 8}) {
        QTest::addRow("%d", parts) << parts;
    }
}

void PartitionTest::parts_have_equally_many_nodes() {
    QFETCH(int, parts);
    const Setting<3> s;
    const Partition partition = s.cut(static_cast<std::size_t>(parts));
    QCOMPARE(partition.part.size(), s.mesh.points.size());
    const auto count = sizes(partition, s.everywhere);
    QCOMPARE(count.size(), static_cast<std::size_t>(parts));
    for (const std::size_t n : count) {
        const double share =
            static_cast<double>(n * count.size()) / static_cast<double>(s.mesh.points.size());
        QVERIFY2(std::abs(share - 1) < 0.2, qPrintable(QString::number(share)));
    }
}

void PartitionTest::no_line_is_cut() {
    const auto whole = [](const auto& s) {
        const Partition partition = s.cut(8);
        QVERIFY(s.lines.node_count > 0);
        for (const NodeId v : s.mesh.points.ids()) {
            const NodeId next = s.lines.next[v];
            QVERIFY(!next.valid() || partition.part[next] == partition.part[v]);
        }
    };
    whole(Setting<2>());
    whole(Setting<3>());
}

/// The plate has 24 x 12 cells of equal width: one cut is across its longer side.
void PartitionTest::few_edges_are_cut() {
    const Setting<3> s(1);
    const Partition partition = s.cut(2);
    double lower = 0, upper = std::numeric_limits<double>::infinity();
    for (const NodeId v : s.mesh.points.ids()) {
        const double x = s.mesh.points[v][0];
        (partition.part[v] == 0 ? lower : upper) =
            partition.part[v] == 0 ? std::max(lower, x) : std::min(upper, x);
    }
    QVERIFY(lower <= upper);
    const NodeMarks border = border_nodes(s.couplings.neighbours, partition);
    QVERIFY(number(border) > 0);
    QVERIFY(number(border) <= std::size_t{6} * 13 * 17); // three layers of nodes on each side
}

void PartitionTest::a_second_partition_shares_out_the_borders_of_the_first() {
    const Setting<3> s;
    const NodeMarks border = border_nodes(s.couplings.neighbours, s.cut(2));
    const Partition second = s.cut(2, border);
    const auto count = sizes(second, border);
    QVERIFY(count[0] * 3 > number(border) && count[1] * 3 > number(border));
    // Little lies at the borders of both.
    const NodeMarks again = border_nodes(s.couplings.neighbours, second);
    std::size_t both = 0;
    for (const NodeId v : again.ids()) {
        both += border[v] & again[v];
    }
    QVERIFY(both * 2 < number(border));
}

void PartitionTest::threads_do_not_change_a_partition() {
    const Setting<3> s;
    set_thread_count(1);
    const Partition one = s.cut(8);
    for (const int threads : {2, 3, 8}) {
        set_thread_count(threads);
        QVERIFY(s.cut(8).part == one.part);
    }
    set_thread_count(0);
}

void PartitionTest::small_meshes_stay_whole_and_large_ones_get_a_power_of_two() {
    QCOMPARE(part_count(0, 1000), std::size_t{1});
    QCOMPARE(part_count(1999, 1000), std::size_t{1});
    QCOMPARE(part_count(2000, 1000), std::size_t{2});
    QCOMPARE(part_count(7999, 1000), std::size_t{4});
    QCOMPARE(part_count(8000, 1000), std::size_t{8});
    QCOMPARE(part_count(1000000000, 1000), std::size_t{64});
}

void PartitionTest::a_patch_holds_its_part_and_the_whole_mesh_holds_all() {
    const Partition partition{IdVector<NodeId, std::uint16_t>(std::vector<std::uint16_t>{0, 1, 1}),
                              2};
    const std::vector<NodeId> last{NodeId(1), NodeId(2)}, all{NodeId(0), NodeId(1), NodeId(2)};
    const Patch second(partition, 1);
    QVERIFY(second.holds(last) && !second.holds(all) && !second.is_whole());
    QCOMPARE(second.lane(), std::size_t{1});
    QVERIFY(Patch().holds(all) && Patch().is_whole());
}

QTEST_APPLESS_MAIN(PartitionTest)
#include "partition_test.moc"
