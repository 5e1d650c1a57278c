// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/scene_options.h"

#include <algorithm>

namespace ameco::gui {
namespace {

template <class Value, std::size_t N>
std::optional<Value> value_of(const std::array<Value, N>& all, std::string_view wanted) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](Value v) { return name(v) == wanted; });
    return found == all.end() ? std::nullopt : std::optional<Value>(*found);
}

} // namespace

std::string_view name(Representation representation) {
    switch (representation) {
    case Representation::surface:
        return "surface";
    case Representation::surface_with_edges:
        return "edges";
    case Representation::wireframe:
        return "wireframe";
    }
    return "";
}

std::optional<Representation> representation_from_name(std::string_view wanted) {
    return value_of(all_representations, wanted);
}

std::string_view name(ColourBy colour) {
    switch (colour) {
    case ColourBy::none:
        return "none";
    case ColourBy::patch:
        return "patch";
    case ColourBy::aspect_ratio:
        return "aspect-ratio";
    case ColourBy::h1:
        return "h1";
    case ColourBy::h2:
        return "h2";
    case ColourBy::h3:
        return "h3";
    case ColourBy::quality:
        return "quality";
    case ColourBy::quality_original:
        return "quality-original";
    case ColourBy::edge_length:
        return "edge-length";
    case ColourBy::removed_at:
        return "removed-at";
    }
    return "";
}

std::optional<ColourBy> colour_from_name(std::string_view wanted) {
    return value_of(all_colours, wanted);
}

std::string_view title(ColourBy colour) {
    switch (colour) {
    case ColourBy::none:
        return "";
    case ColourBy::patch:
        return "patch";
    case ColourBy::aspect_ratio:
        return "aspect ratio";
    case ColourBy::h1:
        return "size h1";
    case ColourBy::h2:
        return "size h2";
    case ColourBy::h3:
        return "size h3";
    case ColourBy::quality:
        return "quality, modified";
    case ColourBy::quality_original:
        return "quality, original";
    case ColourBy::edge_length:
        return "metric length";
    case ColourBy::removed_at:
        return "node gone on";
    }
    return "";
}

bool is_logarithmic(ColourBy colour) {
    switch (colour) {
    case ColourBy::aspect_ratio:
    case ColourBy::h1:
    case ColourBy::h2:
    case ColourBy::h3:
    case ColourBy::edge_length:
        return true;
    default:
        return false;
    }
}

bool is_view_scaled(const SceneOptions& options) {
    return options.view_scale != Vec3(1, 1, 1) ||
           (options.lens.enabled && options.lens.factor != 1);
}

} // namespace ameco::gui
