// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/swap.h"

#include "core/base/parallel.h"
#include "core/remesh/coarsening_rules.h"
#include "core/remesh/patch_work.h"

#include <algorithm>

namespace ameco {
namespace {

/// Mends elements of low quality within a patch.
template <int D>
class Mender {
public:
    Mender(EditMesh<D>& mesh, const SwapInput<D>& input, const SwapOptions& options,
           const SurfaceRules& surface, const Patch& patch, VerdictCounts& verdicts)
        : mesh_(mesh), options_(options), notes_(input.notes), patch_(patch),
          rules_(mesh, input, options.size_floor, patch.lane()),
          search_(mesh, rules_, options, surface, verdicts) {}

    /// \return  false where the element is not within the patch
    bool operator()(ElementId e) {
        if (mesh_.is_free(e) || mesh_.is_ghost(e) || rules_.quality(e) >= options_.below) {
            return true; // after changes beside it
        }
        const unsigned corners =
            notes_.changes.changed_corners(mesh_.nodes(e), notes_.element_tried[e.index()]);
        if (!ChangeTimes::has_edge(corners)) {
            return true;
        }
        if (!look_around(e, corners)) {
            return false;
        }
        if (!search_.mend(e, around_)) {
            notes_.element_tried[e.index()] = notes_.changes.now(patch_.lane());
        }
        return true;
    }

private:
    /// \return  whether all that the search looks at is within the patch, which is elements that
    ///          share an edge with this one, and there is room for what a swap adds: fewer elements
    ///          than its shell has
    bool look_around(ElementId e, unsigned corners) {
        if (!patch_.is_whole() && mesh_.free_slots(patch_.lane()) < options_.largest_shell) {
            return false;
        }
        const double quality = rules_.quality(e);
        bool within = true;
        around_.find(mesh_, e, corners, [&](ElementId f) {
            within = within && (patch_.is_whole() || patch_.holds(mesh_, f));
            return within && !mesh_.is_ghost(f) && rules_.quality(f) < quality;
        });
        return within;
    }

    EditMesh<D>& mesh_;
    const SwapOptions& options_;
    EditNotes& notes_;
    const Patch patch_;
    CoarseningRules<D> rules_;
    SwapSearch<D, CoarseningRules<D>> search_;
    EdgeNeighbours<D> around_;
};

/// A round, for `work_in_patches`.
template <int D>
struct SwapRound {
    EditMesh<D>& mesh;
    const SwapInput<D>& input;
    const SwapOptions& options;
    const SurfaceRules& surface;

    void open(std::size_t lanes) { open_lanes(mesh, input.removed, input.notes, lanes); }
    [[nodiscard]] int part_of(const Partition& partition, ElementId e) const {
        if (mesh.is_free(e) || mesh.is_ghost(e)) {
            return -1; // changed since it was listed
        }
        const Simplex<D>& s = mesh.nodes(e);
        const int part = partition.part[s[0]];
        const bool same =
            std::all_of(s.begin(), s.end(), [&](NodeId v) { return partition.part[v] == part; });
        return same ? part : -1;
    }
    [[nodiscard]] Mender<D> worker(const Patch& patch, VerdictCounts& counts) {
        return {mesh, input, options, surface, patch, counts};
    }
};

/// Elements to be tried, in the order of their slots: those that are bad now. A mesh that is worked
/// on as a whole gets all slots, as elements may turn bad before their turn comes; with parts,
/// dealing them out would cost more than that brings.
template <int D>
std::vector<ElementId> elements_to_try(EditMesh<D>& mesh, const SwapInput<D>& input,
                                       const SwapOptions& options) {
    constexpr std::size_t slots_per_piece = 16384;
    std::vector<std::vector<ElementId>> pieces(mesh.slot_count() / slots_per_piece + 1);
    parallel_for(mesh.slot_count(), slots_per_piece, [&](std::size_t begin, std::size_t end) {
        CoarseningRules<D> rules(mesh, input, options.size_floor, 0);
        for (std::size_t i = begin; i < end; ++i) {
            const ElementId e(i);
            if (input.partitions.empty() ||
                (!mesh.is_free(e) && !mesh.is_ghost(e) && rules.quality(e) < options.below &&
                 ChangeTimes::has_edge(input.notes.changes.changed_corners(
                     mesh.nodes(e), input.notes.element_tried[i])))) {
                pieces[begin / slots_per_piece].push_back(e);
            }
        }
    });
    std::vector<ElementId> bad;
    for (const std::vector<ElementId>& piece : pieces) {
        bad.insert(bad.end(), piece.begin(), piece.end());
    }
    return bad;
}

} // namespace

template <int D>
void swap_bad_elements(EditMesh<D>& mesh, const SwapInput<D>& input, const SwapOptions& options,
                       const SurfaceRules& surface, VerdictCounts& verdicts, Monitor& monitor) {
    SwapOptions tried = options;
    for (int round = 0; round < options.rounds; ++round) {
        const std::int64_t before = verdicts[Verdict::accepted];
        SwapRound<D> work{mesh, input, tried, surface};
        MonitorPart part(monitor, static_cast<double>(round) / options.rounds,
                         (round + 1.0) / options.rounds);
        work_in_patches(elements_to_try(mesh, input, tried), input.partitions, work, verdicts,
                        "swapping", part);
        if (verdicts[Verdict::accepted] == before || monitor.stop_requested()) {
            break;
        }
        tried.below = options.below * options.below_again;
    }
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template void swap_bad_elements(EditMesh<D>&, const SwapInput<D>&, const SwapOptions&,         \
                                    const SurfaceRules&, VerdictCounts&, Monitor&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
