// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The options of `ameco render`, and what they ask of the renderer.
#pragma once

#include "gui/render/render_job.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ameco::cli {

/// What was given on the command line, as text where it is not a plain number.
struct RenderOptions {
    std::vector<std::string> inputs; ///< meshes, or folders of levels
    std::vector<int> levels{0};      ///< of a folder
    std::string output;
    std::string size = "1600x1000";
    std::string view, from, up, focus;
    std::string colour = "patch", representation = "edges", range;
    std::vector<std::string> hide;
    std::string clip, clip_normal = "1,0,0";
    std::string scale = "1,1,1";
    std::string lens_at, lens_normal;
    std::string ellipsoids = "none", source = "natural";
    std::vector<std::string> means; ///< one panel for each
    double zoom = 1, height = 0, text_scale = 1, lens = 1;
    int node = -1;
    int max_ellipsoids = static_cast<int>(gui::EllipsoidOptions{}.max_count);
    double ellipsoid_scale = gui::EllipsoidOptions{}.scale;
    double compress = gui::EllipsoidOptions{}.compress;
    double factor = TargetOptions{}.factor;
    bool all_patches = false, cut = false, flip = false;
    bool dark = false, transparent = false, no_legend = false, no_axes = false;
};

void add_render_options(CLI::App& app, RenderOptions& options);

/// Everything but the levels, and what needs them: patches given by name, the lens' normal.
[[nodiscard]] gui::RenderJob render_job(const RenderOptions& options);

/// "1,0.5,-3" as a vector.
[[nodiscard]] Vec<3> vector_from(const std::string& text);

} // namespace ameco::cli
