// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/removal.h"

#include "core/cases/cube.h"
#include "core/cases/layer.h"
#include "core/coarsen/target_metric.h"
#include "core/metric/nodal_metric.h"
#include "core/remesh/front_order.h"

#include <QTest>

using namespace ameco;

namespace {

/// Everything a removal needs, made from a mesh as the coarsener does.
template <int D>
struct Setting {
    explicit Setting(const Mesh<D>& m)
        : mesh(m), natural(nodal_metric(m)), couplings(make_couplings(m)),
          front(front_order(m, natural, couplings.neighbours)),
          lines(find_lines(m, couplings, front.key)), lines_before(lines),
          target(target_metric(m, natural)), edited(m, classify_geometry(m)),
          directions(coarsened_directions(natural, target)),
          removed(couplings, interpolation_bounds<D>(couplings, directions, {})), state(lines) {
        sizes = make_size_field(target);
        for (const NodeId v : m.points.ids()) {
            natural_factor.push_back(length_factor(natural[v]));
            target_factor.push_back(length_factor(target[v]));
            short_size.push_back(static_cast<float>(natural[v].sizes[0]));
        }
        for (std::size_t i = 0; i < edited.slot_count(); ++i) {
            if (!edited.is_ghost(ElementId(i))) {
                edited.set_measure(ElementId(i), static_cast<float>(size_quality(
                                                     edited, sizes, edited.nodes(ElementId(i)))));
            }
        }
    }

    [[nodiscard]] RemovalInput<D> input() {
        return {front.order, couplings,  sizes,   natural_factor, target_factor,
                short_size,  directions, removed, notes};
    }

    const Mesh<D>& mesh;
    MetricField<D> natural;
    Couplings couplings;
    FrontOrder front;
    Lines lines;
    const Lines lines_before;
    const MetricField<D> target;
    SizeField<D> sizes;
    IdVector<NodeId, Mat<D>> natural_factor, target_factor;
    IdVector<NodeId, float> short_size;
    EditMesh<D> edited;
    EditNotes notes{edited};
    IdVector<NodeId, float> directions;
    RemovedNodes<D> removed;
    RemovalState state;
    VerdictCounts verdicts;
};

template <int D>
void odd_nodes_leave() {
    LayerOptions layer;
    layer.nx = layer.ny = 8;
    layer.nz = 12;
    const Mesh<D> mesh = make_layer<D>(layer);
    Setting<D> s(mesh);
    remove_first_pass(s.edited, s.lines, s.state, s.input(), {}, s.verdicts, Monitor::silent());
    QVERIFY(s.lines_before.node_count > 0);
    for (const NodeId v : mesh.points.ids()) {
        if (s.lines_before.on_line(v) && s.lines_before.next[v].valid()) {
            QCOMPARE(s.edited.is_removed(v), s.lines_before.position[v] % 2 == 1);
        }
    }
}

/// Largest share of a removed node's row that went to removed neighbours.
template <int D>
double largest_removed_share(const Setting<D>& s) {
    double largest = 0;
    for (const NodeId v : s.mesh.points.ids()) {
        if (!s.edited.is_removed(v)) {
            continue;
        }
        double sum = 0;
        const auto neighbours = s.couplings.neighbours[v];
        for (std::size_t i = 0; i < neighbours.size(); ++i) {
            if (s.edited.is_removed(neighbours[i])) {
                sum += static_cast<double>(s.couplings.at(v)[i]);
            }
        }
        largest = std::max(largest, sum / static_cast<double>(s.couplings.diagonal[v]));
    }
    return largest;
}

Mesh<3> isotropic_cube() {
    CubeOptions cube;
    cube.n = 10;
    return make_cube<3>(cube);
}

} // namespace

class RemovalTest : public QObject {
    Q_OBJECT
private slots:
    void first_pass_removes_exactly_the_odd_nodes_of_lines_in_3d() { odd_nodes_leave<3>(); }
    void first_pass_removes_exactly_the_odd_nodes_of_lines_in_2d() { odd_nodes_leave<2>(); }
    void no_gap_of_a_line_loses_two_nodes();
    void removed_nodes_keep_a_part_of_their_stencil();
    void later_passes_remove_more();
    void later_passes_leave_nodes_whose_neighbours_are_far_already();
    void every_refusal_is_counted();
    void corners_stay();
};

void RemovalTest::no_gap_of_a_line_loses_two_nodes() {
    LayerOptions layer;
    layer.growth = 1.25;
    layer.nx = layer.ny = 8;
    const Mesh<3> mesh = make_layer<3>(layer);
    Setting<3> s(mesh);
    remove_first_pass(s.edited, s.lines, s.state, s.input(), {}, s.verdicts, Monitor::silent());
    for (int pass = 0; pass < 3; ++pass) {
        remove_again(s.edited, s.lines, s.state, s.input(), {}, s.verdicts, Monitor::silent());
    }
    for (const NodeId v : mesh.points.ids()) {
        const NodeId after = s.lines_before.on_line(v) ? s.lines_before.next[v] : NodeId();
        if (after.valid()) {
            QVERIFY(!(s.edited.is_removed(v) && s.edited.is_removed(after)));
        }
    }
}

void RemovalTest::removed_nodes_keep_a_part_of_their_stencil() {
    const Mesh<3> mesh = isotropic_cube();
    Setting<3> s(mesh);
    RemovalOptions options;
    options.coupling_bound = 0.6;
    options.isotropic_coupling = 0;
    remove_first_pass(s.edited, s.lines, s.state, s.input(), options, s.verdicts,
                      Monitor::silent());
    remove_again(s.edited, s.lines, s.state, s.input(), options, s.verdicts, Monitor::silent());
    QVERIFY(s.verdicts[Verdict::accepted] > 100);
    QVERIFY(largest_removed_share(s) <= 0.6 + 1e-5);
    // The bound is what limits: without it more of some stencil is gone.
    Setting<3> free(mesh);
    options.coupling_bound = 2;
    remove_first_pass(free.edited, free.lines, free.state, free.input(), options, free.verdicts,
                      Monitor::silent());
    QVERIFY(largest_removed_share(free) > 0.6);
}

void RemovalTest::later_passes_remove_more() {
    const Mesh<3> mesh = isotropic_cube();
    Setting<3> s(mesh);
    remove_first_pass(s.edited, s.lines, s.state, s.input(), {}, s.verdicts, Monitor::silent());
    const std::int64_t first = s.verdicts[Verdict::accepted];
    remove_again(s.edited, s.lines, s.state, s.input(), {}, s.verdicts, Monitor::silent());
    QVERIFY(s.verdicts[Verdict::accepted] > first);
}

void RemovalTest::later_passes_leave_nodes_whose_neighbours_are_far_already() {
    const Mesh<3> mesh = isotropic_cube();
    std::int64_t removed[2];
    for (const bool any : {false, true}) {
        Setting<3> s(mesh);
        RemovalOptions options;
        options.crowded = any ? 1e9 : 0.8;
        options.crowded_layer = 0;
        remove_first_pass(s.edited, s.lines, s.state, s.input(), options, s.verdicts,
                          Monitor::silent());
        remove_again(s.edited, s.lines, s.state, s.input(), options, s.verdicts, Monitor::silent());
        removed[any ? 1 : 0] = s.verdicts[Verdict::accepted];
    }
    QVERIFY(removed[0] < removed[1]);
}

void RemovalTest::every_refusal_is_counted() {
    const Mesh<3> mesh = isotropic_cube();
    Setting<3> s(mesh);
    RemovalOptions options;
    options.quality.floor = 2; // nothing is that good
    options.quality.share = 3;
    remove_first_pass(s.edited, s.lines, s.state, s.input(), options, s.verdicts,
                      Monitor::silent());
    QCOMPARE(s.verdicts[Verdict::accepted], std::int64_t{0});
    QVERIFY(s.verdicts[Verdict::low_quality] > 0);
}

void RemovalTest::corners_stay() {
    const Mesh<3> mesh = isotropic_cube();
    Setting<3> s(mesh);
    remove_first_pass(s.edited, s.lines, s.state, s.input(), {}, s.verdicts, Monitor::silent());
    remove_again(s.edited, s.lines, s.state, s.input(), {}, s.verdicts, Monitor::silent());
    int corners = 0;
    for (const NodeId v : mesh.points.ids()) {
        if (s.edited.node_class(v) == NodeClass::frozen) {
            ++corners;
            QVERIFY(!s.edited.is_removed(v));
        }
    }
    QCOMPARE(corners, 8);
}

QTEST_APPLESS_MAIN(RemovalTest)
#include "removal_test.moc"
