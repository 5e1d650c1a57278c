// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/mesh_scene.h"

#include "gui/bridge/to_vtk.h"
#include "gui/scene/colour_map.h"
#include "gui/scene/view_transform.h"
#include "gui/scene/visible_surface.h"

#include <Eigen/Geometry>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ameco::gui {
namespace {

/// The camera's axes in the scaled view, orthonormal.
struct ViewAxes {
    Vec3 right, up, sight;
};

ViewAxes axes_of(const Camera& camera) {
    ViewAxes axes;
    axes.sight = camera.sight.normalized();
    axes.right = axes.sight.cross(camera.up).normalized();
    axes.up = axes.right.cross(axes.sight);
    return axes;
}

} // namespace

class MeshScene::Impl {
public:
    Impl();

    void rebuild_surface();
    void place_points();
    void place_camera();

    [[nodiscard]] std::array<double, 4> pixels() const; ///< left, bottom, width, height

    std::shared_ptr<const SceneData> data;
    SceneOptions options;
    Camera camera;
    std::unique_ptr<SurfaceExtractor> extractor;
    const VisibleSurface* surface = nullptr;
    ViewTransform transform;
    std::vector<Vec3> places; ///< of the surface's points, in the scaled view from the anchor
    bool surface_old = true;
    bool places_old = true;
    bool transparent = false;
    std::string caption;
    std::vector<NodeId> highlighted;
    std::optional<NodeId> marked;

    vtkRenderWindow* window = nullptr;
    Viewport viewport;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkPolyData> polygons;
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
};

MeshScene::Impl::Impl() {
    mapper->SetInputData(polygons);
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(0.35);
    actor->GetProperty()->SetDiffuse(0.65);
    actor->GetProperty()->SetEdgeColor(0.15, 0.16, 0.2);
    renderer->AddActor(actor);
    renderer->GetActiveCamera()->ParallelProjectionOn();
}

void MeshScene::Impl::rebuild_surface() {
    surface_old = false;
    places_old = true;
    surface = &extractor->extract(options.clip, options.hidden_patches);
    polygons->SetPolys(to_vtk(surface->polygons));
    std::vector<Rgb> colours;
    colours.reserve(surface->polygons.size());
    for (const FaceId face : surface->faces) {
        if (!face.valid()) {
            colours.push_back(inside_colour);
            continue;
        }
        const int patch = data->triangle_patch[face.index()];
        const auto at = std::lower_bound(data->patches.begin(), data->patches.end(), patch);
        colours.push_back(category_colour(static_cast<std::size_t>(at - data->patches.begin())));
    }
    polygons->GetCellData()->SetScalars(to_vtk(colours));
}

void MeshScene::Impl::place_points() {
    places_old = false;
    transform = make_view_transform(options, camera.focus);
    places.clear();
    places.reserve(surface->point_count());
    for (const NodeId i : surface->nodes) {
        places.push_back(transform.forward(data->position(i)));
    }
    for (const CutPoint& c : surface->cuts) {
        const Vec3 a = transform.forward(data->position(c.a));
        places.push_back(a + c.t * (transform.forward(data->position(c.b)) - a));
    }
    std::vector<Float3> points;
    points.reserve(places.size());
    for (const Vec3& y : places) {
        points.push_back(
            {static_cast<float>(y[0]), static_cast<float>(y[1]), static_cast<float>(y[2])});
    }
    std::vector<Float3> normals;
    normals.reserve(surface->polygons.size());
    for (const auto& p : surface->polygons) {
        const Vec3& a = places[static_cast<std::size_t>(p[0])];
        const Vec3 n = (places[static_cast<std::size_t>(p[1])] - a)
                           .cross(places[static_cast<std::size_t>(p[2])] - a)
                           .normalized();
        normals.push_back(
            {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
    }
    polygons->SetPoints(to_vtk_points(points));
    polygons->GetCellData()->SetNormals(to_vtk(normals));
}

std::array<double, 4> MeshScene::Impl::pixels() const {
    const int* const size = window->GetSize();
    return {viewport.left * size[0], viewport.bottom * size[1],
            (viewport.right - viewport.left) * size[0], (viewport.top - viewport.bottom) * size[1]};
}

void MeshScene::Impl::place_camera() {
    const ViewAxes axes = axes_of(camera);
    const Vec3 focus = transform.forward(camera.focus);
    double depth = camera.height;
    for (const Vec3& y : places) {
        depth = std::max(depth, std::abs((y - focus).dot(axes.sight)));
    }
    depth = std::min(depth, 2000 * camera.height);
    vtkCamera* const c = renderer->GetActiveCamera();
    const Vec3 eye = focus - 1.1 * depth * axes.sight;
    c->SetFocalPoint(focus.data());
    c->SetPosition(eye.data());
    c->SetViewUp(axes.up.data());
    c->SetParallelScale(camera.height / 2);
    c->SetClippingRange(0.05 * depth, 2.15 * depth);
}

MeshScene::MeshScene() : impl_(std::make_unique<Impl>()) {}

MeshScene::~MeshScene() {
    attach(nullptr);
}

void MeshScene::attach(vtkRenderWindow* window, const Viewport& viewport) {
    if (impl_->window != nullptr) {
        impl_->window->RemoveRenderer(impl_->renderer);
    }
    impl_->window = window;
    impl_->viewport = viewport;
    if (window != nullptr) {
        window->AddRenderer(impl_->renderer);
        impl_->renderer->SetViewport(viewport.left, viewport.bottom, viewport.right, viewport.top);
    }
}

vtkRenderer* MeshScene::renderer() const {
    return impl_->renderer;
}

void MeshScene::set_data(std::shared_ptr<const SceneData> data) {
    const bool first = impl_->data == nullptr;
    impl_->data = std::move(data);
    impl_->surface = nullptr;
    impl_->extractor.reset();
    impl_->surface_old = true;
    if (impl_->data == nullptr) {
        impl_->polygons->Initialize();
        return;
    }
    impl_->extractor = std::make_unique<SurfaceExtractor>(impl_->data);
    if (first) {
        impl_->options.hidden_patches = patches_hidden_at_first(*impl_->data);
        standard_view(impl_->data->dimension == 3 ? StandardView::corner : StandardView::plus_z);
    }
}

const std::shared_ptr<const SceneData>& MeshScene::data() const {
    return impl_->data;
}

void MeshScene::set_caption(const std::string& caption) {
    impl_->caption = caption;
}

void MeshScene::set_options(const SceneOptions& options) {
    impl_->options = options;
    impl_->surface_old = true;
}

const SceneOptions& MeshScene::options() const {
    return impl_->options;
}

void MeshScene::highlight(std::vector<NodeId> nodes) {
    impl_->highlighted = std::move(nodes);
}

void MeshScene::mark(std::optional<NodeId> node) {
    impl_->marked = node;
}

std::optional<Pick> MeshScene::pick(double, double) const {
    return std::nullopt;
}

std::pair<double, double> MeshScene::pixel_of(const Vec3& position) const {
    const auto [left, bottom, width, height] = impl_->pixels();
    const ViewAxes axes = axes_of(impl_->camera);
    const Vec3 y = impl_->transform.A * (position - impl_->camera.focus);
    const double scale = height / impl_->camera.height;
    return {left + width / 2 + scale * y.dot(axes.right),
            bottom + height / 2 + scale * y.dot(axes.up)};
}

std::optional<ClipHandle> MeshScene::clip_handle_at(double, double) const {
    return std::nullopt;
}

ClipPlane MeshScene::dragged_clip(ClipHandle, double, double, double, double) const {
    return impl_->options.clip;
}

Camera MeshScene::camera() const {
    return impl_->camera;
}

void MeshScene::set_camera(const Camera& camera) {
    impl_->camera = camera;
}

void MeshScene::reset_camera() {
    if (impl_->data == nullptr) {
        return;
    }
    const ViewTransform transform = make_view_transform(impl_->options, Vec3::Zero());
    const Vec3 low = impl_->data->focus_low;
    const Vec3 high = impl_->data->focus_high;
    const ViewAxes axes = axes_of(impl_->camera);
    double width = 0;
    double height = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 half = (high - low) / 2;
        for (int k = 0; k < 3; ++k) {
            half[k] *= (corner >> k & 1) != 0 ? 1 : -1;
        }
        const Vec3 y = transform.A * half;
        width = std::max(width, 2 * std::abs(y.dot(axes.right)));
        height = std::max(height, 2 * std::abs(y.dot(axes.up)));
    }
    double aspect = 1.5;
    if (impl_->window != nullptr && impl_->window->GetSize()[1] > 0) {
        const auto [left, bottom, pixel_width, pixel_height] = impl_->pixels();
        aspect = pixel_width / pixel_height;
    }
    impl_->camera.focus = (low + high) / 2;
    impl_->camera.height = 1.1 * std::max({height, width / aspect, 1e-300});
}

void MeshScene::standard_view(StandardView view) {
    const Camera camera = camera_of(view);
    impl_->camera.sight = camera.sight;
    impl_->camera.up = camera.up;
    reset_camera();
}

void MeshScene::turn(double dx, double dy) {
    const auto [left, bottom, width, height] = impl_->pixels();
    const ViewAxes axes = axes_of(impl_->camera);
    const double full = std::numbers::pi / std::min(width, height);
    const Mat<3> rotation =
        (Eigen::AngleAxisd(-dx * full, axes.up) * Eigen::AngleAxisd(dy * full, axes.right))
            .toRotationMatrix();
    impl_->camera.sight = rotation * axes.sight;
    impl_->camera.up = rotation * axes.up;
}

void MeshScene::shift(double dx, double dy) {
    const auto [left, bottom, width, height] = impl_->pixels();
    const ViewAxes axes = axes_of(impl_->camera);
    const double scale = impl_->camera.height / height;
    impl_->camera.focus -= make_view_transform(impl_->options, Vec3::Zero()).inverse *
                           (scale * (dx * axes.right + dy * axes.up));
}

void MeshScene::zoom_at(double x, double y, double factor) {
    const auto [left, bottom, width, height] = impl_->pixels();
    const double dx = x - left - width / 2;
    const double dy = y - bottom - height / 2;
    shift(-dx, -dy);
    impl_->camera.height /= factor;
    shift(dx, dy);
}

void MeshScene::set_interactive(bool) {}

void MeshScene::set_transparent(bool transparent) {
    impl_->transparent = transparent;
}

void MeshScene::prepare(double) {
    if (impl_->options.dark) {
        impl_->renderer->SetBackground(0.12, 0.13, 0.16);
    } else {
        impl_->renderer->SetBackground(1, 1, 1);
    }
    impl_->renderer->SetBackgroundAlpha(impl_->transparent ? 0 : 1);
    auto* const property = impl_->actor->GetProperty();
    property->SetEdgeVisibility(impl_->options.representation ==
                                Representation::surface_with_edges);
    property->SetRepresentation(
        impl_->options.representation == Representation::wireframe ? VTK_WIREFRAME : VTK_SURFACE);
    if (impl_->data == nullptr) {
        return;
    }
    if (impl_->surface_old) {
        impl_->rebuild_surface();
    }
    if (impl_->places_old) {
        impl_->place_points();
    }
    impl_->place_camera();
}

std::optional<std::pair<double, double>> MeshScene::shown_range() const {
    return impl_->options.range;
}

std::string MeshScene::scale_label() const {
    return is_view_scaled(impl_->options) ? "VIEW SCALED" : "";
}

std::size_t MeshScene::shown_triangles() const {
    return impl_->surface != nullptr ? impl_->surface->polygons.size() : 0;
}

std::size_t MeshScene::shown_ellipsoids() const {
    return 0;
}

} // namespace ameco::gui
