// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The best edge or face swap at an element: the search, whatever a swap is judged by.
#pragma once

#include "core/mesh/simplex.h"
#include "core/remesh/edge_neighbours.h"
#include "core/remesh/edge_shell.h"

#include <algorithm>
#include <vector>

namespace ameco {

struct SwapOptions {
    double below = 0.6;             ///< elements of a quality below this are tried [-]
    double gain = 1.02;             ///< the worst quality must grow by this factor [-]
    double size_floor = 0.1;        ///< the size quality must stay above this or not fall [-]
    std::size_t largest_shell = 10; ///< elements around an edge that is swapped
    int rounds = 3;                 ///< over the elements, at most
    double below_again = 1; ///< share of `below` that counts after the first round [-]: what the
                            ///< swaps of others have made possible matters to the worst only
};

/// Tries the swaps at an element: the shells of its edges, each starred from a node of its ring,
/// and the pairs at its faces, where it is the worst one in them. The swap that leaves the best
/// worst quality is made.
///
/// Rules say what quality is and what else is asked of a swap:
///
///     double quality(ElementId e);                    // of an element as it stands
///     double quality(const Simplex<D>& s, double least); // of one that may come: exact only
///                                                        // where it is above `least`
///     void look_at(const Cavity<D>&);                 // before the first of its stars is judged
///     Verdict judge(const Cavity<D>&, Star<D>&);      // once the worst quality is good enough
///     double short_size(NodeId v);                    // for the rules of the boundary [L]
///     void make(const Cavity<D>&, const Star<D>&);    // replaces the one with the other
template <int D, class Rules>
class SwapSearch {
public:
    SwapSearch(const EditMesh<D>& mesh, Rules& rules, const SwapOptions& options,
               const SurfaceRules& surface, VerdictCounts& verdicts)
        : mesh_(mesh), rules_(rules), options_(options), surface_(surface), verdicts_(verdicts) {}

    /// Tries the swaps at one element; true if one was made.
    /// \param around  of the element; edges are closed by elements of less quality
    bool mend(ElementId e, const EdgeNeighbours<D>& around) {
        element_ = e;
        best_quality_ = 0;
        best_verdict_ = Verdict::no_improvement;
        for (const auto& [i, j] : SimplexNumbering<D>::edges) {
            try_edge(i, j, around);
        }
        if constexpr (D == 3) {
            for (int i = 0; i <= D; ++i) {
                if (around.has_facet(i)) {
                    try_face(i, around.behind(i));
                }
            }
        }
        verdicts_.add(best_quality_ > 0 ? Verdict::accepted : best_verdict_);
        if (best_quality_ == 0) {
            return false;
        }
        rules_.make(best_cavity_, best_star_);
        return true;
    }

private:
    /// The edge between two corners of the element.
    void try_edge(int i, int j, const EdgeNeighbours<D>& around) {
        if (!around.is_open(i, j)) {
            return; // nothing new, or the matter of a worse element
        }
        gather_elements(i, j, around);
        if (shell_.size() > options_.largest_shell) {
            note(Verdict::cavity_too_large);
            return;
        }
        const NodeId a = mesh_.nodes(element_)[i], b = mesh_.nodes(element_)[j];
        gather_shell(mesh_, a, b, shell_, cavity_);
        const Verdict allowed = allowed_to_leave(mesh_, a, b, cavity_);
        if (allowed != Verdict::accepted) {
            note(allowed);
            return;
        }
        shell_ring(mesh_, a, b, cavity_, ring_);
        drop_equal_stars(mesh_, cavity_, ring_);
        try_stars(ring_);
    }

    /// The elements at an edge between two corners.
    void gather_elements(int i, int j, const EdgeNeighbours<D>& around) {
        const int end = around.quicker_end(i, j), other = i + j - end;
        shell_.clear();
        for (const auto& n : around.at(end)) {
            if ((n.shared >> other & 1) != 0) {
                shell_.push_back(n.element);
            }
        }
    }

    /// The face opposite corner i: 2 elements become 3 around the edge to the node behind.
    void try_face(int i, ElementId behind) {
        if (!behind.valid() || mesh_.is_ghost(behind) ||
            rules_.quality(behind) < rules_.quality(element_)) {
            return;
        }
        gather_pair(mesh_, element_, behind, cavity_);
        if (protected_inside(facet_of<D>(mesh_.nodes(element_), i)) ||
            !has_one_label(mesh_, cavity_)) {
            note(Verdict::region_border);
            return;
        }
        ring_.assign(1, mesh_.nodes(element_)[i]);
        try_stars(ring_);
    }

    void try_stars(const std::vector<NodeId>& nodes) {
        seen_ = false;
        const double needed = rules_.quality(element_) * options_.gain;
        for (const NodeId node : nodes) {
            const Verdict verdict = judge_star(node, std::max(needed, best_quality_));
            if (verdict == Verdict::accepted) {
                std::swap(best_star_, star_);
                best_cavity_ = cavity_;
            } else {
                note(verdict);
            }
        }
    }

    /// Builds and judges the star of the cavity from `node`; when accepted, best_quality_ is its.
    Verdict judge_star(NodeId node, double needed) {
        double worst = 1;
        for (const Facet<D>& facet : cavity_.facets) {
            if (std::find(facet.begin(), facet.end(), node) == facet.end()) {
                const Simplex<D> joined = join_facet<D>(facet, node, mesh_.ghost());
                if (joined[D] != mesh_.ghost()) {
                    worst = std::min(worst, rules_.quality(joined, needed));
                    if (worst <= needed) {
                        return Verdict::no_improvement;
                    }
                }
            }
        }
        join_star(mesh_, cavity_, node, star_);
        // Exact signs cost more than the quality, which is 0 where they are clearly wrong.
        Verdict verdict = test_star(mesh_, star_);
        if (verdict == Verdict::accepted) {
            verdict = judge_swapped_boundary(mesh_, surface_, rules_.short_size(node), cavity_,
                                             node, star_);
        }
        if (verdict == Verdict::accepted) {
            if (!seen_) { // most cavities have no star that comes so far
                rules_.look_at(cavity_);
                seen_ = true;
            }
            verdict = rules_.judge(cavity_, star_);
        }
        if (verdict == Verdict::accepted) {
            best_quality_ = worst;
        }
        return verdict;
    }

    /// Faces inside the domain, and those of required elements, have frozen nodes only.
    bool protected_inside(const Facet<D>& face) const {
        return mesh_.has_protected_inside() && std::all_of(face.begin(), face.end(), [&](NodeId v) {
                   return mesh_.node_class(v) == NodeClass::frozen;
               });
    }

    void note(Verdict verdict) {
        if (best_verdict_ == Verdict::no_improvement) {
            best_verdict_ = verdict;
        }
    }

    const EditMesh<D>& mesh_;
    Rules& rules_;
    const SwapOptions& options_;
    const SurfaceRules& surface_;
    VerdictCounts& verdicts_;
    Cavity<D> cavity_, best_cavity_;
    Star<D> star_, best_star_;
    std::vector<ElementId> shell_;
    std::vector<NodeId> ring_;
    ElementId element_;
    bool seen_ = false; ///< the cavity, by the rules
    double best_quality_ = 0;
    Verdict best_verdict_ = Verdict::no_improvement;
};

} // namespace ameco
