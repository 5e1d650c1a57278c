// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/mesh_scene_impl.h"

#include "gui/bridge/generic_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <vtkCamera.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>

namespace ameco::gui {
namespace {

/// Beyond so many heights of the view in front and behind, nothing is drawn: the depths of the rest
/// are then told apart well.
constexpr double most_depth = 2000;
/// The anchor of the transform follows the camera when it is so many heights away: single
/// precision then places points to 1/100 of a pixel.
constexpr double most_anchor_distance = 100;

/// While the mouse drags, meshes beyond these sizes are drawn without edges, or without what a clip
/// plane lays open.
constexpr std::size_t many_polygons = 400'000;
constexpr std::size_t many_elements = 4'000'000;

constexpr Rgb highlight_colour{235, 20, 120};
constexpr Rgb natural_colour{238, 118, 52};
constexpr Rgb target_colour{40, 140, 190};

void set_background(vtkRenderer* renderer, const Rgb& colour, bool transparent) {
    renderer->SetBackground(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
    renderer->SetBackgroundAlpha(transparent ? 0 : 1);
}

} // namespace

MeshScene::Impl::Impl() {
    renderer->GetActiveCamera()->ParallelProjectionOn();
    for (const SceneActor* part :
         {&surface_actor_, &lines_actor_, &dots_actor_, &highlight_actor_, &glyph_actor_}) {
        renderer->AddActor(part->actor());
    }
    vtkProperty* const surface_property = surface_actor_.actor()->GetProperty();
    surface_property->SetAmbient(0.58);
    surface_property->SetDiffuse(0.46);
    surface_property->SetEdgeColor(0.13, 0.14, 0.17);
    vtkProperty* const glyph_property = glyph_actor_.actor()->GetProperty();
    glyph_property->SetInterpolationToPhong();
    glyph_property->SetAmbient(0.42);
    glyph_property->SetDiffuse(0.62);
    glyph_property->SetSpecular(0.25);
    glyph_property->SetSpecularPower(20);
    for (const SceneActor* flat : {&lines_actor_, &dots_actor_, &highlight_actor_}) {
        flat->actor()->GetProperty()->LightingOff();
    }
    highlight_actor_.actor()->GetProperty()->RenderPointsAsSpheresOn();
    dots_actor_.actor()->GetProperty()->RenderPointsAsSpheresOn();
    highlight_actor_.colour_all(highlight_colour);
    vtkProperty* const through = through_actor_.actor()->GetProperty();
    through->LightingOff();
    through->SetOpacity(0.35);
    through_actor_.colour_all(highlight_colour);
    through_->AddActor(through_actor_.actor());
    through_->SetActiveCamera(renderer->GetActiveCamera());
    through_->SetLayer(1);
    through_->InteractiveOff();
    over_->SetLayer(2);
    over_->InteractiveOff();
    overlay_.show_in(over_);
}

void MeshScene::Impl::show(vtkRenderWindow* to, const Viewport& where) {
    if (window != nullptr) {
        window->RemoveRenderer(renderer);
        window->RemoveRenderer(margin_);
        window->RemoveRenderer(through_);
        window->RemoveRenderer(over_);
    }
    window = to;
    viewport_ = where;
    if (window != nullptr) {
        window->SetNumberOfLayers(3);
        window->AddRenderer(renderer);
        window->AddRenderer(margin_);
        window->AddRenderer(through_);
        window->AddRenderer(over_);
    }
}

void MeshScene::Impl::clear_actors() {
    for (SceneActor* part : {&surface_actor_, &lines_actor_, &dots_actor_, &highlight_actor_,
                             &through_actor_, &glyph_actor_}) {
        part->clear();
    }
    ellipsoids = 0;
}

Area MeshScene::Impl::whole_area() const {
    if (window == nullptr) {
        return {0, 0, 0, 0};
    }
    const int* const size = window->GetSize();
    return {viewport_.left * size[0], viewport_.bottom * size[1],
            (viewport_.right - viewport_.left) * size[0],
            (viewport_.top - viewport_.bottom) * size[1]};
}

Area MeshScene::Impl::main_area() const {
    Area area = whole_area();
    area.width -= legend_width;
    return area;
}

ViewFrame MeshScene::Impl::frame() const {
    return make_view_frame(camera, transform, main_area());
}

Range MeshScene::Impl::scale_range() const {
    return options.range.value_or(data_range.value_or(Range{0, 1}));
}

bool MeshScene::Impl::is_anchor_far() const {
    const Vec3 way = transform.A * (camera.focus - transform.anchor);
    return way.norm() > most_anchor_distance * camera.height;
}

bool MeshScene::Impl::is_clipped_away(NodeId node) const {
    if (!options.clip.enabled) {
        return false;
    }
    const double offset =
        (data->position(node) - options.clip.origin).dot(options.clip.normal.normalized());
    return options.clip.keep_other_side ? offset < 0 : offset > 0;
}

void MeshScene::Impl::rebuild_surface() {
    surface_old = false;
    places_old = colours_old = true;
    simplified = interactive && simplified && data->element_count > many_elements;
    surface = &extractor->extract(options.clip, options.hidden_patches, simplified);
    surface_actor_.clear();
    surface_actor_.set_polygons(surface->polygons);
    lines_actor_.clear();
    if (!surface->lines.empty()) {
        lines_actor_.set_lines(surface->lines);
        std::vector<Rgb> colours;
        for (const int patch : surface->line_patch) {
            const bool by_patch = options.colour == ColourBy::patch;
            colours.push_back(by_patch ? patch_colour(*data, patch) : light_ink);
        }
        lines_actor_.colour_cells(colours);
    }
}

void MeshScene::Impl::place_points() {
    places_old = false;
    glyphs_old = points_old = true;
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
    surface_actor_.set_points(places);
    surface_actor_.set_flat_normals(surface->polygons, places);
    if (!surface->lines.empty()) {
        lines_actor_.set_points(places);
    }
}

ColourBy MeshScene::Impl::colour() const {
    return has_scale(options.colour) && data != nullptr && !data->has_metric() ? ColourBy::none
                                                                               : options.colour;
}

void MeshScene::Impl::colour_surface() {
    colours_old = false;
    if (colour() != data_range_of) {
        data_range_of = colour();
        data_range.reset();
        if (has_scale(colour())) {
            data_range = range_of(*data, colour());
        }
    }
    if (is_nodal(colour())) {
        surface_actor_.colour_points_by_scale(
            point_places(*data, *surface, colour(), scale_range()));
    } else {
        surface_actor_.colour_cells(polygon_colours(*data, *surface, colour(), scale_range()));
    }
}

void MeshScene::Impl::build_glyphs() {
    glyphs_old = false;
    ellipsoids = 0;
    glyph_actor_.clear();
    if (interactive && options.ellipsoids.where != EllipsoidOptions::Where::picked) {
        return; // they come back when the mouse lets go
    }
    const auto nodes = ellipsoid_nodes(*data, *surface, options.clip, options.ellipsoids, marked);
    if (nodes.empty()) {
        return;
    }
    const auto balls = make_ellipsoids(*data, nodes, options.ellipsoids);
    GlyphMesh mesh = glyph_mesh(*data, balls, transform);
    if (data->dimension == 2) { // over the triangles, not in their plane
        for (Vec3& point : mesh.points) {
            point[2] += 1e-3 * camera.height;
        }
    }
    ellipsoids = balls.size();
    glyph_actor_.set_points(mesh.points);
    glyph_actor_.set_normals(mesh.normals);
    glyph_actor_.set_polygons(mesh.triangles);
    glyph_actor_.colour_all(options.ellipsoids.source == EllipsoidSource::natural ? natural_colour
                                                                                  : target_colour);
    vtkProperty* const property = glyph_actor_.actor()->GetProperty();
    property->SetLighting(data->dimension == 3);
    property->SetOpacity(data->dimension == 3 ? 1 : 0.65); // in 2-D it lies on the triangles
}

void MeshScene::Impl::build_points() {
    points_old = false;
    highlight_actor_.clear();
    through_actor_.clear();
    std::vector<Vec3> at;
    for (const NodeId i : highlighted) {
        if (i.valid() && i.index() < data->node_count && !is_clipped_away(i)) {
            at.push_back(transform.forward(data->position(i)));
        }
    }
    if (!at.empty()) {
        highlight_actor_.set_points(at);
        highlight_actor_.set_vertices(at.size());
        through_actor_.set_points(at);
        through_actor_.set_vertices(at.size());
    }
    dots_actor_.clear();
    const std::vector<int>& gone = data->removed_at();
    if (options.colour == ColourBy::removed_at && !gone.empty()) {
        std::vector<Rgb> colours;
        for (const NodeId i : surface->nodes) {
            colours.push_back(removal_colour(gone[i.index()]));
        }
        dots_actor_.set_points(
            {places.begin(), places.begin() + static_cast<std::ptrdiff_t>(surface->nodes.size())});
        dots_actor_.set_vertices(surface->nodes.size());
        dots_actor_.colour_points(colours);
    }
}

/// The walls fill the view, or whatever else is shown.
void MeshScene::Impl::fit() {
    const ViewFrame view = frame();
    std::vector<std::uint8_t> counts(places.size(), data->outer.empty() ? 1 : 0);
    for (std::size_t p = 0; p < surface->polygons.size() && !data->outer.empty(); ++p) {
        const FaceId face = surface->faces[p];
        if (face.valid() && !std::binary_search(data->outer.begin(), data->outer.end(),
                                                data->triangle_patch[face.index()])) {
            for (const std::int32_t corner : surface->polygons[p]) {
                if (corner >= 0) {
                    counts[static_cast<std::size_t>(corner)] = 1;
                }
            }
        }
    }
    Eigen::AlignedBox2d box;
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -nearest;
    const auto add = [&](const Vec3& y) {
        box.extend(Vec<2>(y.dot(view.right), y.dot(view.up)));
        nearest = std::min(nearest, y.dot(view.sight));
        farthest = std::max(farthest, y.dot(view.sight));
    };
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (counts[k] != 0) {
            add(places[k]);
        }
    }
    for (int k = 0; k < 8 && box.isEmpty(); ++k) {
        for (int c = 0; c < 8; ++c) {
            add(transform.forward({(c & 1) != 0 ? data->focus_low[0] : data->focus_high[0],
                                   (c & 2) != 0 ? data->focus_low[1] : data->focus_high[1],
                                   (c & 4) != 0 ? data->focus_low[2] : data->focus_high[2]}));
        }
    }
    const Area area = main_area();
    const double wide = area.width > 0 ? box.sizes()[0] * area.height / area.width : 0;
    const Vec<2> middle = box.center();
    camera.focus = transform.backward(middle[0] * view.right + middle[1] * view.up +
                                      (nearest + farthest) / 2 * view.sight);
    camera.height = 1.15 * std::max({box.sizes()[1], wide, 1e-12 * (farthest - nearest), 1e-300});
}

void MeshScene::Impl::place_camera() {
    const ViewFrame view = frame();
    double depth = camera.height;
    for (const Vec3& y : places) {
        depth = std::max(depth, std::abs((y - view.focus).dot(view.sight)));
    }
    depth = std::min(depth, most_depth * camera.height);
    vtkCamera* const c = renderer->GetActiveCamera();
    const Vec3 eye = view.focus - 1.1 * depth * view.sight;
    c->SetFocalPoint(view.focus.data());
    c->SetPosition(eye.data());
    c->SetViewUp(view.up.data());
    c->SetParallelScale(camera.height / 2);
    c->SetClippingRange(0.05 * depth, 2.15 * depth);
}

void MeshScene::Impl::set_appearance() {
    window->SetMultiSamples(interactive ? 0 : smooth_samples);
    const Rgb& background = options.dark ? dark_background : light_background;
    set_background(renderer, background, transparent);
    set_background(margin_, background, transparent);
    const bool many = surface != nullptr && surface->polygons.size() > many_polygons;
    const bool wire = options.representation == Representation::wireframe;
    vtkProperty* const property = surface_actor_.actor()->GetProperty();
    property->SetRepresentation(wire ? VTK_WIREFRAME : VTK_SURFACE);
    property->SetLighting(!wire);
    property->SetEdgeVisibility(options.representation == Representation::surface_with_edges &&
                                !(interactive && many));
    const auto width = static_cast<float>(std::max(1.0, pixel_ratio / 2));
    property->SetLineWidth(width);
    lines_actor_.actor()->GetProperty()->SetLineWidth(2.5F * static_cast<float>(pixel_ratio));
    const auto dot = static_cast<float>(7 * pixel_ratio);
    highlight_actor_.actor()->GetProperty()->SetPointSize(dot);
    through_actor_.actor()->GetProperty()->SetPointSize(0.7F * dot);
    through_->SetDraw(!highlighted.empty());
    dots_actor_.actor()->GetProperty()->SetPointSize(dot);
}

void MeshScene::Impl::bring_up_to_date(double ratio) {
    pixel_ratio = ratio;
    if (window == nullptr) {
        return;
    }
    if (data != nullptr) {
        if (surface_old) {
            rebuild_surface();
        }
        if (colours_old) {
            colour_surface();
        }
        lay_out();
        if (places_old) {
            place_points();
        }
        if (fit_wanted && main_area().height > 0) {
            fit_wanted = false;
            fit();
        }
        if (is_anchor_far()) {
            place_points();
        }
        if (glyphs_old) {
            build_glyphs();
        }
        if (points_old) {
            build_points();
        }
        place_camera();
    } else {
        lay_out();
    }
    set_appearance();
    draw_overlay();
}

} // namespace ameco::gui
