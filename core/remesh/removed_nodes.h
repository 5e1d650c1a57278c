// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Where the removed nodes lie in the mesh being edited, and how well it interpolates there.
#pragma once

#include "core/remesh/cavity.h"
#include "core/remesh/couplings.h"

#include <array>
#include <span>
#include <vector>

namespace ameco {

/// The removed nodes, each in the element that holds it, carried along as the mesh is edited.
///
/// A removed node gets its value from the nodes of its element. With weights w_i and conductances
/// g_vi between v and i, over one coupling or two (c_vu c_ui / (c_vu + c_ui)), the *interpolation
/// constant*
///
///     K_v = a_vv sum_i w_i / g_vi
///
/// bounds what the interpolation misses of an error by the error's energy, since
/// a_vv (e_v - sum w_i e_i)^2 <= a_vv sum w_i (e_v - e_i)^2; it is 2 on a line across layers. A
/// two-grid cycle converges no better than 1 - 1 / max K allows. An edit that raises K of a node
/// it moves above `bound` is refused, be it collapse or swap: this keeps the edges of the coarse
/// mesh along the strong couplings of the fine one, on lines and off them.
template <int D>
class RemovedNodes {
public:
    /// \param couplings  of the mesh before any removal; must outlive this
    /// \param bound      largest K [-]
    RemovedNodes(const Couplings& couplings, double bound);

    /// Whether filling the cavity with the star leaves the removed nodes in it, and `leaving`
    /// (where valid) with them, in elements that interpolate them well enough: K at most the bound,
    /// or not above what it was. Remembers where they go, for `move`.
    [[nodiscard]] bool interpolated_well(const EditMesh<D>& mesh, const Cavity<D>& cavity,
                                         const Star<D>& star, NodeId leaving = {});

    /// Moves the nodes as found by the last `interpolated_well`. To be called when the edit has
    /// been made; `slots` are those of the star's elements, `old` those of the cavity.
    void move(std::span<const ElementId> old, std::span<const ElementId> slots);

    [[nodiscard]] double constant(NodeId v) const { return static_cast<double>(constant_[v]); }

private:
    struct Place {
        NodeId node;
        std::size_t element; ///< of the star
        float constant;
    };
    [[nodiscard]] Place locate(const EditMesh<D>& mesh, const Star<D>& star, NodeId v) const;
    [[nodiscard]] double constant(NodeId v, const Simplex<D>& element,
                                  const std::array<double, D + 1>& weights) const;

    const Couplings& couplings_;
    double bound_;
    IdVector<ElementId, NodeId> first_; ///< [slots] first removed node in an element
    IdVector<NodeId, NodeId> next_;     ///< the next one in the same element
    IdVector<NodeId, float> constant_;  ///< K, where the node is now
    std::vector<Place> places_;
};

} // namespace ameco
