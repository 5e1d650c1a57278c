// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What our Gmsh files say in $Comments.
#pragma once

#include <string_view>

namespace ameco::gmsh {

/// Gmsh has no physical tag 0. Where all cells of a dimension have the label 0 there is thus no
/// physical tag, and a reader would take the elementary tags for labels.
inline constexpr std::string_view zero_labels_comment =
    "ameco: without physical tag the label is 0";

} // namespace ameco::gmsh
