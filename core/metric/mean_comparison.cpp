// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/mean_comparison.h"

#include "core/base/error.h"
#include "core/base/svg.h"
#include "core/metric/element_metric.h"
#include "core/metric/geodesic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ameco {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Angle of two unit vectors, whichever way they point.
template <int D>
double angle_between(const Vec<D>& a, const Vec<D>& b) {
    const double along = a.dot(b);
    return std::atan2((b - along * a).norm(), std::abs(along));
}

/// The part of a unit ball that lies in the plane of two directions, in units of `width` and
/// `height` along them.
template <int D>
Metric<2> section(const Metric<D>& metric, const Metric<D>& view) {
    Eigen::Matrix<double, D, 2> axes;
    axes << view.directions.col(D - 1) * view.sizes[D - 1], view.directions.col(0) * view.sizes[0];
    const Eigen::Matrix<double, D, 2> F = length_factor(metric) * axes;
    return from_tensor<2>(
        Tensor<2>{F.col(0).squaredNorm(), F.col(0).dot(F.col(1)), F.col(1).squaredNorm()});
}

/// Outline of a unit ball as the `d` of a path, one unit being `scale` pixels.
std::string outline(const Metric<2>& ball, double scale) {
    constexpr int points = 180;
    std::string path;
    for (int n = 0; n < points; ++n) {
        const double angle = 2 * std::numbers::pi * n / points;
        const Vec<2> x = ball.directions *
                         ball.sizes.cwiseProduct(Vec<2>(std::cos(angle), std::sin(angle))) * scale;
        path += (n == 0 ? "M" : "L") + svg::number(x[0], 1) + " " + svg::number(-x[1], 1);
    }
    return path + "Z";
}

template <int D>
std::string sizes_text(const Metric<D>& metric) {
    std::string text;
    for (const double h : metric.sizes) {
        text += (text.empty() ? "" : ", ") + svg::short_number(h);
    }
    return text;
}

} // namespace

template <int D>
MeanComparison<D> compare_means(const Mesh<D>& mesh, NodeId node) {
    MeanComparison<D> comparison{node, {}, {}};
    for (const Simplex<D>& s : mesh.elements) {
        if (std::find(s.begin(), s.end(), node) != s.end()) {
            comparison.elements.push_back(element_metric<D>(corners_of<D>(mesh, s)));
        }
    }
    const Metric<D> corrected = mean_of<D>(comparison.elements, Mean::corrected);
    for (const Mean mean : all_means) {
        ComparedMean<D> row;
        row.mean = mean;
        try {
            row.metric = mean_of<D>(comparison.elements, mean);
            row.turn_deg =
                angle_between<D>(row.metric.directions.col(0), corrected.directions.col(0)) /
                degree;
            row.distance = invariant_distance(row.metric, corrected);
        } catch (const NotConverged&) {
            row.failure = "does not converge";
        }
        comparison.means.push_back(std::move(row));
    }
    return comparison;
}

template <int D>
std::string unit_balls_svg(const MeanComparison<D>& comparison) {
    constexpr double side = 440, margin = 20, top = 56, unit = side / 8;
    constexpr double alike = 0.01;
    const Metric<D>& view = comparison.means.front().metric;
    std::string picture = svg::open(side + 2 * margin + 330, side + top + margin);
    picture += svg::text_at(margin, 24,
                            "Unit balls at node " + std::to_string(comparison.node.value()) + ", " +
                                std::to_string(comparison.elements.size()) + " elements");
    picture += svg::text_at(margin, 42,
                            "view scaled " + svg::short_number(aspect_ratio(view)) +
                                " times upwards, along the short direction");
    picture += "<defs><clipPath id=\"w\"><rect x=\"" + svg::number(-side / 2) + "\" y=\"" +
               svg::number(-side / 2) + "\" width=\"" + svg::number(side) + "\" height=\"" +
               svg::number(side) + "\"/></clipPath></defs>\n<g transform=\"translate(" +
               svg::number(margin + side / 2) + " " + svg::number(top + side / 2) +
               ")\" clip-path=\"url(#w)\"><rect x=\"" + svg::number(-side / 2) + "\" y=\"" +
               svg::number(-side / 2) + "\" width=\"" + svg::number(side) + "\" height=\"" +
               svg::number(side) + "\" fill=\"#f4f6f8\"/>\n";
    std::string legend;
    double y = top + 14;
    std::vector<const ComparedMean<D>*> drawn;
    for (std::size_t k = 0; k < comparison.means.size(); ++k) {
        const ComparedMean<D>& m = comparison.means[k];
        const char* colour = svg::colours[k % svg::colours.size()];
        const double x = 2 * margin + side;
        std::string text = std::string(name(m.mean)) + ": ";
        if (!m.failure.empty()) {
            text += m.failure;
        } else {
            text += sizes_text<D>(m.metric);
            const auto twin = std::find_if(drawn.begin(), drawn.end(), [&](const auto* other) {
                return invariant_distance(other->metric, m.metric) <= alike;
            });
            if (twin == drawn.end()) {
                picture += std::string("<path fill=\"none\" stroke=\"") + colour +
                           "\" stroke-width=\"1.6\" d=\"" +
                           outline(section<D>(m.metric, view), unit) + "\"/>\n";
                drawn.push_back(&m);
            } else {
                colour =
                    svg::colours[static_cast<std::size_t>((*twin)->mean) % svg::colours.size()];
            }
        }
        legend += "<rect x=\"" + svg::number(x) + "\" y=\"" + svg::number(y - 10) +
                  "\" width=\"12\" height=\"12\" fill=\"" +
                  (m.failure.empty() ? colour : "#ffffff") + "\"/>\n" +
                  svg::text_at(x + 18, y, text);
        y += 20;
    }
    return picture + "</g>\n" + legend +
           svg::text_at(2 * margin + side, y + 10, "sizes, shortest first") + "</svg>\n";
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template MeanComparison<D> compare_means(const Mesh<D>&, NodeId);                              \
    template std::string unit_balls_svg(const MeanComparison<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
