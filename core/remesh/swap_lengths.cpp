// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/swap_lengths.h"

#include "core/base/parallel.h"
#include "core/metric/edge_length.h"
#include "core/metric/length_excess.h"
#include "core/remesh/coarsening_rules.h"
#include "core/remesh/edge_shell.h"
#include "core/remesh/patch_work.h"
#include "core/remesh/stiffness_diagonal.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

/// `length_excess` of an edge. The length lies between those seen from either end: most edges are
/// in band by both, and need neither roots nor logarithms.
template <int D>
double excess_of(const EditMesh<D>& mesh, const IdVector<NodeId, Mat<D>>& target, NodeId a,
                 NodeId b) {
    constexpr double shortest = shortest_in_band * shortest_in_band;
    constexpr double longest = longest_in_band * longest_in_band;
    const Vec<D> e = mesh.point(b) - mesh.point(a);
    const double from_a = (target[a] * e).squaredNorm(), from_b = (target[b] * e).squaredNorm();
    if (std::min(from_a, from_b) >= shortest && std::max(from_a, from_b) <= longest) {
        return 0;
    }
    return length_excess(edge_length(std::sqrt(from_a), std::sqrt(from_b)));
}

/// Swaps edges within a patch.
template <int D>
class LengthSwapper {
public:
    LengthSwapper(EditMesh<D>& mesh, const SwapInput<D>& input,
                  const IdVector<NodeId, Mat<D>>& target, const LengthSwapOptions& options,
                  const SurfaceRules& surface, const Patch& patch, VerdictCounts& verdicts)
        : mesh_(mesh), target_(target), options_(options), surface_(surface), patch_(patch),
          lines_(input.lines), verdicts_(verdicts),
          rules_(mesh, input, options.size_floor, patch.lane()) {}

    /// \return  false where the shell of the edge is not within the patch
    bool operator()(const Edge& edge) {
        const auto [a, b] = edge;
        gather_shell(mesh_, a, b, cavity_);
        if (cavity_.elements.empty()) {
            return true; // it went with another
        }
        if (!is_within()) {
            return false;
        }
        Verdict verdict = may_leave(a, b);
        if (verdict == Verdict::accepted) {
            verdict = find_best(a, b);
        }
        verdicts_.add(verdict);
        if (verdict == Verdict::accepted) {
            rules_.make(cavity_, best_);
        }
        return true;
    }

private:
    Verdict may_leave(NodeId a, NodeId b) const {
        if (at_boundary(mesh_, cavity_)) {
            return Verdict::geometry_class;
        }
        return cavity_.elements.size() <= options_.largest_shell
                   ? allowed_to_leave(mesh_, a, b, cavity_)
                   : Verdict::cavity_too_large;
    }

    /// Whether all elements at the edge are, and there is room for more.
    bool is_within() const {
        return patch_.is_whole() ||
               (mesh_.free_slots(patch_.lane()) >= options_.largest_shell &&
                std::all_of(cavity_.elements.begin(), cavity_.elements.end(),
                            [&](ElementId e) { return patch_.holds(mesh_, e); }));
    }

    /// The star that lowers the excess the most, of those that are allowed.
    /// \return  accepted, or why there is none: what kept the one that came the farthest
    Verdict find_best(NodeId a, NodeId b) {
        shell_ring(mesh_, a, b, cavity_, ring_);
        drop_equal_stars(mesh_, cavity_, ring_);
        gather_others(a, b);
        seen_ = false;
        double most = excess_of(mesh_, target_, a, b) - least_excess_fall; // that may come
        Verdict found = Verdict::no_improvement;
        for (const NodeId w : ring_) {
            const double comes = excess_that_comes(w, most);
            if (comes >= most) {
                continue;
            }
            const Verdict verdict = judge_star(w);
            if (verdict == Verdict::accepted) {
                most = comes;
                std::swap(best_, star_);
                found = verdict;
            } else if (found == Verdict::no_improvement) {
                found = verdict;
            }
        }
        return found;
    }

    /// The nodes of the cavity that are not on its edge.
    void gather_others(NodeId a, NodeId b) {
        others_.clear();
        for (const ElementId e : cavity_.elements) {
            for (const NodeId v : mesh_.nodes(e)) {
                if (v != a && v != b &&
                    std::find(others_.begin(), others_.end(), v) == others_.end()) {
                    others_.push_back(v);
                }
            }
        }
    }

    void look_at_cavity() {
        before_.clear();
        for (const ElementId e : cavity_.elements) {
            before_.add(mesh_, mesh_.nodes(e));
        }
        rules_.look_at(cavity_);
        seen_ = true;
    }

    double worst_in_cavity() {
        double worst = 1;
        for (const ElementId e : cavity_.elements) {
            worst = std::min(worst, rules_.quality(e));
        }
        return worst;
    }

    bool is_edge(NodeId v, NodeId w) const {
        return std::any_of(cavity_.elements.begin(), cavity_.elements.end(), [&](ElementId e) {
            const Simplex<D>& s = mesh_.nodes(e);
            return std::find(s.begin(), s.end(), v) != s.end() &&
                   std::find(s.begin(), s.end(), w) != s.end();
        });
    }

    /// Of the edges that a star brings; exact only where it is below `most`.
    double excess_that_comes(NodeId w, double most) const {
        double sum = 0;
        for (std::size_t k = 0; k < others_.size() && sum < most; ++k) {
            if (others_[k] != w && !is_edge(others_[k], w)) {
                sum += excess_of(mesh_, target_, others_[k], w);
            }
        }
        return sum;
    }

    Verdict judge_star(NodeId w) {
        join_star(mesh_, cavity_, w, star_);
        // Exact signs cost more than the quality, which is 0 where they are clearly wrong.
        if (!is_good_enough()) {
            return Verdict::low_quality;
        }
        Verdict verdict = test_star(mesh_, star_);
        if (verdict == Verdict::accepted && !stiffens_no_node()) {
            verdict = Verdict::stiff_element;
        }
        if (verdict == Verdict::accepted) {
            verdict = judge_layer(mesh_, cavity_, surface_, star_);
        }
        return verdict == Verdict::accepted ? rules_.judge(cavity_, star_) : verdict;
    }

    bool is_good_enough() {
        const double needed = std::min(worst_in_cavity(), options_.quality_floor);
        return std::all_of(star_.elements.begin(), star_.elements.end(), [&](const auto& e) {
            const double quality = rules_.quality(e.nodes, needed);
            return quality > 0 && quality >= needed;
        });
    }

    /// \post  the rules have looked at the cavity: most have no star that comes so far
    bool stiffens_no_node() {
        if (!seen_) {
            look_at_cavity();
        }
        after_.clear();
        for (const EditElement<D>& e : star_.elements) {
            after_.add(mesh_, e.nodes);
        }
        return std::all_of(after_.parts().begin(), after_.parts().end(), [&](const auto& part) {
            const double factor =
                lines_.on_line(part.node) ? options_.line_stiffening : options_.stiffening;
            return part.sum <= factor * before_[part.node];
        });
    }

    EditMesh<D>& mesh_;
    const IdVector<NodeId, Mat<D>>& target_;
    const LengthSwapOptions& options_;
    const SurfaceRules& surface_;
    const Patch patch_;
    const Lines& lines_;
    VerdictCounts& verdicts_;
    CoarseningRules<D> rules_;
    Cavity<D> cavity_;
    Star<D> star_, best_;
    std::vector<NodeId> ring_, others_;
    StiffnessDiagonal<D> before_, after_;
    bool seen_ = false; ///< the cavity, by the rules
};

/// A round, for `work_in_patches`.
template <int D>
struct LengthRound {
    EditMesh<D>& mesh;
    const SwapInput<D>& input;
    const IdVector<NodeId, Mat<D>>& target;
    const LengthSwapOptions& options;
    const SurfaceRules& surface;

    void open(std::size_t lanes) { open_lanes(mesh, input.removed, input.notes, lanes); }
    [[nodiscard]] int part_of(const Partition& partition, const Edge& edge) const {
        const int part = partition.part[edge[0]];
        return partition.part[edge[1]] == part ? part : -1;
    }
    [[nodiscard]] LengthSwapper<D> worker(const Patch& patch, VerdictCounts& counts) {
        return {mesh, input, target, options, surface, patch, counts};
    }
};

void sort_unique(std::vector<Edge>& edges) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

/// Edges out of band between nodes that have changed since a time, ascending.
template <int D>
std::vector<Edge> edges_to_try(const EditMesh<D>& mesh, const IdVector<NodeId, Mat<D>>& target,
                               const ChangeTimes& changes, ChangeTimes::Time since) {
    constexpr std::size_t slots_per_piece = 16384;
    std::vector<std::vector<Edge>> pieces(mesh.slot_count() / slots_per_piece + 1);
    parallel_for(mesh.slot_count(), slots_per_piece, [&](std::size_t begin, std::size_t end) {
        std::vector<Edge>& piece = pieces[begin / slots_per_piece];
        for (std::size_t i = begin; i < end; ++i) {
            const ElementId e(i);
            if (mesh.is_free(e) || mesh.is_ghost(e)) {
                continue;
            }
            const Simplex<D>& s = mesh.nodes(e);
            for (const auto& [j, k] : SimplexNumbering<D>::edges) {
                if (changes.changed_since(s[j], since) && changes.changed_since(s[k], since) &&
                    excess_of(mesh, target, s[j], s[k]) > 0) {
                    piece.push_back(sorted(Edge{s[j], s[k]}));
                }
            }
        }
        sort_unique(piece); // most edges have all their elements in one piece
    });
    std::vector<Edge> edges;
    for (const std::vector<Edge>& piece : pieces) {
        edges.insert(edges.end(), piece.begin(), piece.end());
    }
    sort_unique(edges);
    return edges;
}

} // namespace

template <int D>
void swap_lengths(EditMesh<D>& mesh, const SwapInput<D>& input,
                  const IdVector<NodeId, Mat<D>>& target, const LengthSwapOptions& options,
                  const SurfaceRules& surface, VerdictCounts& verdicts, Monitor& monitor) {
    LengthRound<D> work{mesh, input, target, options, surface};
    ChangeTimes::Time since = 0;
    for (int round = 0; round < options.rounds && !monitor.stop_requested(); ++round) {
        const std::vector<Edge> edges = edges_to_try(mesh, target, input.notes.changes, since);
        since = input.notes.changes.now();
        const std::int64_t before = verdicts[Verdict::accepted];
        MonitorPart part(monitor, static_cast<double>(round) / options.rounds,
                         (round + 1.0) / options.rounds);
        work_in_patches(edges, input.partitions, work, verdicts, "swapping for lengths", part);
        if (verdicts[Verdict::accepted] == before) {
            break;
        }
    }
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template void swap_lengths(EditMesh<D>&, const SwapInput<D>&, const IdVector<NodeId, Mat<D>>&, \
                               const LengthSwapOptions&, const SurfaceRules&, VerdictCounts&,      \
                               Monitor&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
