// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What lies under the mouse.
#pragma once

#include "core/base/id.h"
#include "gui/scene/scene_options.h"

namespace ameco::gui {

struct Pick {
    NodeId node;                  ///< of the triangle that was hit, the one nearest on the screen
    ElementId element;            ///< the triangle's element
    FaceId face;                  ///< boundary face (3-D); none inside the domain and in 2-D
    int patch = 0;                ///< of the face; of no meaning without a face
    Vec3 position = Vec3::Zero(); ///< where the triangle was hit, unscaled [L]
    Vec3 normal = Vec3::Zero();   ///< of the triangle, unscaled, unit, out of the domain

    friend bool operator==(const Pick&, const Pick&) = default;
};

} // namespace ameco::gui
