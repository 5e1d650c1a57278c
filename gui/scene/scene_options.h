// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Everything a view shows, as plain data: sessions store it, `ameco render` fills it from options.
#pragma once

#include "core/base/vec.h"
#include "core/coarsen/target_metric.h"
#include "core/metric/means.h"

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace ameco::gui {

using Vec3 = Vec<3>; ///< of a 2-D mesh the third component is 0

enum class Representation { surface, surface_with_edges, wireframe };

inline constexpr std::array all_representations{
    Representation::surface, Representation::surface_with_edges, Representation::wireframe};

[[nodiscard]] std::string_view name(Representation representation);
[[nodiscard]] std::optional<Representation> representation_from_name(std::string_view name);

enum class ColourBy {
    none,         ///< one light colour
    patch,        ///< boundary patch (3-D), region (2-D)
    aspect_ratio, ///< h_D / h_1 of the node [-], logarithmic
    h1,           ///< smallest size of the natural metric at the node [L], logarithmic
    h2,           ///< second size, in 2-D the largest one
    h3,           ///< largest size; in 2-D the same as h2
    quality,      ///< modified quality of the element in the natural metric, section 4.4, in [0, 1]
    quality_original, ///< Q_F Q_S, equations (16), (17), (19), in [0, 1]
    edge_length,      ///< the element's edge whose length in the metric is farthest from 1 [-]
    removed_at        ///< level on which the node is missing first
};

inline constexpr std::array all_colours{
    ColourBy::none,        ColourBy::patch,     ColourBy::aspect_ratio, ColourBy::h1,
    ColourBy::h2,          ColourBy::h3,        ColourBy::quality,      ColourBy::quality_original,
    ColourBy::edge_length, ColourBy::removed_at};

/// "aspect-ratio", "h1", ...
[[nodiscard]] std::string_view name(ColourBy colour);
[[nodiscard]] std::optional<ColourBy> colour_from_name(std::string_view name);
/// "aspect ratio", "smallest size h1 [L]", ...: over a legend, in a menu.
[[nodiscard]] std::string_view title(ColourBy colour);
/// Whether the legend's scale is logarithmic.
[[nodiscard]] bool is_logarithmic(ColourBy colour);

/// What lies in front of the plane, where (x - origin) . normal > 0, is not shown.
struct ClipPlane {
    bool enabled = false;
    Vec3 origin = Vec3::Zero(); ///< [L]
    Vec3 normal{1, 0, 0};       ///< of any length but 0
    bool crinkle = true;        ///< elements that the plane cuts are shown whole, else they are cut
    bool keep_other_side = false;

    friend bool operator==(const ClipPlane&, const ClipPlane&) = default;
};

/// Boundary-layer lens: stretches the view along the normal of the wall at a place.
struct Lens {
    bool enabled = false;
    Vec3 origin = Vec3::Zero(); ///< on the wall [L]; stays where it is
    Vec3 normal{0, 0, 1};       ///< of any length but 0
    double factor = 1;          ///< offsets along the normal are shown this many times larger, > 0

    friend bool operator==(const Lens&, const Lens&) = default;
};

enum class EllipsoidSource {
    natural, ///< the natural metric of the mesh
    target   ///< what coarsening makes of it
};

/// Unit balls of metrics.
struct EllipsoidOptions {
    enum class Where {
        none,
        picked,     ///< at the marked node
        clip_plane, ///< at nodes of elements that the clip plane cuts
        sample      ///< at nodes spread over what is shown
    };
    Where where = Where::none;
    EllipsoidSource source = EllipsoidSource::natural;
    Mean mean = Mean::blended;
    TargetOptions target;        ///< for EllipsoidSource::target
    std::size_t max_count = 500; ///< at most [2000] are drawn
    double scale = 0.5;  ///< half axes are this times the sizes; 1/2: the balls of two ends of
                         ///< an edge of length 1 touch
    double compress = 1; ///< in (0, 1]: an aspect ratio AR is drawn as AR^compress; 1 is true

    friend bool operator==(const EllipsoidOptions&, const EllipsoidOptions&) = default;
};

struct SceneOptions {
    Representation representation = Representation::surface_with_edges;
    ColourBy colour = ColourBy::patch;
    ClipPlane clip;
    Vec3 view_scale{1, 1, 1}; ///< per axis, 1 ... 1e6
    Lens lens;
    EllipsoidOptions ellipsoids;
    std::set<int> hidden_patches;
    std::optional<std::pair<double, double>> range; ///< of the legend; empty: that of the data
    bool dark = false;
    bool axes = true;
    bool scale_bar = true;
    bool legend = true;

    friend bool operator==(const SceneOptions&, const SceneOptions&) = default;
};

/// Whether positions are not shown as they are.
[[nodiscard]] bool is_view_scaled(const SceneOptions& options);

} // namespace ameco::gui
