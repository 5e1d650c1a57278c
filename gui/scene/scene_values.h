// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The numbers that colours stand for.
#pragma once

#include "gui/scene/colour_map.h"
#include "gui/scene/scene_data.h"
#include "gui/scene/visible_surface.h"

#include <optional>
#include <utility>

namespace ameco::gui {

/// Whether the colour stands for a number at nodes (else elements have it, or it is none).
[[nodiscard]] bool is_nodal(ColourBy colour);
/// Whether there is a scale of numbers.
[[nodiscard]] bool has_scale(ColourBy colour);

/// Aspect ratio, h1, h2 or h3 of a node.
[[nodiscard]] double node_value(const SceneData& data, ColourBy colour, NodeId node);
/// Quality or edge length of an element.
[[nodiscard]] double element_value(const SceneData& data, ColourBy colour, ElementId element);

using Range = std::pair<double, double>;

/// The range of a colour scale: of the values at all nodes; [0, 1] for qualities, and [1/4, 4] for
/// lengths, whose aim is 1.
[[nodiscard]] Range range_of(const SceneData& data, ColourBy colour);
/// Where a value lies in a range, 0 ... 1 inside.
[[nodiscard]] double place_in(const Range& range, bool logarithmic, double value);

/// Colour of a patch in 3-D, a region in 2-D; what is far away is grey.
[[nodiscard]] Rgb patch_colour(const SceneData& data, int patch);
/// Colour of a level on which nodes are gone; grey for 0, nodes that stay.
[[nodiscard]] Rgb removal_colour(int level);
/// Colour of a value of `colour` at the place `t` of its scale.
[[nodiscard]] Rgb scale_colour(ColourBy colour, double t);

/// Colours of the polygons, where they do not come from nodes.
[[nodiscard]] std::vector<Rgb> polygon_colours(const SceneData& data, const VisibleSurface& surface,
                                               ColourBy colour, const Range& range);
/// Places in the scale of the surface's points.
[[nodiscard]] std::vector<float> point_places(const SceneData& data, const VisibleSurface& surface,
                                              ColourBy colour, const Range& range);

} // namespace ameco::gui
