// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/convergence_plot.h"

#include "core/base/svg.h"

#include <algorithm>
#include <cmath>

namespace ameco {
namespace {

constexpr int width = 640, height = 420, left = 60, right = 20, top = 20, bottom = 40;

struct Axes {
    double most_iterations = 1;
    double lowest = -1; ///< decade at the bottom

    [[nodiscard]] double x(double iteration) const {
        return left + (width - left - right) * iteration / most_iterations;
    }
    [[nodiscard]] double y(double residual) const {
        const double share = std::clamp(std::log10(residual) / lowest, 0.0, 1.0);
        return top + (height - top - bottom) * share;
    }
};

Axes axes_for(const std::vector<ConvergenceCurve>& curves) {
    Axes axes;
    for (const ConvergenceCurve& c : curves) {
        axes.most_iterations =
            std::max(axes.most_iterations, static_cast<double>(c.residuals.size()) - 1);
        for (const double r : c.residuals) {
            axes.lowest = r > 0 ? std::min(axes.lowest, std::floor(std::log10(r))) : axes.lowest;
        }
    }
    return axes;
}

std::string line(double x1, double y1, double x2, double y2, const char* colour) {
    return "<path d=\"M" + svg::number(x1) + ' ' + svg::number(y1) + 'L' + svg::number(x2) + ' ' +
           svg::number(y2) + "\" stroke=\"" + colour + "\"/>\n";
}

std::string grid(const Axes& axes) {
    std::string out;
    for (int decade = 0; decade >= static_cast<int>(axes.lowest); --decade) {
        const double y = axes.y(std::pow(10.0, decade));
        out += line(left, y, width - right, y, "#dddddd");
        out += svg::text_at(left - 6, y + 4, "1e" + std::to_string(decade), "end");
    }
    const int step = std::max(1, static_cast<int>(axes.most_iterations / 10));
    for (int i = 0; i <= static_cast<int>(axes.most_iterations); i += step) {
        out += line(axes.x(i), height - bottom, axes.x(i), height - bottom + 4, "#222222");
        out += svg::text_at(axes.x(i), height - bottom + 18, std::to_string(i), "middle");
    }
    return out + svg::text_at(width / 2.0, height - 6, "iterations", "middle");
}

} // namespace

std::string convergence_plot(const std::vector<ConvergenceCurve>& curves) {
    const Axes axes = axes_for(curves);
    std::string out = svg::open(width, height) + grid(axes);
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const std::string colour = svg::colours[k % svg::colours.size()];
        out += "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" + colour + "\" points=\"";
        for (std::size_t i = 0; i < curves[k].residuals.size(); ++i) {
            out += svg::number(axes.x(static_cast<double>(i))) + ',' +
                   svg::number(axes.y(curves[k].residuals[i])) + ' ';
        }
        out += "\"/>\n";
        const double y = top + 16 + 16 * static_cast<double>(k);
        out += line(width - 240, y - 4, width - 220, y - 4, colour.c_str());
        out += svg::text_at(width - 214, y, curves[k].title);
    }
    return out + "</svg>\n";
}

} // namespace ameco
