// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The boundary of a mesh as a mesh of its own.
#pragma once

#include "core/mesh/mesh.h"

namespace ameco {

/// The faces of `mesh` with an element on one side only, or all faces of a surface without
/// elements; with their patches, names and features, and the nodes they use.
/// \param new_id  receives the number of each of the mesh's nodes in the surface, none for nodes
///                inside; may be null
[[nodiscard]] Mesh<3> boundary_surface(const Mesh<3>& mesh,
                                       IdVector<NodeId, NodeId>* new_id = nullptr);

} // namespace ameco
