// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What stands beside and over the mesh.
#include "gui/scene/mesh_scene_impl.h"

#include <algorithm>
#include <cmath>

namespace ameco::gui {
namespace {

constexpr Rgb mark_colour{235, 20, 120};

} // namespace

Legend MeshScene::Impl::legend() const {
    Legend legend;
    if (!options.legend || data == nullptr) {
        return legend;
    }
    const SceneData& explained = legend_data != nullptr ? *legend_data : *data;
    legend.title = title(colour());
    legend.colour = colour();
    if (has_scale(colour())) {
        legend.range = scale_range();
    } else if (colour() == ColourBy::patch) {
        for (const int patch : explained.patches) {
            if (!options.hidden_patches.contains(patch)) {
                legend.entries.push_back(
                    {patch_colour(explained, patch), explained.patch_name(patch)});
            }
        }
    } else if (colour() == ColourBy::removed_at && !explained.removed_at().empty()) {
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
    through_->SetViewport(viewport_.left, viewport_.bottom, split, viewport_.top);
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

std::string MeshScene::Impl::scale_label() const {
    if (!is_view_scaled(options)) {
        return {};
    }
    std::string text = "VIEW SCALED";
    for (int k = 0; k < 3; ++k) {
        if (options.view_scale[k] != 1) {
            text +=
                std::string("   ") + "xyz"[k] + " \u00d7 " + short_number(options.view_scale[k]);
        }
    }
    if (options.lens.enabled && options.lens.factor != 1) {
        text += "   wall normal \u00d7 " + short_number(options.lens.factor);
    }
    return text;
}

} // namespace ameco::gui
