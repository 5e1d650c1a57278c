// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The elements that share an edge with one.
#pragma once

#include "core/remesh/edit_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ameco {

/// The elements at the edges of one element, itself and ghost elements among them, by its corners:
/// found in one walk through the balls of its nodes, where the shells of all its edges, the
/// elements behind its faces and the patch they lie in can be read off.
template <int D>
class EdgeNeighbours {
public:
    struct Neighbour {
        ElementId element;
        std::uint8_t shared = 0; ///< bit i: it has corner i
    };

    /// \param corners  bit i: look at the edges and faces at corner i; others are left out
    void find(const EditMesh<D>& mesh, ElementId e, unsigned corners = ~0U) {
        const Simplex<D>& s = mesh.nodes(e);
        if (corner_.size() < mesh.node_count()) {
            corner_.resize(mesh.node_count(), 0);
        }
        for (int i = 0; i <= D; ++i) {
            corner_[s[i]] = static_cast<std::uint8_t>(1U << i);
        }
        for (int i = 0; i <= D; ++i) {
            ball_size_[i] = mesh.ball(s[i]).size();
            at_[i].clear();
            if ((corners >> i & 1U) == 0) {
                continue;
            }
            for (const ElementId f : mesh.ball(s[i])) {
                const unsigned shared = shared_corners(mesh, mesh.nodes(f));
                if ((shared & (shared - 1)) != 0) { // two at least
                    at_[i].push_back({f, static_cast<std::uint8_t>(shared)});
                }
            }
        }
        for (const NodeId v : s) {
            corner_[v] = 0;
        }
    }

    /// Those at corner i, in the order of its ball.
    [[nodiscard]] const std::vector<Neighbour>& at(int i) const { return at_[i]; }

    /// The end of the edge i, j with the smaller ball: that of i where they are equal.
    [[nodiscard]] int quicker_end(int i, int j) const {
        return ball_size_[j] < ball_size_[i] ? j : i;
    }

    /// The element behind the facet opposite corner i, none if that is at the end of the mesh.
    [[nodiscard]] ElementId behind(int i) const {
        constexpr unsigned all = (1U << (D + 1)) - 1;
        for (const Neighbour& n : at_[i == 0 ? 1 : 0]) {
            if (n.shared == (all ^ (1U << i))) {
                return n.element;
            }
        }
        return {};
    }

private:
    unsigned shared_corners(const EditMesh<D>& mesh, const Simplex<D>& other) const {
        unsigned shared = other[D] == mesh.ghost() ? 0 : corner_[other[D]];
        for (int k = 0; k < D; ++k) {
            shared |= corner_[other[k]];
        }
        return shared;
    }

    IdVector<NodeId, std::uint8_t> corner_; ///< of the element being looked at, as bits; 0: none
    std::array<std::vector<Neighbour>, D + 1> at_;
    std::array<std::size_t, D + 1> ball_size_{};
};

} // namespace ameco
