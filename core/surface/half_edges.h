// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A surface as a half-edge mesh: who is beside whom, in constant time.
#pragma once

#include "core/mesh/mesh.h"

#include <array>
#include <memory>
#include <vector>

namespace ameco {

/// The connectivity of a manifold surface, kept by OpenMesh. Points stay in the mesh it was made
/// from: node and face numbers are the same.
class HalfEdges {
public:
    /// \throws InputError  the faces at some edge or node are no disc: `inspect_surface` names them
    explicit HalfEdges(const Mesh<3>& mesh);
    ~HalfEdges();
    HalfEdges(HalfEdges&&) noexcept;
    HalfEdges& operator=(HalfEdges&&) noexcept;

    /// The faces around a node, counter-clockwise seen from outside, beginning with the one of the
    /// smallest number; at an open border from one end to the other.
    [[nodiscard]] std::vector<FaceId> faces_around(NodeId v) const;

    /// The nodes around a node, likewise.
    [[nodiscard]] std::vector<NodeId> nodes_around(NodeId v) const;

    /// The face beyond the edge opposite node `k` of face `f`; none at an open border.
    [[nodiscard]] FaceId face_beyond(FaceId f, int k) const;

private:
    struct Connectivity;
    std::unique_ptr<Connectivity> connectivity_;
    const Mesh<3>* mesh_;
};

} // namespace ameco
