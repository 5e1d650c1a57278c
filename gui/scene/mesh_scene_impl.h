// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The inside of a MeshScene: what has to be made anew, and the actors it is made in.
#pragma once

#include "gui/scene/legend.h"
#include "gui/scene/mesh_scene.h"
#include "gui/scene/metric_glyphs.h"
#include "gui/scene/overlay.h"
#include "gui/scene/scene_actor.h"
#include "gui/scene/scene_values.h"
#include "gui/scene/view_frame.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace ameco::gui {

inline constexpr double text_size = 14;     ///< [units of prepare's pixel ratio]
inline constexpr double handle_length = 90; ///< of the clip plane's handle [the same]

inline constexpr Rgb light_background{255, 255, 255};
inline constexpr Rgb dark_background{30, 33, 40};
inline constexpr Rgb light_ink{25, 27, 32};
inline constexpr Rgb dark_ink{232, 234, 238};

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
    [[nodiscard]] ColourBy colour() const; ///< that can be shown: none for one that lacks a metric

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

} // namespace ameco::gui
