// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/mesh_scene.h"

#include "gui/scene/legend.h"
#include "gui/scene/metric_glyphs.h"
#include "gui/scene/overlay.h"
#include "gui/scene/scene_actor.h"
#include "gui/scene/scene_values.h"
#include "gui/scene/view_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include <vtkCamera.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace ameco::gui {
namespace {

constexpr double text_size = 14;     ///< [units of prepare's pixel ratio]
constexpr double handle_length = 90; ///< of the clip plane's handle [the same]

/// Beyond so many heights of the view in front and behind, nothing is drawn: the depths of the rest
/// are then told apart well.
constexpr double most_depth = 2000;
/// The anchor of the transform follows the camera when it is so many heights away: single
/// precision then places points to 1/100 of a pixel.
constexpr double most_anchor_distance = 100;

/// While the mouse drags, meshes beyond these sizes are drawn without edges, or without what a clip
/// plane lays open.
constexpr std::size_t many_polygons = 400'000;
constexpr std::size_t many_elements = 1'500'000;

constexpr Rgb highlight_colour{235, 20, 120};
constexpr Rgb mark_colour{235, 20, 120};
constexpr Rgb natural_colour{238, 118, 52};
constexpr Rgb target_colour{40, 140, 190};
constexpr Rgb light_background{255, 255, 255};
constexpr Rgb dark_background{30, 33, 40};
constexpr Rgb light_ink{25, 27, 32};
constexpr Rgb dark_ink{232, 234, 238};

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

void set_background(vtkRenderer* renderer, const Rgb& colour, bool transparent) {
    renderer->SetBackground(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
    renderer->SetBackgroundAlpha(transparent ? 0 : 1);
}

} // namespace

class MeshScene::Impl {
public:
    Impl();

    void show(vtkRenderWindow* to, const Viewport& where);
    void clear_actors();
    [[nodiscard]] std::string scale_label() const;
    void bring_up_to_date(double pixel_ratio);
    void fit();
    [[nodiscard]] ViewFrame frame() const;
    [[nodiscard]] Range scale_range() const;

    std::shared_ptr<const SceneData> data;
    SceneOptions options;
    Camera camera;
    std::vector<NodeId> highlighted;
    std::optional<NodeId> marked;
    std::string caption;
    std::shared_ptr<const SceneData> legend_data; ///< of another scene; null: our own
    bool transparent = false;
    bool interactive = false;
    bool simplified = false; ///< what a clip plane lays open is left out for the time being
    bool handles = false;

    // What has to be made anew before the next picture. Each asks for those after it.
    bool surface_old = true, places_old = true, colours_old = true;
    bool glyphs_old = true, points_old = true;
    bool fit_wanted = false;

    std::unique_ptr<SurfaceExtractor> extractor;
    const VisibleSurface* surface = nullptr;
    ViewTransform transform;
    std::vector<Vec3> places; ///< of the surface's points, in the scaled view from the anchor
    std::size_t ellipsoids = 0;
    std::optional<Range> data_range;
    ColourBy data_range_of = ColourBy::none;

    vtkRenderWindow* window = nullptr;
    double pixel_ratio = 1;
    double legend_width = 0; ///< [device pixels]

    vtkNew<vtkRenderer> renderer;

private:
    void rebuild_surface();
    void place_points();
    void colour_surface();
    void build_glyphs();
    void build_points();
    void place_camera();
    void set_appearance();
    [[nodiscard]] bool is_anchor_far() const;
    [[nodiscard]] bool is_clipped_away(NodeId node) const;
    [[nodiscard]] Area whole_area() const;
    [[nodiscard]] Area main_area() const;
    void lay_out();
    [[nodiscard]] Legend legend() const;
    void draw_overlay();
    void draw_handle(const ViewFrame& view);

    Viewport viewport_;
    vtkNew<vtkRenderer> margin_; ///< behind the legend
    vtkNew<vtkRenderer> over_;   ///< over everything, the whole viewport
    SceneActor surface_actor_;
    SceneActor lines_actor_; ///< boundary of a 2-D mesh
    SceneActor dots_actor_;  ///< nodes that go on some level
    SceneActor highlight_actor_;
    SceneActor glyph_actor_;
    Overlay overlay_;
};

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
    glyph_property->SetAmbient(0.3);
    glyph_property->SetDiffuse(0.7);
    glyph_property->SetSpecular(0.25);
    glyph_property->SetSpecularPower(20);
    for (const SceneActor* flat : {&lines_actor_, &dots_actor_, &highlight_actor_}) {
        flat->actor()->GetProperty()->LightingOff();
    }
    highlight_actor_.actor()->GetProperty()->RenderPointsAsSpheresOn();
    dots_actor_.actor()->GetProperty()->RenderPointsAsSpheresOn();
    highlight_actor_.colour_all(highlight_colour);
    over_->SetLayer(1);
    over_->InteractiveOff();
    overlay_.show_in(over_);
}

void MeshScene::Impl::show(vtkRenderWindow* to, const Viewport& where) {
    if (window != nullptr) {
        window->RemoveRenderer(renderer);
        window->RemoveRenderer(margin_);
        window->RemoveRenderer(over_);
    }
    window = to;
    viewport_ = where;
    if (window != nullptr) {
        window->SetNumberOfLayers(2);
        window->AddRenderer(renderer);
        window->AddRenderer(margin_);
        window->AddRenderer(over_);
    }
}

void MeshScene::Impl::clear_actors() {
    for (SceneActor* part :
         {&surface_actor_, &lines_actor_, &dots_actor_, &highlight_actor_, &glyph_actor_}) {
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

void MeshScene::Impl::colour_surface() {
    colours_old = false;
    if (options.colour != data_range_of) {
        data_range_of = options.colour;
        data_range.reset();
        if (has_scale(options.colour)) {
            data_range = range_of(*data, options.colour);
        }
    }
    if (is_nodal(options.colour)) {
        surface_actor_.colour_points_by_scale(
            point_places(*data, *surface, options.colour, scale_range()));
    } else {
        surface_actor_.colour_cells(
            polygon_colours(*data, *surface, options.colour, scale_range()));
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
    glyph_actor_.actor()->GetProperty()->SetOpacity(data->dimension == 2 ? 0.6 : 1);
}

void MeshScene::Impl::build_points() {
    points_old = false;
    highlight_actor_.clear();
    std::vector<Vec3> at;
    for (const NodeId i : highlighted) {
        if (i.valid() && i.index() < data->node_count && !is_clipped_away(i)) {
            at.push_back(transform.forward(data->position(i)));
        }
    }
    if (!at.empty()) {
        highlight_actor_.set_points(at);
        highlight_actor_.set_vertices(at.size());
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
    dots_actor_.actor()->GetProperty()->SetPointSize(dot);
}

Legend MeshScene::Impl::legend() const {
    Legend legend;
    if (!options.legend || data == nullptr) {
        return legend;
    }
    const SceneData& explained = legend_data != nullptr ? *legend_data : *data;
    legend.title = title(options.colour);
    legend.colour = options.colour;
    if (has_scale(options.colour)) {
        legend.range = scale_range();
    } else if (options.colour == ColourBy::patch) {
        for (const int patch : explained.patches) {
            if (!options.hidden_patches.contains(patch)) {
                legend.entries.push_back(
                    {patch_colour(explained, patch), explained.patch_name(patch)});
            }
        }
    } else if (options.colour == ColourBy::removed_at && !explained.removed_at().empty()) {
        const auto& gone = explained.removed_at();
        const int last = *std::max_element(gone.begin(), gone.end());
        for (int level = 1; level <= last; ++level) {
            legend.entries.push_back({removal_colour(level), "level " + std::to_string(level)});
        }
        legend.entries.push_back({removal_colour(0), "never"});
    }
    return legend;
}

/// Gives the legend its margin, and the mesh the rest.
void MeshScene::Impl::lay_out() {
    const Area whole = whole_area();
    const double em = text_size * pixel_ratio;
    const double wanted = std::ceil(gui::legend_width(legend(), em));
    legend_width = wanted <= 0.45 * whole.width ? wanted : 0;
    const double split = whole.width > 0 ? viewport_.right - legend_width / whole.width *
                                                                 (viewport_.right - viewport_.left)
                                         : viewport_.right;
    renderer->SetViewport(viewport_.left, viewport_.bottom, split, viewport_.top);
    margin_->SetViewport(split, viewport_.bottom, viewport_.right, viewport_.top);
    margin_->SetDraw(legend_width > 0);
    over_->SetViewport(viewport_.left, viewport_.bottom, viewport_.right, viewport_.top);
}

void MeshScene::Impl::draw_handle(const ViewFrame& view) {
    const double u = pixel_ratio;
    const Area whole = whole_area();
    HandleShape shape = handle_shape(options.clip, view, handle_length * u);
    for (Pixel* p : {&shape.foot, &shape.tip}) {
        (*p)[0] -= whole.left;
        (*p)[1] -= whole.bottom;
    }
    const auto [foot, tip] = shape;
    const double length = std::hypot(tip[0] - foot[0], tip[1] - foot[1]);
    const double x = (tip[0] - foot[0]) / length;
    const double y = (tip[1] - foot[1]) / length;
    constexpr Rgb rim{255, 255, 255};
    constexpr Rgb body{30, 110, 230};
    overlay_.line(foot[0], foot[1], tip[0], tip[1], 7 * u, rim);
    overlay_.line(foot[0], foot[1], tip[0], tip[1], 4 * u, body);
    overlay_.circle(foot[0], foot[1], 4 * u, 5 * u, body);
    overlay_.polygon({{tip[0] + 16 * u * x, tip[1] + 16 * u * y},
                      {tip[0] - 8 * u * y, tip[1] + 8 * u * x},
                      {tip[0] + 8 * u * y, tip[1] - 8 * u * x}},
                     body);
}

void MeshScene::Impl::draw_overlay() {
    const ViewFrame view = frame();
    const Area whole = whole_area();
    const Area area{0, 0, whole.width - legend_width, whole.height};
    const double em = text_size * pixel_ratio;
    const Rgb& ink = options.dark ? dark_ink : light_ink;
    const Rgb& paper = options.dark ? dark_background : light_background;
    overlay_.clear();
    if (data != nullptr) {
        if (legend_width > 0) {
            draw_legend(overlay_, legend(), {area.width, 0, legend_width, whole.height}, em, ink);
        }
        if (options.axes) {
            draw_axes(overlay_, area, em, view.right, view.up, view.sight, data->dimension, ink,
                      paper);
        }
        if (options.scale_bar && !is_view_scaled(options) && area.width > 12 * em) {
            draw_scale_bar(overlay_, area, em, view.units_per_pixel, ink, paper);
        }
        const std::string& text = caption.empty() ? data->name() : caption;
        if (marked && marked->index() < data->node_count && !is_clipped_away(*marked)) {
            const auto [x, y] = view.pixel_of(data->position(*marked));
            overlay_.circle(x - whole.left, y - whole.bottom, 0.6 * em, 0.14 * em, mark_colour);
        }
        if (handles && options.clip.enabled) {
            draw_handle(view);
        }
        draw_titles(overlay_, area, em, text, scale_label(), ink, paper);
    }
    if (viewport_.left > 0) {
        overlay_.line(0, 0, 0, whole.height, 2 * pixel_ratio, {150, 153, 160});
    }
    overlay_.finish();
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

std::string MeshScene::Impl::scale_label() const {
    if (!is_view_scaled(options)) {
        return {};
    }
    std::string text = "VIEW SCALED";
    for (int k = 0; k < 3; ++k) {
        if (options.view_scale[k] != 1) {
            text += std::string("   ") + "xyz"[k] + " \u00d7 " + number(options.view_scale[k]);
        }
    }
    if (options.lens.enabled && options.lens.factor != 1) {
        text += "   wall normal \u00d7 " + number(options.lens.factor);
    }
    return text;
}

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
    if (!has_scale(impl_->options.colour)) {
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
