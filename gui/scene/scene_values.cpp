// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/scene_values.h"

#include "core/mesh/simplex.h"
#include "core/metric/edge_length.h"
#include "core/remesh/metric_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ameco::gui {
namespace {

constexpr Rgb far_colour{240, 241, 244};

template <int D>
double size_value(const Metric<D>& metric, ColourBy colour) {
    switch (colour) {
    case ColourBy::h1:
        return metric.sizes[0];
    case ColourBy::h2:
        return metric.sizes[1];
    case ColourBy::h3:
        return metric.sizes[D - 1];
    default:
        return aspect_ratio(metric);
    }
}

/// The length farthest from 1, as a ratio, of the element's edges.
template <int D>
double worst_length(const std::array<Vec<D>, D + 1>& x,
                    const std::array<Metric<D>, D + 1>& metrics) {
    double worst = 1;
    for (const auto& [i, j] : SimplexNumbering<D>::edges) {
        const Vec<D> e = x[j] - x[i];
        const double l = edge_length(length<D>(metrics[i], e), length<D>(metrics[j], e));
        if (std::abs(std::log(l)) > std::abs(std::log(worst))) {
            worst = l;
        }
    }
    return worst;
}

template <int D>
double value_of(const SceneInput<D>& input, ColourBy colour, ElementId element) {
    const Simplex<D>& s = input.mesh->elements[element];
    const auto x = corners_of(*input.mesh, s);
    std::array<Metric<D>, D + 1> metrics;
    std::transform(s.begin(), s.end(), metrics.begin(),
                   [&](NodeId i) { return (*input.natural)[i]; });
    if (colour == ColourBy::edge_length) {
        return worst_length<D>(x, metrics);
    }
    const MetricQualities q = metric_qualities<D>(x, metrics);
    return colour == ColourBy::quality ? q.modified : q.original;
}

} // namespace

bool is_nodal(ColourBy colour) {
    return colour == ColourBy::aspect_ratio || colour == ColourBy::h1 || colour == ColourBy::h2 ||
           colour == ColourBy::h3;
}

bool has_scale(ColourBy colour) {
    return colour != ColourBy::none && colour != ColourBy::patch && colour != ColourBy::removed_at;
}

double node_value(const SceneData& data, ColourBy colour, NodeId node) {
    return std::visit([&](const auto& input) { return size_value((*input.natural)[node], colour); },
                      data.input);
}

double element_value(const SceneData& data, ColourBy colour, ElementId element) {
    return std::visit([&](const auto& input) { return value_of(input, colour, element); },
                      data.input);
}

Range range_of(const SceneData& data, ColourBy colour) {
    if (colour == ColourBy::edge_length) {
        return {0.25, 4};
    }
    if (!is_nodal(colour)) {
        return {0, 1};
    }
    Range range{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < data.node_count; ++i) {
        const double value = node_value(data, colour, NodeId(i));
        range.first = std::min(range.first, value);
        range.second = std::max(range.second, value);
    }
    if (colour == ColourBy::aspect_ratio) {
        range.first = 1;
    }
    // The same size everywhere, to rounding: a scale needs some length.
    if (!(range.second > range.first * 1.001)) {
        range.first /= 1.05;
        range.second *= 1.05;
    }
    return range;
}

double place_in(const Range& range, bool logarithmic, double value) {
    if (logarithmic) {
        return std::log(value / range.first) / std::log(range.second / range.first);
    }
    return (value - range.first) / (range.second - range.first);
}

Rgb patch_colour(const SceneData& data, int patch) {
    if (std::binary_search(data.outer.begin(), data.outer.end(), patch)) {
        return far_colour;
    }
    const auto at = std::lower_bound(data.patches.begin(), data.patches.end(), patch);
    return category_colour(static_cast<std::size_t>(at - data.patches.begin()));
}

Rgb removal_colour(int level) {
    return level == 0 ? Rgb{120, 124, 130} : category_colour(static_cast<std::size_t>(level - 1));
}

Rgb scale_colour(ColourBy colour, double t) {
    return colour == ColourBy::edge_length ? diverging_colour(t) : sequential_colour(t);
}

std::vector<Rgb> polygon_colours(const SceneData& data, const VisibleSurface& surface,
                                 ColourBy colour, const Range& range) {
    std::vector<Rgb> colours(surface.polygons.size(), plain_colour);
    const bool scale = has_scale(colour);
    for (std::size_t p = 0; p < colours.size(); ++p) {
        const ElementId element = surface.elements[p];
        if (scale && element.valid()) {
            const double value = element_value(data, colour, element);
            colours[p] = scale_colour(colour, place_in(range, is_logarithmic(colour), value));
        } else if (!surface.faces[p].valid() && data.dimension == 3) {
            colours[p] = inside_colour;
        } else if (colour == ColourBy::patch && data.dimension == 3) {
            colours[p] = patch_colour(data, data.triangle_patch[surface.faces[p].index()]);
        }
    }
    return colours;
}

std::vector<float> point_places(const SceneData& data, const VisibleSurface& surface,
                                ColourBy colour, const Range& range) {
    std::vector<float> places;
    places.reserve(surface.point_count());
    const bool logarithmic = is_logarithmic(colour);
    const auto place = [&](NodeId i) {
        return place_in(range, logarithmic, node_value(data, colour, i));
    };
    for (const NodeId i : surface.nodes) {
        places.push_back(static_cast<float>(place(i)));
    }
    for (const CutPoint& c : surface.cuts) {
        const double a = place(c.a);
        places.push_back(static_cast<float>(a + c.t * (place(c.b) - a)));
    }
    return places;
}

} // namespace ameco::gui
