// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The elements that share an edge with one.
#pragma once

#include "core/mesh/simplex.h"
#include "core/remesh/edit_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ameco {

/// The elements at the edges of one element, itself and ghost elements among them, by its corners:
/// found in one walk through the balls of its nodes, where the shells of its edges, the elements
/// behind its faces and the patch they lie in can be read off.
///
/// A swap is the matter of the worst element in its cavity. Edges where another one is worse are
/// closed, and the walk goes only as far as there are open ones.
template <int D>
class EdgeNeighbours {
public:
    struct Neighbour {
        ElementId element;
        std::uint8_t shared = 0; ///< bit i: it has corner i
    };

    /// \param corners   as bits, two at least: edges and faces with other corners are left out
    /// \param is_worse  whether an element closes its edges; asked of all elements at open edges
    ///                  and behind faces
    template <class Worse>
    void find(const EditMesh<D>& mesh, ElementId e, unsigned corners, const Worse& is_worse) {
        const Simplex<D>& s = mesh.nodes(e);
        corners_ = corners;
        const int wanted = sort_corners(mesh, s);
        if (corner_.size() < mesh.node_count()) {
            corner_.resize(mesh.node_count(), 0);
        }
        for (int i = 0; i <= D; ++i) {
            corner_[s[i]] = static_cast<std::uint8_t>(1U << i);
            at_[i].clear();
        }
        closed_ = all_edges & ~edges_between[corners & all_corners];
        for (int k = 0; k + 1 < wanted; ++k) {
            // Behind two corners there is only the edge between the two last ones.
            if (k < 2 || is_open(order_[D - 1], order_[D])) {
                walk_ball(mesh, s, order_[k], is_worse);
            }
        }
        for (const NodeId v : s) {
            corner_[v] = 0;
        }
    }

    /// Whether an edge between two corners is wanted, and no element at it is worse.
    [[nodiscard]] bool is_open(int i, int j) const {
        return (closed_ >> edge_number(i, j) & 1U) == 0;
    }

    /// Those at corner i, in the order of its ball. None at corners that were not needed: an open
    /// edge has another end.
    [[nodiscard]] const std::vector<Neighbour>& at(int i) const { return at_[i]; }

    /// The end of an open edge whose ball was walked, the smaller one.
    [[nodiscard]] int quicker_end(int i, int j) const { return rank_[j] < rank_[i] ? j : i; }

    /// Whether the facet opposite corner i is wanted.
    [[nodiscard]] bool has_facet(int i) const {
        return ((corners_ | 1U << i) & all_corners) == all_corners;
    }

    /// The element behind the facet opposite corner i, which is wanted; none at the end of the
    /// mesh.
    [[nodiscard]] ElementId behind(int i) const {
        for (const Neighbour& n : at_[order_[0] == i ? order_[1] : order_[0]]) {
            if (n.shared == (all_corners ^ (1U << i))) {
                return n.element;
            }
        }
        return {};
    }

private:
    /// Those that are wanted by the size of their balls, of equal ones the first first; then the
    /// others.
    /// \return  how many are wanted
    int sort_corners(const EditMesh<D>& mesh, const Simplex<D>& s) {
        int wanted = 0, others = D;
        for (int i = 0; i <= D; ++i) {
            if ((corners_ >> i & 1U) == 0) {
                order_[others--] = i;
                continue;
            }
            int k = wanted++;
            for (; k > 0 && mesh.ball(s[i]).size() < mesh.ball(s[order_[k - 1]]).size(); --k) {
                order_[k] = order_[k - 1];
            }
            order_[k] = i;
        }
        for (int k = 0; k <= D; ++k) {
            rank_[order_[k]] = k;
        }
        return wanted;
    }

    template <class Worse>
    void walk_ball(const EditMesh<D>& mesh, const Simplex<D>& s, int i, const Worse& is_worse) {
        for (const ElementId f : mesh.ball(s[i])) {
            const unsigned shared = shared_corners(mesh, mesh.nodes(f));
            if ((shared & (shared - 1)) == 0) { // one corner only
                continue;
            }
            at_[i].push_back({f, static_cast<std::uint8_t>(shared)});
            const unsigned edges = edges_between[shared];
            const bool has_facet = edges_between[shared & (shared - 1)] != 0;
            if (((edges & ~closed_) != 0 || has_facet) && is_worse(f)) {
                closed_ |= edges;
            }
        }
    }

    unsigned shared_corners(const EditMesh<D>& mesh, const Simplex<D>& other) const {
        unsigned shared = other[D] == mesh.ghost() ? 0 : corner_[other[D]];
        for (int k = 0; k < D; ++k) {
            shared |= corner_[other[k]];
        }
        return shared;
    }

    static constexpr unsigned all_corners = (1U << (D + 1)) - 1;
    static constexpr unsigned all_edges = (1U << SimplexNumbering<D>::edge_count) - 1;

    static constexpr int edge_number(int i, int j) {
        constexpr auto edges = SimplexNumbering<D>::edges;
        int number = 0;
        while (!(edges[number][0] == i && edges[number][1] == j) &&
               !(edges[number][0] == j && edges[number][1] == i)) {
            ++number;
        }
        return number;
    }

    /// Edges whose ends are both in a set of corners, as bits.
    static constexpr std::array<std::uint8_t, 1U << (D + 1)> edges_between = [] {
        std::array<std::uint8_t, 1U << (D + 1)> sets{};
        for (unsigned corners = 0; corners < sets.size(); ++corners) {
            for (int k = 0; k < SimplexNumbering<D>::edge_count; ++k) {
                const auto [i, j] = SimplexNumbering<D>::edges[k];
                if ((corners >> i & 1U) != 0 && (corners >> j & 1U) != 0) {
                    sets[corners] |= static_cast<std::uint8_t>(1U << k);
                }
            }
        }
        return sets;
    }();

    IdVector<NodeId, std::uint8_t> corner_; ///< of the element being looked at, as bits; 0: none
    std::array<std::vector<Neighbour>, D + 1> at_;
    std::array<int, D + 1> order_{}, rank_{}; ///< of the corners, see `sort_corners`
    unsigned corners_ = 0;                    ///< that are wanted, as bits
    unsigned closed_ = 0;                     ///< edges, as bits
};

} // namespace ameco
