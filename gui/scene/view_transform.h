// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// From the mesh's coordinates to those the graphics card sees.
#pragma once

#include "gui/scene/scene_options.h"

namespace ameco::gui {

/// y = A (x - anchor): the lens stretches along its normal n, then the axes are scaled,
///
///     A = diag(view_scale) (I + (factor - 1) n n^T)
///
/// The anchor is a place near the middle of the view. Differences to it are taken in double
/// precision, and so heights of 1e-9 at coordinates of 1 survive the graphics card's floats.
struct ViewTransform {
    Vec3 anchor = Vec3::Zero();
    Mat<3> A = Mat<3>::Identity();
    Mat<3> inverse = Mat<3>::Identity();

    [[nodiscard]] Vec3 forward(const Vec3& x) const { return A * (x - anchor); }
    [[nodiscard]] Vec3 backward(const Vec3& y) const { return anchor + inverse * y; }
};

[[nodiscard]] ViewTransform make_view_transform(const SceneOptions& options, const Vec3& anchor);

} // namespace ameco::gui
