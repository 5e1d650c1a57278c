// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The point of a mesh's boundary nearest to a given point, patch by patch.
#pragma once

#include "core/mesh/box_tree.h"
#include "core/mesh/mesh.h"

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace ameco {

/// A point on a boundary face, as a mean of the face's nodes.
template <int D>
struct BoundaryPoint {
    Facet<D> nodes{};                ///< no valid nodes if there was no face to project on
    std::array<double, D> weights{}; ///< in [0, 1], sum 1
    double distance = 0;             ///< from the point that was projected [L]
};

/// Patches of a node: those of the boundary faces around it, ascending, each once. Empty inside the
/// domain.
template <int D>
[[nodiscard]] IdVector<NodeId, std::vector<int>> node_patches(const Mesh<D>& mesh);

/// Faces that bound the domain; a mesh may list others inside it.
template <int D>
[[nodiscard]] std::vector<FaceId> outer_faces(const Mesh<D>& mesh);

/// Projects points on the boundary of a mesh. Refers to the mesh, which must outlive it and stay as
/// it is. Reading it from several threads is safe.
template <int D>
class BoundaryProjection {
public:
    explicit BoundaryProjection(const Mesh<D>& mesh);
    /// \param faces   those to project on, ascending
    /// \param ridges  edges with ascending nodes that count as lines too where they are inside one
    ///                patch; edges of no such face are left out
    BoundaryProjection(const Mesh<D>& mesh, std::vector<FaceId> faces,
                       const std::vector<Edge>& ridges = {});

    /// The nearest point on any boundary face.
    [[nodiscard]] BoundaryPoint<D> project(const Vec<D>& p) const;

    /// The nearest point of the places that belong to `patches`: faces for one patch, nodes (D = 2)
    /// or edges (D = 3) between the first two for several (more meet in corners, which no
    /// coarsening removes). Where there is no such place, the nearest point of the first patch's
    /// faces, and without those of any face.
    [[nodiscard]] BoundaryPoint<D> project(const Vec<D>& p, const std::vector<int>& patches) const;

    /// Distance from the faces of one patch, or of all where there is none of that number [L].
    /// \param near  a face on which the nearest point may be, and then is: neighbouring points are
    ///              found sooner; -1: none known
    [[nodiscard]] double distance(const Vec<D>& p, int patch, std::int32_t& near) const;

    /// The nearest point of the nodes (D = 2) or edges (D = 3) between the first two of `patches`,
    /// or of the ridges inside the only one; no valid nodes where there are none. The nodes of an
    /// edge come first, the second one twice.
    [[nodiscard]] BoundaryPoint<D> project_on_line(const Vec<D>& p,
                                                   const std::vector<int>& patches) const;

private:
    struct Part {
        std::vector<FaceId> faces;
        std::unique_ptr<BoxTree<D>> tree;
    };
    struct Line {
        std::vector<Edge> edges; ///< D = 2: nodes, twice the same
        std::unique_ptr<BoxTree<D>> tree;
    };
    [[nodiscard]] BoundaryPoint<D> project(const Vec<D>& p, const Part& part) const;
    [[nodiscard]] const Part& faces_of(int patch) const;
    /// Number of the nearest face in `part`, -1 if it has none. \see BoxTree::nearest
    [[nodiscard]] std::int32_t nearest_face(const Vec<D>& p, const Part& part,
                                            std::int32_t guess) const;

    const Mesh<D>& mesh_;
    Part all_;
    std::map<int, Part> patches_;
    /// Under the pairs of patches that meet there; ridges inside a patch under it and itself.
    std::map<std::pair<int, int>, Line> lines_;
};

/// Weights of the point of a face nearest to `p`, and its distance. Well conditioned for faces of
/// any aspect ratio: linear in it, where the normal equations are quadratic.
[[nodiscard]] std::pair<std::array<double, 2>, double>
nearest_on_face(const std::array<Vec<2>, 2>& corners, const Vec<2>& p);
[[nodiscard]] std::pair<std::array<double, 3>, double>
nearest_on_face(const std::array<Vec<3>, 3>& corners, const Vec<3>& p);

} // namespace ameco
