// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/collapse_edges.h"
#include "core/adapt/edge_queue.h"
#include "core/adapt/move_nodes.h"
#include "core/adapt/mtc.h"
#include "core/adapt/split_edges.h"
#include "core/adapt/swap_edges.h"
#include "tests/core/remesh/audit.h"
#include "tests/core/remesh/random_domain.h"

#include <QTest>

#include <cmath>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

/// Sizes that are shares of the extent of a mesh along the axes, and grow along one of them.
template <int D>
class BoxMetric : public MetricSource<D> {
public:
    BoxMetric(const Mesh<D>& mesh, std::mt19937& random) {
        low_ = high_ = mesh.points[NodeId(0)];
        for (const Vec<D>& p : mesh.points) {
            low_ = low_.cwiseMin(p);
            high_ = high_.cwiseMax(p);
        }
        for (int k = 0; k < D; ++k) {
            share_[k] = 0.15 + 0.5 * static_cast<double>(random()) / 4294967296.0;
        }
        growth_ = random() % 3;
    }
    [[nodiscard]] Metric<D> at(const Vec<D>& p, NodeId& /*near*/) const override {
        const double along = (p[0] - low_[0]) / (high_[0] - low_[0]);
        const Vec<D> sizes = (1 + growth_ * along) * share_.cwiseProduct(high_ - low_);
        std::array<int, D> order;
        for (int k = 0; k < D; ++k) {
            order[static_cast<std::size_t>(k)] = k;
        }
        std::sort(order.begin(), order.end(), [&](int i, int j) { return sizes[i] < sizes[j]; });
        Metric<D> m;
        m.directions.setZero();
        for (int k = 0; k < D; ++k) {
            m.sizes[k] = sizes[order[static_cast<std::size_t>(k)]];
            m.directions(order[static_cast<std::size_t>(k)], k) = 1;
        }
        return m;
    }

private:
    Vec<D> low_, high_, share_;
    double growth_ = 0;
};

/// A mesh under adaptation, on which one operation is done at a time.
template <int D>
class Walk {
public:
    Walk(const RandomDomain<D>& domain, unsigned seed)
        : random_(seed), source_(domain.mesh, random_),
          unit_(domain.mesh, classify_geometry(domain.mesh, domain.features), source_,
                IdVector<NodeId, NodeId>(domain.mesh.points.size(), NodeId(0)),
                all_qualities[random_() % all_qualities.size()]) {}

    [[nodiscard]] const EditMesh<D>& edit() const { return unit_.edit; }

    static constexpr std::array operations{"collapse", "split",         "swap",
                                           "move",     "ball of MTC's", "shell of MTC's"};

    /// Tries an operation somewhere; whether it was done.
    bool try_one(std::size_t operation) {
        const NodeId v = any_node();
        switch (operation) {
        case 0:
            return collapse_shortest(v);
        case 1:
            return split_longest(v);
        case 2:
            return swap_worst(v);
        case 3:
            return move_node(unit_, v, {.below = 1, .gain = 1.0001, .curved = surface_}) ==
                   Verdict::accepted;
        case 4:
            return mend_ball(unit_, v, mtc_, surface_, verdicts_of_mtc_);
        default:
            return mend_shell(unit_, {v, any_neighbour(v)}, mtc_, surface_, verdicts_of_mtc_);
        }
    }

    /// Whether each element knows its own quality.
    [[nodiscard]] bool knows_qualities() const {
        for (std::size_t i = 0; i < edit().slot_count(); ++i) {
            const ElementId e(i);
            if (!edit().is_free(e) && !edit().is_ghost(e) &&
                edit().element(e).measure != static_cast<float>(unit_.quality(edit().nodes(e)))) {
                return false;
            }
        }
        return true;
    }

private:
    NodeId any_node() {
        for (;;) {
            const ElementId e(random_() % edit().slot_count());
            if (!edit().is_free(e) && !edit().is_ghost(e)) {
                return pick(edit().nodes(e), random_);
            }
        }
    }

    NodeId any_neighbour(NodeId v) {
        edit().neighbours(v, neighbours_);
        return pick(neighbours_, random_);
    }

    /// Makes `v` the only node that has changed, so that operators look there only.
    int look_at(NodeId v) {
        const int now = unit_.tick();
        unit_.touch(v);
        return now;
    }

    bool collapse_shortest(NodeId v) {
        const int since = look_at(v);
        const auto edges = edges_by_length<D>(unit_, since, all_lengths);
        const CollapseOptions options{.below = std::nextafter(edges.front().length, INFINITY),
                                      .longest = 1e9,
                                      .quality_share = 0.2,
                                      .quality_floor = 0.1};
        return collapse_short_edges(unit_, options, surface_, since, verdicts_) > 0;
    }

    bool split_longest(NodeId v) {
        const int since = look_at(v);
        const auto edges = edges_by_length<D>(unit_, since, all_lengths);
        const double above = std::nextafter(edges.back().length, 0.0);
        const SplitOptions options{.above = above,
                                   .shortest = 0.05,
                                   .much_above = above * 1.7,
                                   .shortest_among_long = 0.05,
                                   .quality_share = 0.1};
        return split_long_edges(unit_, options, since, verdicts_) > 0;
    }

    bool swap_worst(NodeId v) {
        float worst = 1;
        for (const ElementId e : edit().ball(v)) {
            worst = edit().is_ghost(e) ? worst : std::min(worst, edit().element(e).measure);
        }
        const SwapOptions options{
            .below = static_cast<double>(std::nextafter(worst, 2.0F)), .gain = 1.001, .rounds = 1};
        return swap_to_quality(unit_, options, surface_, look_at(v), verdicts_) > 0;
    }

    std::mt19937 random_;
    BoxMetric<D> source_;
    UnitMesh<D> unit_;
    SurfaceRules surface_;
    MtcOptions mtc_{.insert_above = 0.7};
    VerdictCounts verdicts_;
    MtcVerdicts verdicts_of_mtc_{verdicts_, verdicts_, verdicts_, verdicts_};
    std::vector<NodeId> neighbours_;
};

} // namespace

class OperationPropertyTest : public QObject {
    Q_OBJECT

    template <int D>
    static void walk(DomainKind kind, int seeds, int steps) {
        std::array<int, Walk<D>::operations.size()> made{};
        for (int seed = 1; seed <= seeds; ++seed) {
            const auto domain = random_domain<D>(kind, static_cast<unsigned>(seed));
            Walk<D> walk(domain, static_cast<unsigned>(seed));
            const Audit<D> audit(walk.edit(), domain.rounding);
            for (int i = 0; i < steps; ++i) {
                const std::size_t operation = static_cast<std::size_t>(i) % made.size();
                if (!walk.try_one(operation)) {
                    continue;
                }
                ++made[operation];
                const std::string complaint = audit.complaint(walk.edit());
                const std::string where = std::string(" after step ") + std::to_string(i) + ", " +
                                          Walk<D>::operations[operation] + ", seed " +
                                          std::to_string(seed);
                QVERIFY2(complaint.empty(), (complaint + where).c_str());
                QVERIFY2(walk.knows_qualities(), where.c_str());
            }
        }
        for (std::size_t k = 0; k < made.size(); ++k) {
            QVERIFY2(made[k] > seeds, Walk<D>::operations[k]);
        }
    }

private slots:
    void every_single_operation_leaves_a_whole_mesh_data() {
        QTest::addColumn<DomainKind>("kind");
        for (const DomainKind kind : all_domain_kinds) {
            QTest::newRow(name(kind)) << kind;
        }
    }
    void every_single_operation_leaves_a_whole_mesh() {
        QFETCH(DomainKind, kind);
        walk<2>(kind, 10, 180);
        walk<3>(kind, 8, 180);
    }
};

QTEST_APPLESS_MAIN(OperationPropertyTest)
#include "operation_property_test.moc"
