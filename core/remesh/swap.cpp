// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/swap.h"

#include <algorithm>

namespace ameco {
namespace {

template <int D>
class Swapper {
public:
    Swapper(EditMesh<D>& mesh, const SwapInput<D>& input, const SwapOptions& options,
            const SurfaceRules& surface, VerdictCounts& verdicts)
        : mesh_(mesh), in_(input), options_(options), surface_(surface), verdicts_(verdicts),
          tried_(mesh.slot_count(), 0), quality_(mesh.slot_count(), -1) {}

    /// Tries the swaps at one element; true if one was made.
    bool mend(ElementId e) {
        best_quality_ = 0;
        best_verdict_ = Verdict::no_improvement;
        const Simplex<D> s = mesh_.nodes(e);
        for (const auto& [i, j] : SimplexNumbering<D>::edges) {
            try_edge(s[i], s[j]);
        }
        if constexpr (D == 3) {
            for (const NodeId v : s) {
                try_face(e, v);
            }
        }
        verdicts_.add(best_quality_ > 0 ? Verdict::accepted : best_verdict_);
        if (best_quality_ == 0) {
            tried_[e.index()] = 1;
            return false;
        }
        // Other proposals may have been looked at since the best one was found.
        (void)in_.removed.interpolated_well(mesh_, best_cavity_, best_star_);
        const auto slots =
            mesh_.replace(best_cavity_.elements, best_star_.elements, best_star_.sources);
        in_.removed.move(best_cavity_.elements, slots);
        forget();
        return true;
    }

    /// Whether the element failed before, and all around it is as it was then.
    bool failed_before(ElementId e) const { return tried_[e.index()] != 0; }

    /// Quality of an element as it stands; computed once until the element changes.
    double quality(ElementId e) {
        float& known = quality_[e.index()];
        if (known < 0) {
            known = static_cast<float>(metric_quality(mesh_, in_.root, mesh_.nodes(e)));
        }
        return static_cast<double>(known);
    }

private:
    /// After a change: qualities of the new elements are not known, and what failed beside them may
    /// succeed now.
    void forget() {
        tried_.resize(mesh_.slot_count(), 0);
        quality_.resize(mesh_.slot_count(), -1);
        for (const ElementId e : mesh_.ball(best_node_)) {
            quality_[e.index()] = -1;
        }
        for (const EditElement<D>& fresh : best_star_.elements) {
            for (const NodeId v : fresh.nodes) {
                if (v == mesh_.ghost()) {
                    continue;
                }
                for (const ElementId e : mesh_.ball(v)) {
                    tried_[e.index()] = 0;
                }
            }
        }
    }

    void try_edge(NodeId a, NodeId b) {
        // Listed lines may run inside the domain too; all their nodes are ridge nodes or frozen.
        const bool ridge = may_be_on_ridge(a) && may_be_on_ridge(b) && mesh_.is_ridge(a, b);
        if (ridge || protected_inside<2>({a, b})) {
            note(Verdict::geometry_class);
            return;
        }
        gather_shell(mesh_, a, b, cavity_);
        if (cavity_.elements.size() > options_.largest_shell) {
            note(Verdict::cavity_too_large);
            return;
        }
        if (!one_label() || touches_frozen_face()) {
            note(Verdict::region_border);
            return;
        }
        // On the boundary only the two nodes beside the ghost will do: a star from one behind them
        // would pull it to the surface.
        const bool at_boundary = std::any_of(cavity_.elements.begin(), cavity_.elements.end(),
                                             [&](ElementId e) { return mesh_.is_ghost(e); });
        ring_.clear();
        for (const ElementId e : cavity_.elements) {
            if (at_boundary && !mesh_.is_ghost(e)) {
                continue;
            }
            for (const NodeId v : mesh_.nodes(e)) {
                if (v != a && v != b && v != mesh_.ghost()) {
                    ring_.push_back(v);
                }
            }
        }
        std::sort(ring_.begin(), ring_.end());
        ring_.erase(std::unique(ring_.begin(), ring_.end()), ring_.end());
        try_stars(ring_);
    }

    /// The face of `e` opposite `v`: 2 elements become 3 around the edge to the node behind.
    void try_face(ElementId e, NodeId v) {
        const ElementId behind = neighbour(e, v);
        if (!behind.valid() || mesh_.is_ghost(behind)) {
            return;
        }
        const Simplex<D>& s = mesh_.nodes(e);
        std::array<NodeId, D> face;
        std::copy_if(s.begin(), s.end(), face.begin(), [&](NodeId w) { return w != v; });
        gather_pair(mesh_, e, behind, cavity_);
        if (protected_inside<D>(face) || !one_label()) {
            note(Verdict::region_border);
            return;
        }
        ring_.assign(1, v);
        try_stars(ring_);
    }

    void try_stars(const std::vector<NodeId>& nodes) {
        double quality_before = 1, size_before = 1;
        int lineless_before = 0;
        bool any_ghost = false;
        for (const ElementId e : cavity_.elements) {
            if (mesh_.is_ghost(e)) {
                any_ghost = true;
                continue;
            }
            quality_before = std::min(quality_before, quality(e));
            size_before = std::min(size_before, static_cast<double>(mesh_.element(e).measure));
            lineless_before += is_lineless<D>(in_.lines, mesh_.nodes(e));
        }
        const double needed = std::max(quality_before * options_.gain, best_quality_);
        for (const NodeId node : nodes) {
            const Verdict verdict = judge_star(node, std::max(needed, best_quality_), size_before,
                                               lineless_before, any_ghost);
            if (verdict == Verdict::accepted) {
                std::swap(best_star_, star_);
                best_cavity_ = cavity_;
                best_node_ = node;
            } else {
                note(verdict);
            }
        }
    }

    /// Builds and judges the star of the cavity from `node`; when accepted, best_quality_ is its.
    Verdict judge_star(NodeId node, double needed, double size_before, int lineless_before,
                       bool any_ghost) {
        Verdict verdict = make_star(mesh_, cavity_, node, star_);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
        double worst = 1;
        int lineless = 0;
        for (const EditElement<D>& e : star_.elements) {
            if (e.nodes[D] == mesh_.ghost()) {
                continue;
            }
            worst = std::min(worst, metric_quality(mesh_, in_.root, e.nodes));
            if (worst <= needed) {
                return Verdict::no_improvement;
            }
            lineless += is_lineless<D>(in_.lines, e.nodes);
        }
        if (lineless > lineless_before) {
            return Verdict::breaks_line;
        }
        verdict = judge(mesh_, in_.sizes, std::min(options_.size_floor, size_before), star_);
        if (verdict == Verdict::accepted && any_ghost) {
            verdict = judge_boundary(node);
        }
        if (verdict == Verdict::accepted && !in_.removed.interpolated_well(mesh_, cavity_, star_)) {
            verdict = Verdict::weak_coupling;
        }
        if (verdict == Verdict::accepted) {
            best_quality_ = worst;
        }
        return verdict;
    }

    Verdict judge_boundary(NodeId node) {
        // The new boundary edge must not exist elsewhere already.
        for (const EditElement<D>& e : star_.elements) {
            if (e.nodes[D] == mesh_.ghost()) {
                for (int i = 0; i < D; ++i) {
                    const NodeId v = e.nodes[i];
                    if (v != node && !in_ghost_of_cavity(node, v) && boundary_edge(node, v)) {
                        return Verdict::link_condition;
                    }
                }
            }
        }
        return judge_surface(mesh_, cavity_, static_cast<double>(in_.short_size[node]), surface_,
                             star_);
    }

    bool boundary_edge(NodeId a, NodeId b) const {
        const auto ball = mesh_.ball(a);
        return std::any_of(ball.begin(), ball.end(), [&](ElementId e) {
            return mesh_.is_ghost(e) && has(mesh_.nodes(e), b);
        });
    }

    bool in_ghost_of_cavity(NodeId a, NodeId b) const {
        return std::any_of(cavity_.elements.begin(), cavity_.elements.end(), [&](ElementId e) {
            return mesh_.is_ghost(e) && has(mesh_.nodes(e), a) && has(mesh_.nodes(e), b);
        });
    }

    static bool has(const Simplex<D>& s, NodeId v) {
        return std::find(s.begin(), s.end(), v) != s.end();
    }

    /// All real elements of one region, all boundary faces of one patch.
    bool one_label() const {
        const EditElement<D>* real = nullptr;
        const EditElement<D>* ghost = nullptr;
        for (const ElementId e : cavity_.elements) {
            const EditElement<D>*& first = mesh_.is_ghost(e) ? ghost : real;
            if (first == nullptr) {
                first = &mesh_.element(e);
            } else if (first->label != mesh_.element(e).label) {
                return false;
            }
        }
        return true;
    }

    /// A boundary face all of whose nodes are frozen belongs to a frozen patch or is required, or
    /// might: it stays.
    bool touches_frozen_face() const {
        return std::any_of(cavity_.elements.begin(), cavity_.elements.end(), [&](ElementId e) {
            if (!mesh_.is_ghost(e)) {
                return false;
            }
            const Facet<D> face = ghost_face<D>(mesh_.nodes(e));
            return std::all_of(face.begin(), face.end(),
                               [&](NodeId v) { return mesh_.node_class(v) == NodeClass::frozen; });
        });
    }

    bool may_be_on_ridge(NodeId v) const {
        const NodeClass c = mesh_.node_class(v);
        return c == NodeClass::ridge || c == NodeClass::frozen;
    }

    template <std::size_t N>
    bool protected_inside(const std::array<NodeId, N>& nodes) const {
        return mesh_.has_protected_inside() &&
               std::all_of(nodes.begin(), nodes.end(),
                           [&](NodeId v) { return mesh_.node_class(v) == NodeClass::frozen; });
    }

    /// The element behind the facet of `e` opposite `v`.
    ElementId neighbour(ElementId e, NodeId v) const {
        const Simplex<D>& s = mesh_.nodes(e);
        const NodeId other = s[0] == v ? s[1] : s[0];
        for (const ElementId f : mesh_.ball(other)) {
            if (f != e && std::all_of(s.begin(), s.end(),
                                      [&](NodeId w) { return w == v || has(mesh_.nodes(f), w); })) {
                return f;
            }
        }
        return {};
    }

    void note(Verdict verdict) {
        if (best_verdict_ == Verdict::no_improvement) {
            best_verdict_ = verdict;
        }
    }

    EditMesh<D>& mesh_;
    const SwapInput<D>& in_;
    const SwapOptions& options_;
    const SurfaceRules& surface_;
    VerdictCounts& verdicts_;
    Cavity<D> cavity_, best_cavity_;
    Star<D> star_, best_star_;
    std::vector<NodeId> ring_;
    double best_quality_ = 0;
    Verdict best_verdict_ = Verdict::no_improvement;
    NodeId best_node_;
    std::vector<std::uint8_t> tried_; ///< [slots] see failed_before
    std::vector<float> quality_;      ///< [slots] negative while not known
};

} // namespace

template <int D>
bool is_lineless(const Lines& lines, const Simplex<D>& element) {
    for (const NodeId v : element) {
        if (!lines.on_line(v)) {
            return false;
        }
    }
    for (const auto& [i, j] : SimplexNumbering<D>::edges) {
        if (lines.linked(element[i], element[j])) {
            return false;
        }
    }
    return true;
}

template <int D>
void swap_bad_elements(EditMesh<D>& mesh, const SwapInput<D>& input, const SwapOptions& options,
                       const SurfaceRules& surface, VerdictCounts& verdicts, Monitor& monitor) {
    Swapper<D> swapper(mesh, input, options, surface, verdicts);
    for (int round = 0; round < options.rounds; ++round) {
        std::int64_t made = 0;
        // Slots are visited in order; elements made on the way wait for the next round.
        const std::size_t slots = mesh.slot_count();
        for (std::size_t i = 0; i < slots; ++i) {
            const ElementId e(i);
            if ((i & 0xFFFF) == 0) {
                monitor.progress((round + static_cast<double>(i) / static_cast<double>(slots)) /
                                     options.rounds,
                                 "swapping");
                if (monitor.stop_requested()) {
                    return;
                }
            }
            if (!mesh.is_free(e) && !mesh.is_ghost(e) && !swapper.failed_before(e) &&
                swapper.quality(e) < options.below) {
                made += swapper.mend(e);
            }
        }
        if (made == 0) {
            break;
        }
    }
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template bool is_lineless<D>(const Lines&, const Simplex<D>&);                                 \
    template void swap_bad_elements(EditMesh<D>&, const SwapInput<D>&, const SwapOptions&,         \
                                    const SurfaceRules&, VerdictCounts&, Monitor&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
