// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The boundary as it was in the beginning, and how far that of an edited mesh is from it.
#pragma once

#include "core/mesh/boundary_projection.h"
#include "core/remesh/edit_mesh.h"

#include <map>

namespace ameco {

/// The boundary of the mesh that coarsening or adaptation began with. Holds its own copy of it.
/// Reading it from several threads is safe.
template <int D>
class OriginalSurface {
public:
    /// \param faces   those that bound the domain, ascending; \see outer_faces
    /// \param ridges  lines of the boundary that are kept; those between patches are known without
    OriginalSurface(const Mesh<D>& mesh, const std::vector<FaceId>& faces,
                    const std::vector<RidgeEdge>& ridges = {});
    OriginalSurface(const OriginalSurface&) = delete;
    OriginalSurface& operator=(const OriginalSurface&) = delete;

    [[nodiscard]] const Mesh<D>& boundary() const { return boundary_; }
    [[nodiscard]] const BoundaryProjection<D>& projection() const { return projection_; }
    /// Nodes of `boundary()` on the faces of a patch, ascending; none if there is no such patch.
    [[nodiscard]] const std::vector<NodeId>& nodes_of(int patch) const;

private:
    /// A boundary without its elements, and ridges by the numbers of its nodes.
    using RidgedBoundary = std::pair<Mesh<D>, std::vector<Edge>>;
    static RidgedBoundary boundary_of(const Mesh<D>& mesh, const std::vector<FaceId>& faces,
                                      const std::vector<RidgeEdge>& ridges);
    explicit OriginalSurface(RidgedBoundary boundary);

    Mesh<D> boundary_; ///< no elements
    BoundaryProjection<D> projection_;
    std::map<int, std::vector<NodeId>> nodes_of_;
};

/// A distance as ghost elements carry it, rounded up: it stays a bound.
[[nodiscard]] float bound_above(double distance);

/// Largest distance of places on a face from a patch of the original surface [L].
/// \param corners  of the face
template <int D>
[[nodiscard]] double distance_to_original(const std::array<Vec<D>, D>& corners, int patch,
                                          const OriginalSurface<D>& original);

/// Puts measured distances in the place of the bounds that ghost elements carry.
///
/// Operations add up how far each of them may have moved a face (\see judge_surface). Here the
/// distance between the boundary and the original one is measured, both ways and patch by patch:
/// that of places on a face, and that of the original nodes attached to it, because it was the
/// nearest face when they were last looked at. What is measured remains a bound under the
/// operations that follow. Only what they have changed is measured again, as long as the same
/// object is asked.
template <int D>
class BoundaryDistance {
public:
    /// Does nothing where no patch has moved, or the original surface is not known. The result does
    /// not depend on the number of threads.
    void measure(EditMesh<D>& mesh);

private:
    struct Face {
        ElementId ghost;
        std::array<Vec<D>, D> corners;
        bool changed = true; ///< since the last time
        double distance = 0; ///< of places on it [L]
        double attached = 0; ///< of the original nodes attached to it [L]
    };
    struct Attachment {
        ElementId ghost; ///< not valid: none yet
        double distance = 0;
    };
    struct Patch {
        std::vector<Face> faces;             ///< in the order of their ghosts
        std::vector<Attachment> attachments; ///< of OriginalSurface::nodes_of
    };
    using Patches = std::map<int, Patch>;

    [[nodiscard]] static Patches moved_patches(const EditMesh<D>& mesh);
    [[nodiscard]] static Face* find(Patch& patch, ElementId ghost);
    static void measure_faces(const EditMesh<D>& mesh, const OriginalSurface<D>& original,
                              int number, Patch& before, Patch& patch);
    static void attach_nodes(const OriginalSurface<D>& original, int number, Patch& patch);

    Patches patches_; ///< as they were the last time
};

} // namespace ameco
