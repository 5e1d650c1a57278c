// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the colours mean, and other things written beside and over a picture.
#pragma once

#include "gui/scene/camera.h"
#include "gui/scene/overlay.h"
#include "gui/scene/scene_values.h"

#include <string>
#include <vector>

namespace ameco::gui {

/// One colour and what it stands for.
struct LegendEntry {
    Rgb colour;
    std::string text;
};

/// A legend: a scale of numbers, or a list of colours.
struct Legend {
    std::string title;
    ColourBy colour = ColourBy::none;
    std::optional<Range> range;       ///< of a scale
    std::vector<LegendEntry> entries; ///< of a list
};

/// Part of a renderer's viewport [device pixels].
struct Area {
    double left = 0, bottom = 0, width = 0, height = 0;
};

/// Four digits, without what they do not need: 0.25, 10000, 1e-5, 2e6.
[[nodiscard]] std::string short_number(double value);

/// Round numbers in a range, not too many: 1, 2, 5 and powers of ten.
[[nodiscard]] std::vector<double> ticks(const Range& range, bool logarithmic, int about);

/// Width that the legend wants [device pixels]; 0 for an empty one.
/// \param em  size of the text [device pixels]
[[nodiscard]] double legend_width(const Legend& legend, double em);
void draw_legend(Overlay& overlay, const Legend& legend, const Area& area, double em,
                 const Rgb& ink);

/// The largest round length (1, 2 or 5 times a power of ten) up to `longest`.
[[nodiscard]] double round_length(double longest);

/// \param units_per_pixel  [L per device pixel]
void draw_scale_bar(Overlay& overlay, const Area& area, double em, double units_per_pixel,
                    const Rgb& ink, const Rgb& paper);

/// The axes' directions. \param right, up, sight  of the view, orthonormal
void draw_axes(Overlay& overlay, const Area& area, double em, const Vec3& right, const Vec3& up,
               const Vec3& sight, int dimension, const Rgb& ink, const Rgb& paper);

/// At the top: the caption on the left, on paper that lets some of the picture through, and a
/// warning in the middle that is not to be overlooked; below each other where the view is narrow.
/// Either may be empty.
void draw_titles(Overlay& overlay, const Area& area, double em, const std::string& caption,
                 const std::string& warning, const Rgb& ink, const Rgb& paper);

} // namespace ameco::gui
