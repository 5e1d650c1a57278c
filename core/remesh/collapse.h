// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Removal of a node: its ball is starred from a neighbour.
#pragma once

#include "core/remesh/cavity.h"
#include "core/remesh/surface_rules.h"

namespace ameco {

/// The edge along which a node leaves.
struct Collapse {
    NodeId removed;
    NodeId kept;
};

/// Quality that a collapse must leave behind: at least `floor`, or `share` of what was there.
struct QualityFloor {
    double floor = 0.1; ///< size quality [-]
    double share = 0.6;
};

/// Whether the geometry allows the collapse: corners stay, ridge nodes leave along their ridge,
/// nodes of a patch along the boundary.
template <int D>
[[nodiscard]] Verdict allowed_by_geometry(const EditMesh<D>& mesh, Collapse collapse);

/// Stars the ball of `collapse.removed` (gathered in `ball`) from `collapse.kept` and judges it:
/// geometry, orientations, size quality, boundary. `star` holds the proposal when accepted.
/// \param short_size  natural short size h_1 at the removed node [L]
template <int D>
[[nodiscard]] Verdict propose_collapse(const EditMesh<D>& mesh, const SizeField<D>& sizes,
                                       const SurfaceRules& surface, const QualityFloor& quality,
                                       double short_size, Collapse collapse, const Cavity<D>& ball,
                                       Star<D>& star);

/// Judges the boundary that a star of the ball of `collapse.removed`, a node of it, leaves.
/// \param short_size  h_1 at the removed node [L]
template <int D>
[[nodiscard]] Verdict judge_collapsed_boundary(const EditMesh<D>& mesh, const SurfaceRules& surface,
                                               double short_size, Collapse collapse,
                                               const Cavity<D>& ball, Star<D>& star);

/// Carries out a collapse that was accepted.
/// \param lane  of the mesh, see EditMesh::open_lanes; while several are open no ridge node may go
/// \return  slots of the star's elements, until the next edit
template <int D>
std::span<const ElementId> apply_collapse(EditMesh<D>& mesh, Collapse collapse,
                                          const Cavity<D>& ball, const Star<D>& star,
                                          std::size_t lane = 0);

} // namespace ameco
