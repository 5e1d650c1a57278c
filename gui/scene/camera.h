// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Where a view looks, as plain data.
#pragma once

#include "gui/scene/scene_options.h"

namespace ameco::gui {

/// A parallel projection: a length looks the same in front and behind, and a scale bar is true.
struct Camera {
    Vec3 focus = Vec3::Zero(); ///< the place in the middle of the view, unscaled [L]
    Vec3 sight{-1, -1, -1};    ///< direction of sight, of any length but 0, in the scaled view
    Vec3 up{0, 0, 1};          ///< of any length but 0, not along `sight`
    double height = 1;         ///< of the view, in the scaled view [L], > 0

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Looks against the axis named: `plus_x` is what one sees from far out on the x axis.
enum class StandardView { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z, corner };

inline constexpr std::array all_standard_views{
    StandardView::plus_x, StandardView::minus_x, StandardView::plus_y, StandardView::minus_y,
    StandardView::plus_z, StandardView::minus_z, StandardView::corner};

/// "x+", "x-", ..., "corner".
[[nodiscard]] std::string_view name(StandardView view);
[[nodiscard]] std::optional<StandardView> standard_view_from_name(std::string_view name);

/// A camera of that direction with focus 0 and height 1.
[[nodiscard]] Camera camera_of(StandardView view);

} // namespace ameco::gui
