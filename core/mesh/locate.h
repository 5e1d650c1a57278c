// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Which element of a mesh holds a point.
#pragma once

#include "core/mesh/adjacency.h"
#include "core/mesh/mesh.h"

#include <array>
#include <optional>

namespace ameco {

/// Finds elements by walking from one to the next across the facet that separates it from the
/// point, with exact orientation tests, so that a point is never lost between layers of height 1e-9
/// nor found in two of them. Refers to the mesh, which must outlive it and stay as it is. Reading
/// it from several threads is safe.
template <int D>
class Locator {
public:
    /// \param mesh  valid (mesh/check.h)
    explicit Locator(const Mesh<D>& mesh);

    [[nodiscard]] const Mesh<D>& mesh() const { return mesh_; }
    [[nodiscard]] const NodeElements& balls() const { return balls_; }

    /// The element that holds `p`, its border included, found by a walk that starts in the ball of
    /// `start`. None if the walk ends at the boundary or goes on for too long: then `p` is outside,
    /// or the straight way to it is, and only a search (`BoxTree`) can tell.
    [[nodiscard]] std::optional<ElementId> walk(const Vec<D>& p, NodeId start) const;

    [[nodiscard]] bool contains(ElementId e, const Vec<D>& p) const;

private:
    [[nodiscard]] ElementId step(ElementId at, ElementId before, const Vec<D>& p,
                                 unsigned turn) const;

    const Mesh<D>& mesh_;
    NodeElements balls_;
    IdVector<ElementId, std::array<ElementId, D + 1>> across_; ///< none at the boundary
};

} // namespace ameco
