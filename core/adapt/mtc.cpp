// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adapt/mtc.h"

#include "core/adapt/quality_order.h"
#include "core/adapt/split_edges.h"
#include "core/remesh/collapse.h"
#include "core/remesh/edge_shell.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

template <int D>
class Mtc {
public:
    Mtc(UnitMesh<D>& mesh, const MtcOptions& options, const SurfaceRules& surface,
        const MtcVerdicts& verdicts)
        : mesh_(mesh), options_(options), surface_(surface), verdicts_(verdicts) {}

    /// Looks for a better star of the ball of v; true if there was one.
    bool mend_ball(NodeId v) {
        gather_ball(mesh_.edit, v, cavity_);
        start();
        mesh_.edit.neighbours(v, candidates_);
        for (const NodeId w : candidates_) {
            const Collapse collapse{.removed = v, .kept = w};
            Verdict verdict = allowed_by_geometry(mesh_.edit, collapse);
            if (verdict == Verdict::accepted) {
                verdict = compare(w);
            }
            if (verdict == Verdict::accepted && mesh_.edit.on_boundary(v)) {
                verdict = judge_collapsed_boundary(mesh_.edit, surface_, mesh_.short_size(v),
                                                   collapse, cavity_, star_);
            }
            keep_or_note(verdict, w);
        }
        const bool moved = options_.new_places && move(v);
        verdicts_.collapses.add(best_node_.valid() && !moved ? Verdict::accepted : refusal_);
        if (!moved && best_node_.valid() && mesh_.edit.node_class(v) == NodeClass::ridge) {
            mesh_.edit.merge_ridges(v, best_node_);
        }
        return fill();
    }

    /// The same for the shell of an edge.
    bool mend_shell(NodeId a, NodeId b) {
        gather_shell(mesh_.edit, a, b, cavity_);
        start();
        const Verdict allowed = allowed_to_leave(mesh_.edit, a, b, cavity_);
        if (allowed == Verdict::accepted) {
            shell_ring(mesh_.edit, a, b, cavity_, candidates_);
            for (const NodeId w : candidates_) {
                Verdict verdict = compare(w);
                if (verdict == Verdict::accepted) {
                    verdict = judge_swapped_boundary(mesh_.edit, surface_, mesh_.short_size(w),
                                                     cavity_, w, star_);
                }
                keep_or_note(verdict, w);
            }
        } else {
            refusal_ = allowed;
        }
        const bool split =
            options_.new_places && mesh_.length(a, b) > options_.insert_above && split_edge(a, b);
        verdicts_.swaps.add(best_node_.valid() && !split ? Verdict::accepted : refusal_);
        return fill();
    }

private:
    /// The cavity as it stands is the best so far.
    void start() {
        best_node_ = {};
        refusal_ = Verdict::no_improvement;
        best_.clear();
        for (const ElementId e : cavity_.elements) {
            if (!mesh_.edit.is_ghost(e)) {
                best_.push_back(mesh_.edit.element(e).measure);
            }
        }
        std::sort(best_.begin(), best_.end());
    }

    /// Stars the cavity from a node, and compares the set of qualities with the best so far.
    Verdict compare(NodeId node) {
        join_star(mesh_.edit, cavity_, node, star_);
        // Below the worst one so far the rest need not be computed; a tie must be.
        const float below = std::nextafter(best_.front(), 0.0F);
        if (mesh_.judge(static_cast<double>(below), star_) != Verdict::accepted) {
            return Verdict::no_improvement;
        }
        fresh_.clear();
        for (const EditElement<D>& e : star_.elements) {
            if (e.nodes[D] != mesh_.edit.ghost()) {
                fresh_.push_back(e.measure);
            }
        }
        std::sort(fresh_.begin(), fresh_.end());
        // Exact signs cost more than the quality, which is 0 where they are clearly wrong.
        return is_worse(best_, fresh_) ? test_star(mesh_.edit, star_) : Verdict::no_improvement;
    }

    void keep_or_note(Verdict verdict, NodeId node) {
        if (verdict == Verdict::accepted) {
            best_node_ = node;
            std::swap(best_, fresh_);
            std::swap(best_star_, star_);
        } else if (refusal_ == Verdict::no_improvement) {
            refusal_ = verdict;
        }
    }

    /// Moves a node to the barycentre of its neighbours if that is the best star of its ball.
    bool move(NodeId v) {
        if (mesh_.edit.node_class(v) != NodeClass::interior) {
            return false;
        }
        Vec<D> p = Vec<D>::Zero();
        for (const NodeId w : candidates_) {
            p += mesh_.edit.point(w) / static_cast<double>(candidates_.size());
        }
        const auto old = mesh_.state(v);
        mesh_.move_node(v, p);
        const Verdict verdict = compare(v);
        verdicts_.moves.add(verdict);
        if (verdict != Verdict::accepted) {
            mesh_.restore(v, old);
            return false;
        }
        keep_or_note(verdict, v);
        return true;
    }

    /// Puts a node into the middle of an edge if that is the best star of its shell.
    bool split_edge(NodeId a, NodeId b) {
        Verdict verdict = allowed_to_change(mesh_.edit, a, b, cavity_);
        if (verdict == Verdict::accepted) {
            const NodeId m = add_middle_node(mesh_, a, b, cavity_);
            verdict = compare(m);
            if (verdict == Verdict::accepted) {
                keep_or_note(verdict, m);
                mesh_.edit.split_ridge(a, b, m);
            } else {
                mesh_.drop_last_node();
            }
        }
        verdicts_.splits.add(verdict);
        return verdict == Verdict::accepted;
    }

    bool fill() {
        if (best_node_.valid()) {
            mesh_.replace(cavity_, best_star_);
        }
        return best_node_.valid();
    }

    UnitMesh<D>& mesh_;
    const MtcOptions& options_;
    const SurfaceRules& surface_;
    const MtcVerdicts& verdicts_;
    Cavity<D> cavity_;
    Star<D> star_, best_star_;
    std::vector<float> best_, fresh_; ///< sets of qualities, ascending
    std::vector<NodeId> candidates_;
    NodeId best_node_; ///< the best star is from this one; none: the cavity as it stands
    Verdict refusal_ = Verdict::no_improvement;
};

} // namespace

template <int D>
bool mend_ball(UnitMesh<D>& mesh, NodeId v, const MtcOptions& options, const SurfaceRules& surface,
               const MtcVerdicts& verdicts) {
    return Mtc<D>(mesh, options, surface, verdicts).mend_ball(v);
}

template <int D>
bool mend_shell(UnitMesh<D>& mesh, Edge edge, const MtcOptions& options,
                const SurfaceRules& surface, const MtcVerdicts& verdicts) {
    return Mtc<D>(mesh, options, surface, verdicts).mend_shell(edge[0], edge[1]);
}

template <int D>
std::int64_t mtc_sweep(UnitMesh<D>& mesh, const MtcOptions& options, const SurfaceRules& surface,
                       int since, const MtcVerdicts& verdicts, const Monitor& monitor) {
    Mtc<D> mtc(mesh, options, surface, verdicts);
    std::int64_t made = 0;
    StopCheck stop(monitor);
    const std::size_t nodes = mesh.edit.node_count();
    for (std::size_t i = 0; i < nodes && !stop.asked(); ++i) {
        const NodeId v(i);
        if (!mesh.edit.is_removed(v) && mesh.changed_since(v, since)) {
            made += mtc.mend_ball(v) ? 1 : 0;
        }
    }
    std::vector<NodeId> neighbours, now;
    for (std::size_t i = 0; i < nodes && !stop.asked(); ++i) {
        const NodeId v(i);
        if (mesh.edit.is_removed(v) || !mesh.changed_since(v, since)) {
            continue;
        }
        mesh.edit.neighbours(v, neighbours);
        for (const NodeId w : neighbours) {
            if (w < v || !mesh.changed_since(w, since)) {
                continue;
            }
            // The shells before this one may have taken the edge away.
            mesh.edit.neighbours(v, now);
            if (std::binary_search(now.begin(), now.end(), w)) {
                made += mtc.mend_shell(v, w) ? 1 : 0;
            }
        }
    }
    return made;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template bool mend_ball(UnitMesh<D>&, NodeId, const MtcOptions&, const SurfaceRules&,          \
                            const MtcVerdicts&);                                                   \
    template bool mend_shell(UnitMesh<D>&, Edge, const MtcOptions&, const SurfaceRules&,           \
                             const MtcVerdicts&);                                                  \
    template std::int64_t mtc_sweep(UnitMesh<D>&, const MtcOptions&, const SurfaceRules&, int,     \
                                    const MtcVerdicts&, const Monitor&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
