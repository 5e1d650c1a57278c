// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/remesh/swap.h"

#include <algorithm>

namespace ameco {
namespace {

/// The rules of swaps while a mesh is coarsened, with what they remember of each element.
template <int D>
class CoarseningRules {
public:
    CoarseningRules(EditMesh<D>& mesh, const SwapInput<D>& input, const SwapOptions& options)
        : mesh_(mesh), in_(input), options_(options), tried_(mesh.slot_count(), 0),
          quality_(mesh.slot_count(), -1) {}

    /// Computed once until the element changes.
    double quality(ElementId e) {
        float& known = quality_[e.index()];
        if (known < 0) {
            known = static_cast<float>(quality(mesh_.nodes(e)));
        }
        return static_cast<double>(known);
    }
    double quality(const Simplex<D>& s) const { return metric_quality(mesh_, in_.root, s); }
    double short_size(NodeId v) const { return static_cast<double>(in_.short_size[v]); }

    void look_at(const Cavity<D>& cavity) {
        size_before_ = worst_quality(mesh_, cavity);
        lineless_before_ = 0;
        for (const ElementId e : cavity.elements) {
            lineless_before_ += lineless(mesh_.nodes(e));
        }
    }

    Verdict judge(const Cavity<D>& cavity, Star<D>& star) {
        int lineless_after = 0;
        for (const EditElement<D>& e : star.elements) {
            lineless_after += lineless(e.nodes);
        }
        if (lineless_after > lineless_before_) {
            return Verdict::breaks_line;
        }
        const Verdict verdict =
            ameco::judge(mesh_, in_.sizes, std::min(options_.size_floor, size_before_), star);
        if (verdict == Verdict::accepted && !in_.removed.interpolated_well(mesh_, cavity, star)) {
            return Verdict::weak_coupling;
        }
        return verdict;
    }

    void make(const Cavity<D>& cavity, const Star<D>& star) {
        // Other proposals may have been looked at since this one was found.
        (void)in_.removed.interpolated_well(mesh_, cavity, star);
        const auto slots = mesh_.replace(cavity.elements, star.elements, star.sources);
        in_.removed.move(cavity.elements, slots);
        forget(star, slots);
    }

    /// Whether no swap was found at the element, and all around it is as it was then.
    bool failed_before(ElementId e) const { return tried_[e.index()] != 0; }
    void set_failed(ElementId e) { tried_[e.index()] = 1; }

private:
    int lineless(const Simplex<D>& s) const {
        return s[D] != mesh_.ghost() && is_lineless<D>(in_.lines, s) ? 1 : 0;
    }

    /// After a change: qualities of the new elements are not known, and what failed beside them may
    /// succeed now.
    void forget(const Star<D>& star, std::span<const ElementId> slots) {
        tried_.resize(mesh_.slot_count(), 0);
        quality_.resize(mesh_.slot_count(), -1);
        for (const ElementId e : slots) {
            quality_[e.index()] = -1;
        }
        for (const EditElement<D>& fresh : star.elements) {
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

    EditMesh<D>& mesh_;
    const SwapInput<D>& in_;
    const SwapOptions& options_;
    double size_before_ = 1;
    int lineless_before_ = 0;
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
    CoarseningRules<D> rules(mesh, input, options);
    SwapSearch<D, CoarseningRules<D>> search(mesh, rules, options, surface, verdicts);
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
            if (mesh.is_free(e) || mesh.is_ghost(e) || rules.failed_before(e) ||
                rules.quality(e) >= options.below) {
                continue;
            }
            if (search.mend(e)) {
                ++made;
            } else {
                rules.set_failed(e);
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
