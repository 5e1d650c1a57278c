// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Unit balls of metrics, as ellipsoids.
#pragma once

#include "gui/scene/scene_data.h"
#include "gui/scene/view_transform.h"
#include "gui/scene/visible_surface.h"

#include <optional>
#include <vector>

namespace ameco::gui {

/// Where the ellipsoids stand: nodes, ascending. Of more than `max_count`, evenly many are left
/// out.
[[nodiscard]] std::vector<NodeId>
ellipsoid_nodes(const SceneData& data, const VisibleSurface& surface, const ClipPlane& clip,
                const EllipsoidOptions& options, std::optional<NodeId> picked);

/// An ellipsoid: centre + axes * (unit sphere), unscaled.
struct Ellipsoid {
    NodeId node;
    Mat<3> axes; ///< columns: half axes [L]; of a 2-D metric the third is 0
};

/// The ellipsoids of nodes: the mean of their elements' metrics, coarsened if that is asked for.
/// A node whose mean does not converge has none.
[[nodiscard]] std::vector<Ellipsoid> make_ellipsoids(const SceneData& data,
                                                     const std::vector<NodeId>& nodes,
                                                     const EllipsoidOptions& options);

/// Triangles of ellipsoids (3-D) or ellipses (2-D) in the scaled view. A linear map makes an
/// ellipsoid of an ellipsoid, so what is seen is the unit ball of the metric seen.
struct GlyphMesh {
    std::vector<Vec3> points;
    std::vector<Vec3> normals;
    std::vector<std::array<std::int32_t, 4>> triangles; ///< the fourth is -1
};

[[nodiscard]] GlyphMesh glyph_mesh(const SceneData& data, const std::vector<Ellipsoid>& ellipsoids,
                                   const ViewTransform& transform);

} // namespace ameco::gui
