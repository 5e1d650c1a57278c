// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/convergence_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ameco {
namespace {

constexpr int width = 640, height = 420, left = 60, right = 20, top = 20, bottom = 40;

/// Pixels, rounded to tenths.
std::string pixels(double value) {
    const std::string text = std::to_string(std::lround(value * 10));
    return text.size() > 1 ? text.substr(0, text.size() - 1) + '.' + text.back() : "0." + text;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return out;
}

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
    return "<line x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" + pixels(x2) +
           "\" y2=\"" + pixels(y2) + "\" stroke=\"" + colour + "\"/>\n";
}

std::string text(double x, double y, const std::string& what, const char* colour = "#000") {
    return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" fill=\"" + colour + "\">" +
           escaped(what) + "</text>\n";
}

std::string grid(const Axes& axes) {
    std::string svg;
    for (int decade = 0; decade >= static_cast<int>(axes.lowest); --decade) {
        const double y = axes.y(std::pow(10.0, decade));
        svg += line(left, y, width - right, y, "#ddd");
        svg += text(8, y + 4, "1e" + std::to_string(decade));
    }
    const int step = std::max(1, static_cast<int>(axes.most_iterations / 10));
    for (int i = 0; i <= static_cast<int>(axes.most_iterations); i += step) {
        svg += line(axes.x(i), height - bottom, axes.x(i), height - bottom + 4, "#000");
        svg += text(axes.x(i) - 4, height - bottom + 18, std::to_string(i));
    }
    return svg + text(width / 2.0 - 30, height - 6, "iterations");
}

} // namespace

std::string convergence_plot(const std::vector<ConvergenceCurve>& curves) {
    // Colours that stay apart for colour-blind readers (Okabe and Ito).
    constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
    const Axes axes = axes_for(curves);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width) +
                      "\" height=\"" + std::to_string(height) +
                      "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
                      grid(axes);
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const char* const colour = colours[k % colours.size()];
        svg += "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" + std::string(colour) +
               "\" points=\"";
        for (std::size_t i = 0; i < curves[k].residuals.size(); ++i) {
            svg += pixels(axes.x(static_cast<double>(i))) + ',' +
                   pixels(axes.y(curves[k].residuals[i])) + ' ';
        }
        svg += "\"/>\n";
        svg += text(width - 300, top + 16 + 16 * static_cast<double>(k), curves[k].title, colour);
    }
    return svg + "</svg>\n";
}

} // namespace ameco
