// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/coarsen/removal.h"

#include "core/metric/edge_length.h"
#include "core/remesh/coarsening_rules.h"
#include "core/remesh/patch_work.h"

#include <algorithm>

namespace ameco {
namespace {

template <int D>
class Remover {
public:
    Remover(EditMesh<D>& mesh, Lines& lines, RemovalState& state, const RemovalInput<D>& input,
            const RemovalOptions& options, bool first_pass, const Patch& patch,
            VerdictCounts& verdicts)
        : mesh_(mesh), lines_(lines), state_(state), in_(input), options_(options),
          first_pass_(first_pass), patch_(patch), verdicts_(verdicts) {}

    /// Of a line the odd nodes go, wall side first.
    /// \return  false where the node is not within the patch
    bool first_visit(NodeId v) {
        const bool stays = mesh_.node_class(v) == NodeClass::frozen ||
                           (lines_.on_line(v) && lines_.position[v] % 2 == 0);
        if (!stays && !may_leave(v)) {
            return false;
        }
        const bool gone = !stays && (lines_.on_line(v) ? leave_along_line(v) : remove_off_line(v));
        state_.kept[v] = gone ? 0 : 1;
        return true;
    }

    /// \return  false where the node is not within the patch
    bool visit_again(NodeId v) {
        // The bounds on couplings grow tighter with every node that leaves: they let none go later.
        if (mesh_.is_removed(v) || mesh_.node_class(v) == NodeClass::frozen ||
            !in_.notes.changes.changed_since(v, in_.notes.node_tried[v])) {
            return true;
        }
        if (!may_leave(v)) {
            return false;
        }
        const bool gone = lines_.on_line(v) ? thin_line_again(v) : remove_off_line(v);
        if (!gone) {
            in_.notes.node_tried[v] = in_.notes.changes.now(patch_.lane());
        }
        return true;
    }

private:
    /// Whether all that a visit looks at is within the patch: neighbours now, and those of the fine
    /// mesh. The mesh keeps its ridges in one place: on a patch they stay.
    bool may_leave(NodeId v) const {
        if (patch_.is_whole()) {
            return true;
        }
        const auto ball = mesh_.ball(v);
        return mesh_.node_class(v) != NodeClass::ridge &&
               patch_.holds(in_.couplings.neighbours[v]) &&
               std::all_of(ball.begin(), ball.end(),
                           [&](ElementId e) { return patch_.holds(mesh_, e); });
    }

    /// In later passes parity is settled; what the first pass could not take may go now, and the
    /// ends of lines also onto nodes beside them: left over, one node makes a whole ring of thin
    /// elements.
    bool thin_line_again(NodeId v) {
        const NodeId a = lines_.previous[v], b = lines_.next[v];
        const bool crowded = (a.valid() && too_close(v, a, options_.reach)) ||
                             (b.valid() && too_close(v, b, options_.reach));
        if (!crowded) {
            return false;
        }
        if (leave_along_line(v)) {
            return true;
        }
        if ((a.valid() && b.valid()) || lines_.beside_used_gap(v) || !may_leave_late(v) ||
            !remove_off_line(v)) {
            return false;
        }
        take_off_line(v);
        return true;
    }

    /// Whether a wall has moved on which the node's line has a neighbour: it would come to lie
    /// above the elements that the node leaves behind.
    bool beside_moved_wall(NodeId v) const {
        const auto has_moved = [&](NodeId w) {
            const auto ball = mesh_.ball(w);
            return std::any_of(ball.begin(), ball.end(), [&](ElementId e) {
                return mesh_.is_ghost(e) && mesh_.element(e).measure > 0;
            });
        };
        const NodeId a = lines_.previous[v], b = lines_.next[v];
        return (a.valid() && has_moved(a)) || (b.valid() && has_moved(b));
    }

    /// Whether rules are eased for a node of a line in later passes. Not everywhere: lines that
    /// lose their ends cost multigrid more than thin elements do.
    bool may_leave_late(NodeId v) const { return beside_moved_wall(v) || is_left_over(v); }

    /// Whether all nodes beside it in its layer have left.
    bool is_left_over(NodeId v) const {
        int beside = 0;
        for (const NodeId w : in_.couplings.neighbours[v]) {
            if (state_.layer[w] == state_.layer[v]) {
                if (!mesh_.is_removed(w)) {
                    return false;
                }
                ++beside;
            }
        }
        return beside >= D;
    }

    void take_off_line(NodeId v) {
        for (const NodeId beside : {lines_.previous[v], lines_.next[v]}) {
            if (beside.valid()) {
                in_.notes.changes.touch(beside, patch_.lane());
            }
        }
        lines_.remove(v);
    }

    bool leave_along_line(NodeId v) {
        if (lines_.beside_used_gap(v)) {
            verdicts_.add(Verdict::gap);
            return false;
        }
        if (!within_coupling_bound(v)) {
            verdicts_.add(Verdict::coupling_bound);
            return false;
        }
        gather_ball(mesh_, v, ball_);
        Verdict last = Verdict::line_order;
        for (const NodeId w : {lines_.previous[v], lines_.next[v]}) {
            if (!w.valid()) {
                continue;
            }
            last = propose(v, w, 0, star_);
            if (last == Verdict::accepted) {
                commit(v, w);
                take_off_line(v);
                return true;
            }
        }
        verdicts_.add(last);
        return false;
    }

    /// In the first pass onto kept nodes that are too close; later onto any node that is not far.
    bool remove_off_line(NodeId v) {
        mesh_.neighbours(v, neighbours_);
        bool crowded = false;
        candidates_.clear();
        for (const NodeId w : neighbours_) {
            if (first_pass_ ? state_.kept[w] != 0 && too_close(v, w, options_.reach)
                            : too_close(v, w, options_.later_reach)) {
                candidates_.push_back(w);
                crowded = crowded || first_pass_ || too_close(v, w, options_.reach);
            }
        }
        if (!crowded || (!first_pass_ && !is_crowded(v))) {
            return false;
        }
        if (!within_coupling_bound(v)) {
            verdicts_.add(Verdict::coupling_bound);
            return false;
        }
        return take_best(v);
    }

    bool take_best(NodeId v) {
        gather_ball(mesh_, v, ball_);
        NodeId best;
        Verdict first = Verdict::accepted;
        for (const NodeId w : candidates_) {
            const Verdict verdict =
                propose(v, w, best.valid() ? best_star_.worst_quality : 0, star_);
            if (verdict == Verdict::accepted) {
                best = w;
                std::swap(star_, best_star_);
            } else {
                first = first == Verdict::accepted ? verdict : first;
            }
        }
        if (!best.valid()) {
            verdicts_.add(first);
            return false;
        }
        std::swap(star_, best_star_);
        // Other candidates may have been looked at since the best one.
        (void)in_.removed.interpolated_well(mesh_, ball_, star_, leaving(v), patch_.lane());
        commit(v, best);
        return true;
    }

    /// \param better_than  size quality that the worst new element must exceed
    Verdict propose(NodeId v, NodeId w, double better_than, Star<D>& star) {
        const Verdict verdict = propose_collapse(
            mesh_, in_.sizes, options_.surface, options_.quality,
            static_cast<double>(in_.short_size[v]), {.removed = v, .kept = w}, ball_, star);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
        if (star.worst_quality <= better_than) {
            return Verdict::no_improvement;
        }
        return in_.removed.interpolated_well(mesh_, ball_, star, leaving(v), patch_.lane())
                   ? Verdict::accepted
                   : Verdict::weak_coupling;
    }

    Leaving leaving(NodeId v) const {
        const bool late = !first_pass_ && lines_.on_line(v) && may_leave_late(v);
        const InterpolationBound& bound = options_.interpolation;
        return {v, late ? bound.late * interpolation_bound<D>(in_.directions[v], bound) : 0};
    }

    void commit(NodeId v, NodeId w) {
        const auto slots =
            apply_collapse(mesh_, {.removed = v, .kept = w}, ball_, star_, patch_.lane());
        in_.removed.move(ball_.elements, slots, patch_.lane());
        in_.notes.replaced(slots, star_.elements, mesh_, patch_.lane());
        verdicts_.add(Verdict::accepted);
        const auto neighbours = in_.couplings.neighbours[v];
        const auto values = in_.couplings.at(v);
        for (std::size_t i = 0; i < neighbours.size(); ++i) {
            state_.removed_coupling[neighbours[i]] += values[i];
        }
    }

    /// Every removed node must keep a part of its stencil among the nodes that stay: otherwise
    /// no interpolation from the coarse mesh sees its error.
    bool within_coupling_bound(NodeId v) const {
        if (state_.removed_coupling[v] > most_coupling(v)) {
            return false;
        }
        const auto neighbours = in_.couplings.neighbours[v];
        const auto values = in_.couplings.at(v);
        for (std::size_t i = 0; i < neighbours.size(); ++i) {
            const NodeId w = neighbours[i];
            if (mesh_.is_removed(w) && state_.removed_coupling[w] + values[i] > most_coupling(w)) {
                return false;
            }
        }
        return true;
    }

    /// How much coupling with removed nodes a removed node may have.
    float most_coupling(NodeId v) const {
        const double t = isotropy<D>(in_.directions[v]);
        return static_cast<float>(options_.coupling_bound + options_.isotropic_coupling * t * t) *
               in_.couplings.diagonal[v];
    }

    /// Whether the edges of `v` (to `neighbours_`) are short on average.
    bool is_crowded(NodeId v) const {
        double sum = 0;
        for (const NodeId w : neighbours_) {
            sum += target_length(v, w);
        }
        const double most =
            options_.crowded + options_.crowded_layer * (1 - isotropy<D>(in_.directions[v]));
        return sum < most * static_cast<double>(neighbours_.size());
    }

    double target_length(NodeId v, NodeId w) const {
        const Vec<D> e = mesh_.point(w) - mesh_.point(v);
        return edge_length((in_.target[v] * e).norm(), (in_.target[w] * e).norm());
    }

    /// Whether an edge is to go: its length in the target metric is well below 1. Edges the target
    /// does not stretch are left alone until they are much too short; otherwise the accidental
    /// short ones among them would shift whole columns.
    bool too_close(NodeId v, NodeId w, double reach) const {
        constexpr double untouched = 0.4;
        const Vec<D> e = mesh_.point(w) - mesh_.point(v);
        const double from_v = (in_.target[v] * e).squaredNorm();
        const double from_w = (in_.target[w] * e).squaredNorm();
        if (from_v * from_w >= reach * reach * reach * reach) {
            return false; // the length is no less than the geometric mean
        }
        const double target = edge_length(std::sqrt(from_v), std::sqrt(from_w));
        if (target >= reach) {
            return false;
        }
        const double natural =
            edge_length((in_.natural[v] * e).norm(), (in_.natural[w] * e).norm());
        const double stretched = std::clamp((1 - target / natural) / 0.35, 0.0, 1.0);
        return target < untouched + (reach - untouched) * stretched;
    }

    EditMesh<D>& mesh_;
    Lines& lines_;
    RemovalState& state_;
    const RemovalInput<D>& in_;
    const RemovalOptions& options_;
    const bool first_pass_;
    const Patch patch_;
    VerdictCounts& verdicts_;
    Cavity<D> ball_;
    Star<D> star_, best_star_;
    std::vector<NodeId> neighbours_, candidates_;
};

/// A pass, for `work_in_patches`.
template <int D>
struct RemovalPass {
    EditMesh<D>& mesh;
    Lines& lines;
    RemovalState& state;
    const RemovalInput<D>& input;
    const RemovalOptions& options;
    bool first;

    void open(std::size_t lanes) { open_lanes(mesh, input.removed, input.notes, lanes); }
    [[nodiscard]] static int part_of(const Partition& partition, NodeId v) {
        return partition.part[v];
    }
    [[nodiscard]] auto worker(const Patch& patch, VerdictCounts& counts) {
        return [this, remover = Remover<D>(mesh, lines, state, input, options, first, patch,
                                           counts)](NodeId v) mutable {
            return first ? remover.first_visit(v) : remover.visit_again(v);
        };
    }
};

} // namespace

template <int D>
void remove_first_pass(EditMesh<D>& mesh, Lines& lines, RemovalState& state,
                       const RemovalInput<D>& input, const RemovalOptions& options,
                       VerdictCounts& verdicts, Monitor& monitor) {
    RemovalPass<D> pass{mesh, lines, state, input, options, true};
    work_in_patches(input.order, input.partitions, pass, verdicts, "removing nodes", monitor);
}

template <int D>
void remove_again(EditMesh<D>& mesh, Lines& lines, RemovalState& state,
                  const RemovalInput<D>& input, const RemovalOptions& options,
                  VerdictCounts& verdicts, Monitor& monitor) {
    RemovalPass<D> pass{mesh, lines, state, input, options, false};
    work_in_patches(input.order, input.partitions, pass, verdicts, "removing nodes", monitor);
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template void remove_first_pass(EditMesh<D>&, Lines&, RemovalState&, const RemovalInput<D>&,   \
                                    const RemovalOptions&, VerdictCounts&, Monitor&);              \
    template void remove_again(EditMesh<D>&, Lines&, RemovalState&, const RemovalInput<D>&,        \
                               const RemovalOptions&, VerdictCounts&, Monitor&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
