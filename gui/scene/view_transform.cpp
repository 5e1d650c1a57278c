// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/view_transform.h"

namespace ameco::gui {

ViewTransform make_view_transform(const SceneOptions& options, const Vec3& anchor) {
    ViewTransform transform;
    transform.anchor = anchor;
    const Mat<3> scale = options.view_scale.asDiagonal();
    const Mat<3> unscale = options.view_scale.cwiseInverse().asDiagonal();
    transform.A = scale;
    transform.inverse = unscale;
    if (options.lens.enabled) {
        const Vec3 n = options.lens.normal.normalized();
        const Mat<3> along = n * n.transpose();
        transform.A = scale * (Mat<3>::Identity() + (options.lens.factor - 1) * along);
        transform.inverse = (Mat<3>::Identity() + (1 / options.lens.factor - 1) * along) * unscale;
    }
    return transform;
}

} // namespace ameco::gui
