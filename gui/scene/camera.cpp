// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/camera.h"

#include <algorithm>

namespace ameco::gui {

std::string_view name(StandardView view) {
    switch (view) {
    case StandardView::plus_x:
        return "x+";
    case StandardView::minus_x:
        return "x-";
    case StandardView::plus_y:
        return "y+";
    case StandardView::minus_y:
        return "y-";
    case StandardView::plus_z:
        return "z+";
    case StandardView::minus_z:
        return "z-";
    case StandardView::corner:
        return "corner";
    }
    return "";
}

std::optional<StandardView> standard_view_from_name(std::string_view wanted) {
    const auto* const found = std::find_if(all_standard_views.begin(), all_standard_views.end(),
                                           [&](StandardView view) { return name(view) == wanted; });
    return found == all_standard_views.end() ? std::nullopt : std::optional(*found);
}

Camera camera_of(StandardView view) {
    Camera camera;
    switch (view) {
    case StandardView::plus_x:
        camera.sight = {-1, 0, 0};
        break;
    case StandardView::minus_x:
        camera.sight = {1, 0, 0};
        break;
    case StandardView::plus_y:
        camera.sight = {0, -1, 0};
        break;
    case StandardView::minus_y:
        camera.sight = {0, 1, 0};
        break;
    case StandardView::plus_z:
        camera.sight = {0, 0, -1};
        camera.up = {0, 1, 0};
        break;
    case StandardView::minus_z:
        camera.sight = {0, 0, 1};
        camera.up = {0, 1, 0};
        break;
    case StandardView::corner:
        camera.sight = {1, -0.9, -0.75};
        break;
    }
    return camera;
}

} // namespace ameco::gui
