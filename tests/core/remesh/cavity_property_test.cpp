// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/cavity.h"

#include "core/cases/random.h"
#include "core/remesh/collapse.h"
#include "core/remesh/swap.h"
#include "tests/core/remesh/audit.h"
#include "tests/core/remesh/random_domain.h"
#include "tests/core/remesh/remesh_support.h"

#include <QTest>

using namespace ameco;
using namespace ameco::remesh_test;

namespace {

/// An element of the mesh under edit, no ghost.
template <int D>
ElementId any_element(const EditMesh<D>& mesh, std::mt19937& random) {
    for (;;) {
        const ElementId e(random() % mesh.slot_count());
        if (!mesh.is_free(e) && !mesh.is_ghost(e)) {
            return e;
        }
    }
}

template <int D>
NodeId any_node(const EditMesh<D>& mesh, std::mt19937& random) {
    return pick(mesh.nodes(any_element(mesh, random)), random);
}

/// A ball, a shell or a pair, at the boundary or not.
template <int D>
void gather_any(const EditMesh<D>& mesh, std::mt19937& random, Cavity<D>& cavity) {
    const ElementId e = any_element(mesh, random);
    Simplex<D> s = mesh.nodes(e);
    std::shuffle(s.begin(), s.end(), random);
    if (random() % 3 == 0) {
        gather_ball(mesh, s[0], cavity);
        return;
    }
    gather_shell(mesh, s[0], s[1], cavity);
    if (random() % 2 == 0) {
        for (const ElementId f : mesh.ball(s[0])) {
            const auto common = std::count_if(s.begin(), s.end(), [&](NodeId v) {
                const Simplex<D>& t = mesh.nodes(f);
                return std::find(t.begin(), t.end(), v) != t.end();
            });
            if (common == D && !mesh.is_ghost(f)) {
                gather_pair(mesh, e, f, cavity);
                return;
            }
        }
    }
}

/// Whether the facets around a cavity close it: each of their own sides is shared by two, which run
/// through it in opposite directions.
template <int D>
bool is_closed(const Cavity<D>& cavity) {
    std::map<std::array<NodeId, D - 1>, int> sides;
    for (const Facet<D>& f : cavity.facets) {
        for (int i = 0; i < D; ++i) {
            std::array<NodeId, D - 1> side;
            for (int k = 1; k < D; ++k) {
                side[k - 1] = f[(i + k) % D];
            }
            // In 2-D a side is one node, from which one facet starts and at which another ends.
            const int sign = D == 2 ? (i == 0 ? 1 : -1) : (side[0] < side[D - 2] ? 1 : -1);
            sides[sorted(side)] += sign;
        }
    }
    return std::all_of(sides.begin(), sides.end(), [](const auto& s) { return s.second == 0; });
}

/// Rules under which any swap is as good as chance has it: what is left are those that keep a mesh
/// whole.
template <int D>
class RandomRules {
public:
    RandomRules(EditMesh<D>& mesh, std::uint64_t seed) : mesh_(mesh), seed_(seed) {}
    double quality(ElementId /*e*/) const { return 1e-3; }
    double quality(const Simplex<D>& s, double /*least*/) const {
        std::uint64_t h = seed_;
        for (const NodeId v : sorted(s)) {
            h = mix({h, v.index()});
        }
        return 0.5 + 0.4 * random_signed({h});
    }
    double short_size(NodeId /*v*/) const { return 1; }
    void look_at(const Cavity<D>& /*cavity*/) {}
    Verdict judge(const Cavity<D>& /*cavity*/, const Star<D>& /*star*/) {
        return Verdict::accepted;
    }
    void make(const Cavity<D>& cavity, const Star<D>& star) {
        (void)mesh_.replace(cavity.elements, star.elements, star.sources);
    }

private:
    EditMesh<D>& mesh_;
    std::uint64_t seed_;
};

/// Collapses a random node along the first of its edges, in random order, that allows it; any
/// positive quality will do.
template <int D>
bool collapse_any(Workbench<D>& bench, std::mt19937& random) {
    const NodeId v = any_node(bench.edit, random);
    Cavity<D> ball;
    Star<D> star;
    gather_ball(bench.edit, v, ball);
    std::vector<NodeId> onto = neighbours(bench.edit, v);
    std::shuffle(onto.begin(), onto.end(), random);
    for (const NodeId w : onto) {
        const Collapse collapse{.removed = v, .kept = w};
        if (propose_collapse(bench.edit, bench.sizes, {}, {.floor = 0, .share = 0}, 1, collapse,
                             ball, star) == Verdict::accepted) {
            (void)apply_collapse(bench.edit, collapse, ball, star);
            return true;
        }
    }
    return false;
}

template <int D>
bool swap_any(Workbench<D>& bench, std::mt19937& random) {
    RandomRules<D> rules(bench.edit, random());
    const SwapOptions options{.largest_shell = 12};
    const SurfaceRules surface;
    VerdictCounts verdicts;
    SwapSearch<D, RandomRules<D>> search(bench.edit, rules, options, surface, verdicts);
    const ElementId e = any_element(bench.edit, random);
    EdgeNeighbours<D> around;
    around.find(bench.edit, e, ~0U, [&](ElementId f) {
        return !bench.edit.is_ghost(f) && rules.quality(f) < rules.quality(e);
    });
    return search.mend(e, around);
}

} // namespace

class CavityPropertyTest : public QObject {
    Q_OBJECT

    static void add_kinds() {
        QTest::addColumn<DomainKind>("kind");
        for (const DomainKind kind : all_domain_kinds) {
            QTest::newRow(name(kind)) << kind;
        }
    }

    template <int D>
    static void check_stars(DomainKind kind, int seeds) {
        int accepted = 0, refused = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            const auto domain = random_domain<D>(kind, static_cast<unsigned>(seed));
            const EditMesh<D> edit(domain.mesh, classify_geometry(domain.mesh, domain.features));
            std::mt19937 random(static_cast<unsigned>(seed));
            Cavity<D> cavity;
            Star<D> star;
            for (int i = 0; i < 60; ++i) {
                gather_any(edit, random, cavity);
                QVERIFY(is_closed(cavity));
                const NodeId node = pick(pick(cavity.facets, random), random);
                if (node == edit.ghost()) {
                    continue;
                }
                const Verdict verdict = make_star(edit, cavity, node, star);
                const StarVolumes volumes = compare_volumes(edit, cavity, star);
                const bool inside = std::none_of(cavity.elements.begin(), cavity.elements.end(),
                                                 [&](ElementId e) { return edit.is_ghost(e); });
                if (inside) {
                    QVERIFY(volumes.equal);
                    QVERIFY(volumes.never_smaller);
                    QVERIFY(!volumes.all_positive || volumes.minimal);
                }
                QCOMPARE(verdict,
                         volumes.all_positive ? Verdict::accepted : Verdict::inverts_element);
                ++(verdict == Verdict::accepted ? accepted : refused);
            }
        }
        QCOMPARE_GT(accepted, seeds);
        QCOMPARE_GT(refused, seeds);
    }

    template <int D>
    static void walk(DomainKind kind, int seeds, int steps) {
        int collapses = 0, swaps = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            const auto domain = random_domain<D>(kind, static_cast<unsigned>(seed));
            Workbench<D> bench(domain.mesh, isotropic<D>(domain.mesh.points.size(), 0.1),
                               domain.features);
            const Audit<D> audit(bench.edit, domain.rounding);
            QCOMPARE(audit.complaint(bench.edit), std::string());
            std::mt19937 random(static_cast<unsigned>(seed));
            for (int i = 0; i < steps; ++i) {
                const bool collapse = random() % 2 == 0;
                const bool made = collapse ? collapse_any(bench, random) : swap_any(bench, random);
                if (made) {
                    ++(collapse ? collapses : swaps);
                    const std::string complaint = audit.complaint(bench.edit);
                    QVERIFY2(complaint.empty(),
                             (complaint + " after step " + std::to_string(i) + ", a " +
                              (collapse ? "collapse" : "swap") + ", seed " + std::to_string(seed))
                                 .c_str());
                }
            }
        }
        QCOMPARE_GT(collapses, 8 * seeds);
        QCOMPARE_GT(swaps, 20 * seeds);
    }

private slots:
    void stars_are_accepted_that_cover_the_cavity_and_no_others_data() { add_kinds(); }
    /// The principle of minimal volume (15): elements counted positive never fill less than the
    /// cavity, and fill as much where all of them are positive.
    void stars_are_accepted_that_cover_the_cavity_and_no_others() {
        QFETCH(DomainKind, kind);
        check_stars<2>(kind, 20);
        check_stars<3>(kind, 20);
    }

    void every_single_collapse_and_swap_leaves_a_whole_mesh_data() { add_kinds(); }
    void every_single_collapse_and_swap_leaves_a_whole_mesh() {
        QFETCH(DomainKind, kind);
        walk<2>(kind, 15, 120);
        walk<3>(kind, 10, 120);
    }
};

QTEST_APPLESS_MAIN(CavityPropertyTest)
#include "cavity_property_test.moc"
