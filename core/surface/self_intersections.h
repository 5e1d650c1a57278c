// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Faces of a surface that meet where they must not.
#pragma once

#include "core/mesh/mesh.h"

#include <array>
#include <vector>

namespace ameco {

/// Pairs of faces that meet in more than the nodes and the edge they share, in ascending order.
/// Exact for all finite coordinates. Faces without area, and faces on the same nodes as another,
/// are left out: they are defects of their own.
///
/// Pairs whose boxes overlap come from the tree of boxes; each is then decided by CGAL's exact
/// predicates. Faces that share an edge can only meet beyond it when they are folded into one
/// plane; faces that share a node when the opposite edge of one meets the other.
[[nodiscard]] std::vector<std::array<FaceId, 2>> self_intersections(const Mesh<3>& mesh);

} // namespace ameco
