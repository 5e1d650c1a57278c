// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How a camera maps the mesh to pixels.
#pragma once

#include "gui/scene/camera.h"
#include "gui/scene/legend.h"
#include "gui/scene/pick.h"
#include "gui/scene/scene_data.h"
#include "gui/scene/view_transform.h"
#include "gui/scene/visible_surface.h"

#include <array>
#include <vector>

namespace ameco::gui {

using Pixel = std::array<double, 2>; ///< [device pixels of the window, y up]

struct ViewFrame {
    ViewTransform transform;
    Vec3 right, up, sight;      ///< orthonormal, in the scaled view
    Vec3 focus = Vec3::Zero();  ///< in the scaled view, from the transform's anchor
    double units_per_pixel = 1; ///< in the scaled view
    Area area;                  ///< of the window

    [[nodiscard]] Pixel pixel_of_place(const Vec3& y) const; ///< y in the scaled view
    [[nodiscard]] Pixel pixel_of(const Vec3& x) const {
        return pixel_of_place(transform.forward(x));
    }
    /// The way in the scaled view that is so many pixels long.
    [[nodiscard]] Vec3 way(double dx, double dy) const {
        return units_per_pixel * (dx * right + dy * up);
    }
};

[[nodiscard]] ViewFrame make_view_frame(const Camera& camera, const ViewTransform& transform,
                                        const Area& area);

/// The polygon nearest to the eye at a pixel. \param places  of the surface's points, scaled view
[[nodiscard]] std::optional<Pick> pick_surface(const SceneData& data, const VisibleSurface& surface,
                                               const std::vector<Vec3>& places,
                                               const ViewFrame& frame, const Pixel& pixel);

/// The handle of a clip plane: from a place on the plane, near the middle of the view, along the
/// normal.
struct HandleShape {
    Pixel foot{}, tip{};
};

/// \param length  of the handle [device pixels]
[[nodiscard]] HandleShape handle_shape(const ClipPlane& clip, const ViewFrame& frame,
                                       double length);
/// The plane moved along its normal, so that the handle follows the mouse.
[[nodiscard]] ClipPlane shifted(const ClipPlane& clip, const ViewFrame& frame, const Pixel& from,
                                const Pixel& to);
/// The plane turned about the handle's foot, so that the tip follows the mouse.
[[nodiscard]] ClipPlane turned(const ClipPlane& clip, const ViewFrame& frame, const Pixel& from,
                               const Pixel& to, double length);

} // namespace ameco::gui
