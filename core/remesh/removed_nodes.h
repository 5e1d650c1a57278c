// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Where the removed nodes lie in the mesh being edited, and how well it interpolates there.
#pragma once

#include "core/remesh/cavity.h"
#include "core/remesh/couplings.h"

#include <algorithm>
#include <span>
#include <vector>

namespace ameco {

/// What the interpolation of node v from `nodes` with `weights` misses, as a multiple of the
/// error's energy; with conductances g_vi between v and i over one coupling or two
/// (c_vu c_ui / (c_vu + c_ui)):
///
///     K_v = a_vv sum_i w_i^2 / g_vi
///
/// since (sum w_i (e_v - e_i))^2 <= (sum w_i^2 / g_vi) (sum g_vi (e_v - e_i)^2), and the second sum
/// is the energy of the ways from v (one that several ways share is counted for each). 1 on a line
/// across layers. Ways over three couplings or more count as g = 0.02 a_vv.
///
/// The square lets small weights of far nodes do no harm. With w_i instead, a node at 1/20 of the
/// height of its element would be refused for the twentieth that it takes from above.
///
/// Negative couplings are left out, and with them what they take away: in needles the couplings
/// along the needle look strong, and those with the diagonals beside cancel them.
/// \param most  largest g_vi that is believed, over a_vv, one per node; empty: all are
[[nodiscard]] double interpolation_constant(const Couplings& couplings, NodeId v,
                                            std::span<const NodeId> nodes,
                                            std::span<const double> weights,
                                            std::span<const double> most = {});

/// In how many directions each node is to be coarsened, n = sum log2(h'_i / h_i): 1 in a layer, D
/// where all sizes double.
template <int D>
[[nodiscard]] IdVector<NodeId, float> coarsened_directions(const MetricField<D>& natural,
                                                           const MetricField<D>& target);

/// 0 where one direction or none is coarsened, 1 where all are: (n - 1) / (D - 1).
template <int D>
[[nodiscard]] double isotropy(float directions) {
    return std::clamp((static_cast<double>(directions) - 1) / (D - 1), 0.0, 1.0);
}

/// How large the interpolation constant of a removed node may become. It grows with the number of
/// directions that are coarsened: 1 in an ideal layer (n = 1), more in isotropic meshes (n = D).
/// There a node whose neighbours all leave is reached over three couplings, which K overstates:
/// least conductances count in full, though many ways run side by side.
struct InterpolationBound {
    double layer = 2;         ///< bound where one direction is coarsened [-]
    double per_direction = 1; ///< added for each further one [-]
    double isotropic = 6;     ///< added times the square of the isotropy [-]
    double held = 0.5;        ///< taken off where one neighbour has 40 % of a node's coupling or
                              ///< more: such nodes must be interpolated along it [-]
    double late = 1.5;        ///< times the bound without `held`: for a node of a line that stayed
                              ///< in the first pass, above a wall that has moved or as the last of
                              ///< its layer [-]
};

/// The bound of a node that no single neighbour holds.
/// \param directions  its entry of `coarsened_directions`
template <int D>
[[nodiscard]] double interpolation_bound(float directions, const InterpolationBound& bound);

/// The bound of each node.
/// \param couplings   of the mesh before any removal
/// \param directions  `coarsened_directions`
template <int D>
[[nodiscard]] IdVector<NodeId, float>
interpolation_bounds(const Couplings& couplings, const IdVector<NodeId, float>& directions,
                     const InterpolationBound& bound);

/// A node that is to leave, and what its interpolation constant may be if that is more than its
/// bound.
struct Leaving {
    NodeId node;
    double most = 0;
};

/// The removed nodes, each in the element that holds it, carried along as the mesh is edited.
///
/// A removed node gets its value from the nodes of its element, see `interpolation_constant`. An
/// edit that raises K of a node above its bound is refused, be it collapse or swap: this keeps
/// edges of the coarse mesh along the strong couplings of the fine one, on lines and off them.
///
/// An error with gradient g differs by g d between nodes at a distance d, and a_vv is that of an
/// element of height h_1: no conductance counts for more than 2 (h_1 / d)^2 a_vv. Nodes are so not
/// interpolated along needles.
///
/// Nodes of the boundary are left out: other nodes of the boundary interpolate them, whatever they
/// are coupled with.
/// \see docs/theory/multigrid.md
template <int D>
class RemovedNodes {
public:
    /// \param couplings  of the mesh before any removal; must outlive this
    /// \param bounds     largest K of each node [-]
    /// \param short_size  natural h_1 of each node [L]; empty: couplings alone decide
    RemovedNodes(const Couplings& couplings, IdVector<NodeId, float> bounds,
                 IdVector<NodeId, float> short_size = {});

    /// Whether filling the cavity with the star leaves the removed nodes in it, and the leaving one
    /// (where valid) with them, in elements that interpolate them well enough: K at most the bound,
    /// or not above what it was. Remembers where they go, for `move` with the same lane.
    [[nodiscard]] bool interpolated_well(const EditMesh<D>& mesh, const Cavity<D>& cavity,
                                         const Star<D>& star, Leaving leaving = {},
                                         std::size_t lane = 0);

    /// Moves the nodes as found by the last `interpolated_well`. To be called when the edit has
    /// been made; `slots` are those of the star's elements, `old` those of the cavity.
    void move(std::span<const ElementId> old, std::span<const ElementId> slots,
              std::size_t lane = 0);

    /// Lets as many threads work at a time, on the same terms as EditMesh::open_lanes.
    /// \param slots  of the mesh; no more while several lanes are open
    void open_lanes(std::size_t count, std::size_t slots);

    /// The Laplacian's a_vv in the mesh before any removal [L^(D-2)].
    [[nodiscard]] double fine_diagonal(NodeId v) const {
        return static_cast<double>(couplings_.diagonal[v]);
    }

    /// Interpolation constant of a removed node inside the domain, where it is now; 0 of others.
    [[nodiscard]] double constant(NodeId v) const { return static_cast<double>(constant_[v]); }

private:
    struct Place {
        NodeId node;
        std::size_t element; ///< of the star
        float constant;
    };
    /// Where the nodes of a cavity go; apart from those of other lanes in memory.
    struct alignas(64) Places {
        std::vector<Place> of;
    };
    [[nodiscard]] Place locate(const EditMesh<D>& mesh, const Star<D>& star, NodeId v) const;
    /// Most conductance between v and w, over a_vv.
    [[nodiscard]] double conductance_limit(const EditMesh<D>& mesh, NodeId v, NodeId w) const;

    const Couplings& couplings_;
    IdVector<NodeId, float> bounds_;
    IdVector<NodeId, float> short_size_;
    IdVector<ElementId, NodeId> first_; ///< [slots] first removed node in an element
    IdVector<NodeId, NodeId> next_;     ///< the next one in the same element
    IdVector<NodeId, float> constant_;  ///< K, where the node is now
    std::vector<Places> places_{1};     ///< [lanes]
};

} // namespace ameco
