// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The best edge or face swap at an element: the search, whatever a swap is judged by.
#pragma once

#include "core/mesh/simplex.h"
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
};

/// Tries the swaps at an element: the shells of its edges, each starred from a node of its ring,
/// and the pairs at its faces, where it is the worst one in them. The swap that leaves the best
/// worst quality is made.
///
/// Rules say what quality is and what else is asked of a swap:
///
///     double quality(ElementId e);                    // of an element as it stands
///     double quality(const Simplex<D>& s);            // of one that may come
///     void look_at(const Cavity<D>&);                 // before its stars are judged
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
    bool mend(ElementId e) {
        element_ = e;
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
            return false;
        }
        rules_.make(best_cavity_, best_star_);
        return true;
    }

private:
    void try_edge(NodeId a, NodeId b) {
        if (!is_worst_at(a, b)) {
            return; // this shell is the matter of a worse element
        }
        gather_shell(mesh_, a, b, cavity_);
        if (cavity_.elements.size() > options_.largest_shell) {
            note(Verdict::cavity_too_large);
            return;
        }
        const Verdict allowed = allowed_to_leave(mesh_, a, b, cavity_);
        if (allowed != Verdict::accepted) {
            note(allowed);
            return;
        }
        shell_ring(mesh_, a, b, cavity_, ring_);
        try_stars(ring_);
    }

    /// Whether no element at the edge is worse than the one that is to be mended.
    bool is_worst_at(NodeId a, NodeId b) {
        const bool fewer = mesh_.ball(a).size() < mesh_.ball(b).size();
        const double quality = rules_.quality(element_);
        const auto ball = mesh_.ball(fewer ? a : b);
        return std::none_of(ball.begin(), ball.end(), [&](ElementId e) {
            return !mesh_.is_ghost(e) && has(mesh_.nodes(e), fewer ? b : a) &&
                   rules_.quality(e) < quality;
        });
    }

    /// The face of `e` opposite `v`: 2 elements become 3 around the edge to the node behind.
    void try_face(ElementId e, NodeId v) {
        const ElementId behind = neighbour(e, v);
        if (!behind.valid() || mesh_.is_ghost(behind)) {
            return;
        }
        const Simplex<D>& s = mesh_.nodes(e);
        Facet<D> face;
        std::copy_if(s.begin(), s.end(), face.begin(), [&](NodeId w) { return w != v; });
        if (rules_.quality(behind) < rules_.quality(e)) {
            return;
        }
        gather_pair(mesh_, e, behind, cavity_);
        if (protected_inside(face) || !has_one_label(mesh_, cavity_)) {
            note(Verdict::region_border);
            return;
        }
        ring_.assign(1, v);
        try_stars(ring_);
    }

    void try_stars(const std::vector<NodeId>& nodes) {
        rules_.look_at(cavity_);
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
        join_star(mesh_, cavity_, node, star_);
        double worst = 1;
        for (const EditElement<D>& e : star_.elements) {
            if (e.nodes[D] != mesh_.ghost()) {
                worst = std::min(worst, rules_.quality(e.nodes));
                if (worst <= needed) {
                    return Verdict::no_improvement;
                }
            }
        }
        // Exact signs cost more than the quality, which is 0 where they are clearly wrong.
        Verdict verdict = test_star(mesh_, star_);
        if (verdict == Verdict::accepted) {
            verdict = judge_swapped_boundary(mesh_, surface_, rules_.short_size(node), cavity_,
                                             node, star_);
        }
        if (verdict == Verdict::accepted) {
            verdict = rules_.judge(cavity_, star_);
        }
        if (verdict == Verdict::accepted) {
            best_quality_ = worst;
        }
        return verdict;
    }

    static bool has(const Simplex<D>& s, NodeId v) {
        return std::find(s.begin(), s.end(), v) != s.end();
    }

    /// Faces inside the domain, and those of required elements, have frozen nodes only.
    bool protected_inside(const Facet<D>& face) const {
        return mesh_.has_protected_inside() && std::all_of(face.begin(), face.end(), [&](NodeId v) {
                   return mesh_.node_class(v) == NodeClass::frozen;
               });
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

    const EditMesh<D>& mesh_;
    Rules& rules_;
    const SwapOptions& options_;
    const SurfaceRules& surface_;
    VerdictCounts& verdicts_;
    Cavity<D> cavity_, best_cavity_;
    Star<D> star_, best_star_;
    std::vector<NodeId> ring_;
    ElementId element_;
    double best_quality_ = 0;
    Verdict best_verdict_ = Verdict::no_improvement;
};

} // namespace ameco
