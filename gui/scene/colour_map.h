// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Colours for numbers and for things.
#pragma once

#include "gui/bridge/to_vtk.h"

namespace ameco::gui {

/// Viridis: equal steps of the number look like equal steps of the colour, also in print and to
/// the colour-blind. \param t  in [0, 1], clamped
[[nodiscard]] Rgb sequential_colour(double t);
/// Blue below, nearly white at 1/2, red above. \param t  in [0, 1], clamped
[[nodiscard]] Rgb diverging_colour(double t);
/// The colour of patch or level number `index`, soft enough to put black edges on; repeats.
[[nodiscard]] Rgb category_colour(std::size_t index);

inline constexpr Rgb inside_colour{233, 226, 208}; ///< of what a clip plane lays open
inline constexpr Rgb plain_colour{200, 208, 219};  ///< of a surface without colours

} // namespace ameco::gui
