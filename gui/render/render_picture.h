// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Pictures without a screen.
#pragma once

#include "gui/render/render_job.h"

#include <vector>

namespace ameco::gui {

/// A picture in memory.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<unsigned char> rgba; ///< [height][width][4], from the top down
};

/// Draws the picture, with the same scenes as the window.
/// \throws Error  when this machine has no OpenGL (not_built), or the job makes no sense (usage)
[[nodiscard]] Picture render_picture(const RenderJob& job, RenderResult& result);

/// The picture as a PNG file.
[[nodiscard]] std::string to_png(const Picture& picture);

} // namespace ameco::gui
