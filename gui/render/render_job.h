// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the program asks the renderer, a module that it loads when it needs pictures.
///
/// Program and module are built together, so they hand each other ordinary types; only exceptions
/// stay where they are thrown.
#pragma once

#include "core/base/error.h"
#include "core/base/monitor.h"
#include "gui/scene/camera.h"
#include "gui/scene/scene_input.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ameco::gui {

/// Where to look. What is not given follows from the mesh.
struct LookOptions {
    StandardView view = StandardView::corner; ///< 2-D: plus_z unless `view_given`
    bool view_given = false;
    std::optional<Vec3> from;     ///< direction from the mesh to the eye, instead of `view`
    std::optional<Vec3> up;       ///< direction that is upwards in the picture
    std::optional<Vec3> focus;    ///< the place in the middle [L]
    std::optional<double> height; ///< of the view, in the scaled view [L]
    double zoom = 1;              ///< > 0; larger shows less

    friend bool operator==(const LookOptions&, const LookOptions&) = default;
};

/// One picture: a panel per level, side by side, all seen by the same camera.
struct RenderJob {
    std::vector<std::variant<SceneInput<3>, SceneInput<2>>> levels; ///< at least one
    std::vector<Mean> means; ///< of ellipsoids: each level has a panel for each; empty: the scene's
    SceneOptions scene;
    bool hide_outer = true; ///< hides what would hide the wall, beside the scene's hidden patches
    LookOptions look;
    std::optional<NodeId> node; ///< of the first level: marked, its place in all levels
    int width = 1600;           ///< of the whole picture [pixels]
    int height = 1000;
    double text_scale = 1; ///< size of texts and lines
    bool transparent = false;
    int threads = 0; ///< as in set_thread_count
    Monitor* monitor = nullptr;
};

struct RenderResult {
    std::string png;   ///< bytes of the file
    std::string error; ///< one line; empty when all went well
    ExitCode code = ExitCode::ok;
    std::size_t triangles = 0; ///< shown, of all panels
    std::size_t ellipsoids = 0;
    std::optional<std::pair<double, double>> range; ///< of the colours
    std::string scale_label;
};

/// Entry of the module ameco_render. Throws nothing.
using RenderFunction = void(const RenderJob& job, RenderResult& result);
inline constexpr const char* render_module = "ameco_render";
inline constexpr const char* render_symbol = "ameco_render_picture";

} // namespace ameco::gui
