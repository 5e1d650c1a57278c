// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/mesh_scene.h"

#include "gui/scene/mesh_scene_impl.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace ameco::gui {

MeshScene::MeshScene() : impl_(std::make_unique<Impl>()) {}

MeshScene::~MeshScene() {
    attach(nullptr);
}

void MeshScene::attach(vtkRenderWindow* window, const Viewport& viewport) {
    impl_->show(window, viewport);
}

vtkRenderer* MeshScene::renderer() const {
    return impl_->renderer;
}

void MeshScene::set_data(std::shared_ptr<const SceneData> data) {
    Impl& i = *impl_;
    const bool first = i.data == nullptr;
    i.surface = nullptr;
    i.places.clear();
    i.extractor.reset();
    i.data = std::move(data);
    i.surface_old = true;
    i.data_range_of = ColourBy::none;
    i.data_range.reset();
    if (i.data == nullptr) {
        i.clear_actors();
        return;
    }
    i.extractor = std::make_unique<SurfaceExtractor>(i.data);
    if (first) {
        i.options.hidden_patches.merge(patches_hidden_at_first(*i.data));
        standard_view(i.data->dimension == 3 ? StandardView::corner : StandardView::plus_z);
    }
}

const std::shared_ptr<const SceneData>& MeshScene::data() const {
    return impl_->data;
}

void MeshScene::set_caption(const std::string& caption) {
    impl_->caption = caption;
}

void MeshScene::set_legend_data(std::shared_ptr<const SceneData> data) {
    impl_->legend_data = std::move(data);
}

void MeshScene::set_options(const SceneOptions& options) {
    Impl& i = *impl_;
    const SceneOptions& old = i.options;
    if (old.clip != options.clip && i.interactive) {
        i.simplified = true;
    }
    i.surface_old |= old.clip != options.clip || old.hidden_patches != options.hidden_patches ||
                     (old.colour == ColourBy::patch) != (options.colour == ColourBy::patch);
    i.places_old |= old.view_scale != options.view_scale || !(old.lens == options.lens);
    i.colours_old |= old.colour != options.colour || old.range != options.range;
    i.glyphs_old |= !(old.ellipsoids == options.ellipsoids);
    i.points_old |= old.colour != options.colour || old.clip != options.clip;
    i.options = options;
}

const SceneOptions& MeshScene::options() const {
    return impl_->options;
}

void MeshScene::highlight(std::vector<NodeId> nodes) {
    impl_->highlighted = std::move(nodes);
    impl_->points_old = true;
}

void MeshScene::mark(std::optional<NodeId> node) {
    impl_->marked = node;
    impl_->glyphs_old = true;
}

std::optional<Pick> MeshScene::pick(double x, double y) const {
    if (impl_->surface == nullptr || impl_->window == nullptr) {
        return std::nullopt;
    }
    return pick_surface(*impl_->data, *impl_->surface, impl_->places, impl_->frame(), {x, y});
}

std::pair<double, double> MeshScene::pixel_of(const Vec3& position) const {
    const auto [x, y] = impl_->frame().pixel_of(position);
    return {x, y};
}

void MeshScene::set_handles(bool shown) {
    impl_->handles = shown;
}

std::optional<ClipHandle> MeshScene::clip_handle_at(double x, double y) const {
    if (!impl_->handles || !impl_->options.clip.enabled || impl_->data == nullptr) {
        return std::nullopt;
    }
    const double u = impl_->pixel_ratio;
    const auto [foot, tip] = handle_shape(impl_->options.clip, impl_->frame(), handle_length * u);
    if (std::hypot(x - tip[0], y - tip[1]) < 14 * u) {
        return ClipHandle::turn;
    }
    const double dx = tip[0] - foot[0];
    const double dy = tip[1] - foot[1];
    const double t =
        std::clamp(((x - foot[0]) * dx + (y - foot[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(x - foot[0] - t * dx, y - foot[1] - t * dy) < 10 * u
               ? std::optional(ClipHandle::shift)
               : std::nullopt;
}

ClipPlane MeshScene::dragged_clip(ClipHandle handle, double from_x, double from_y, double to_x,
                                  double to_y) const {
    const ViewFrame view = impl_->frame();
    const ClipPlane& clip = impl_->options.clip;
    return handle == ClipHandle::shift ? shifted(clip, view, {from_x, from_y}, {to_x, to_y})
                                       : turned(clip, view, {from_x, from_y}, {to_x, to_y},
                                                handle_length * impl_->pixel_ratio);
}

Camera MeshScene::camera() const {
    return impl_->camera;
}

void MeshScene::set_camera(const Camera& camera) {
    impl_->camera = camera;
    impl_->fit_wanted = false;
}

void MeshScene::reset_camera() {
    impl_->fit_wanted = true;
    if (impl_->data != nullptr) {
        impl_->bring_up_to_date(impl_->pixel_ratio);
    }
}

void MeshScene::standard_view(StandardView view) {
    const Camera camera = camera_of(view);
    impl_->camera.sight = camera.sight;
    impl_->camera.up = camera.up;
    reset_camera();
}

void MeshScene::turn(double dx, double dy) {
    const ViewFrame view = impl_->frame();
    const double full =
        std::numbers::pi / std::max(1.0, std::min(view.area.width, view.area.height));
    const Mat<3> rotation =
        (Eigen::AngleAxisd(-dx * full, view.up) * Eigen::AngleAxisd(dy * full, view.right))
            .toRotationMatrix();
    impl_->camera.sight = rotation * view.sight;
    impl_->camera.up = rotation * view.up;
}

void MeshScene::shift(double dx, double dy) {
    const ViewFrame view = impl_->frame();
    impl_->camera.focus -=
        make_view_transform(impl_->options, Vec3::Zero()).inverse * view.way(dx, dy);
}

void MeshScene::zoom_at(double x, double y, double factor) {
    const Area area = impl_->frame().area;
    const double dx = x - area.left - area.width / 2;
    const double dy = y - area.bottom - area.height / 2;
    shift(-dx, -dy);
    impl_->camera.height /= factor;
    shift(dx, dy);
}

void MeshScene::set_interactive(bool interactive) {
    Impl& i = *impl_;
    if (i.interactive == interactive) {
        return;
    }
    i.interactive = interactive;
    if (!interactive) {
        i.surface_old |= i.simplified;
        i.simplified = false;
        i.glyphs_old = true;
    }
}

void MeshScene::set_transparent(bool transparent) {
    impl_->transparent = transparent;
}

void MeshScene::prepare(double pixel_ratio) {
    impl_->bring_up_to_date(pixel_ratio);
}

std::optional<std::pair<double, double>> MeshScene::shown_range() const {
    if (!has_scale(impl_->colour())) {
        return std::nullopt;
    }
    return impl_->scale_range();
}

std::string MeshScene::scale_label() const {
    return impl_->scale_label();
}

double MeshScene::legend_pixels() const {
    return impl_->legend_width;
}

std::size_t MeshScene::shown_triangles() const {
    return impl_->surface != nullptr ? impl_->surface->polygons.size() : 0;
}

std::size_t MeshScene::shown_ellipsoids() const {
    return impl_->ellipsoids;
}

} // namespace ameco::gui
