// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What swaps must obey while a mesh is coarsened, whatever they are made for, and what all edits
/// of it keep up to date.
#pragma once

#include "core/remesh/stiffness_diagonal.h"
#include "core/remesh/swap_input.h"

#include <algorithm>

namespace ameco {

/// Whether all nodes of an element are on lines, but no two follow each other on one.
template <int D>
[[nodiscard]] bool is_lineless(const Lines& lines, const Simplex<D>& element);

/// Lets as many workers edit a mesh side by side as there are lanes.
template <int D>
void open_lanes(EditMesh<D>& mesh, RemovedNodes<D>& removed, EditNotes& notes, std::size_t lanes) {
    mesh.open_lanes(lanes);
    removed.open_lanes(lanes, mesh.slot_count());
    notes.open_lanes(lanes, mesh.slot_count());
}

/// The rules of swaps while a mesh is coarsened.
///
/// No swap may raise the number of layer elements without an edge along a line (all nodes on lines,
/// none linked): such elements couple columns diagonally, and multigrid diverges on them. Removed
/// nodes must stay well interpolated, and the size quality (`size_quality.h`) above a floor or not
/// fall. No node may become soft: where layers are bent by more than their height, well shaped
/// elements can cut across them, and hardly see the short edges that the fine mesh has.
template <int D>
class CoarseningRules {
public:
    CoarseningRules(EditMesh<D>& mesh, const SwapInput<D>& input, double size_floor,
                    std::size_t lane)
        : mesh_(mesh), in_(input), size_floor_(size_floor), lane_(lane) {}

    /// Computed once until the element changes.
    double quality(ElementId e) {
        float& known = in_.notes.quality[e.index()];
        if (known < 0) {
            known = static_cast<float>(metric_quality(mesh_, in_.root, mesh_.nodes(e)));
        }
        return static_cast<double>(known);
    }
    double quality(const Simplex<D>& s, double least) const {
        return metric_quality_above(mesh_, in_.root, s, least);
    }
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
            ameco::judge(mesh_, in_.sizes, std::min(size_floor_, size_before_), star);
        if (verdict == Verdict::accepted &&
            !in_.removed.interpolated_well(mesh_, cavity, star, {}, lane_)) {
            return Verdict::weak_coupling;
        }
        return verdict == Verdict::accepted && softens(cavity, star) ? Verdict::soft_element
                                                                     : verdict;
    }

    void make(const Cavity<D>& cavity, const Star<D>& star) {
        // Other proposals may have been looked at since this one was found.
        (void)in_.removed.interpolated_well(mesh_, cavity, star, {}, lane_);
        const auto in = mesh_.replace(cavity.elements, star.elements, star.sources, lane_);
        in_.removed.move(cavity.elements, in, lane_);
        in_.notes.replaced(in, star.elements, mesh_, lane_);
    }

private:
    /// Whether a_vv of a node falls below a share of what the fine mesh gives it.
    bool softens(const Cavity<D>& cavity, const Star<D>& star) {
        if (in_.least_stiffness == 0) {
            return false;
        }
        before_.clear();
        after_.clear();
        for (const ElementId e : cavity.elements) {
            if (!mesh_.is_ghost(e)) {
                before_.add(mesh_, mesh_.nodes(e));
            }
        }
        for (const EditElement<D>& e : star.elements) {
            if (e.nodes[D] != mesh_.ghost()) {
                after_.add(mesh_, e.nodes);
            }
        }
        return std::any_of(after_.parts().begin(), after_.parts().end(), [&](const auto& after) {
            const double before = before_[after.node];
            const double least = in_.least_stiffness * in_.removed.fine_diagonal(after.node);
            return after.sum < before && after.sum < least &&
                   !reaches(after.node, least + before - after.sum);
        });
    }

    /// Whether a_vv of the mesh as it stands comes up to a value.
    bool reaches(NodeId v, double value) const {
        double sum = 0;
        for (const ElementId e : mesh_.ball(v)) {
            if (!mesh_.is_ghost(e)) {
                const Simplex<D>& s = mesh_.nodes(e);
                const auto corner = std::find(s.begin(), s.end(), v) - s.begin();
                sum += stiffness(mesh_, s)[static_cast<std::size_t>(corner)];
            }
            if (sum >= value) {
                return true;
            }
        }
        return false;
    }

    int lineless(const Simplex<D>& s) const {
        return s[D] != mesh_.ghost() && is_lineless<D>(in_.lines, s) ? 1 : 0;
    }

    EditMesh<D>& mesh_;
    const SwapInput<D>& in_;
    double size_floor_;
    double size_before_ = 1;
    int lineless_before_ = 0;
    std::size_t lane_; ///< of the mesh
    StiffnessDiagonal<D> before_, after_;
};

} // namespace ameco
