// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/legend.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace ameco::gui {
namespace {

constexpr std::size_t most_entries = 24;
constexpr double paper_opacity = 0.72;

std::vector<LegendEntry> shown_entries(const Legend& legend) {
    std::vector<LegendEntry> entries = legend.entries;
    if (entries.size() > most_entries) {
        const std::size_t more = entries.size() - most_entries;
        entries.resize(most_entries);
        entries.push_back({Rgb{0, 0, 0}, "and " + std::to_string(more) + " more"});
    }
    return entries;
}

std::vector<double> tick_values(const Legend& legend) {
    std::vector<double> values = ticks(*legend.range, is_logarithmic(legend.colour), 6);
    if (values.size() < 2) {
        values = {legend.range->first, legend.range->second};
    }
    return values;
}

} // namespace

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text,
                  std::abs(value) >= 1e4 && std::abs(value) < 1e6 ? "%.0f" : "%.4g", value);
    std::string number = text;
    if (const std::size_t e = number.find('e'); e != std::string::npos) {
        std::size_t digits = e + 2; // after the sign
        while (number[digits] == '0') {
            ++digits;
        }
        number =
            number.substr(0, e + 1) + (number[e + 1] == '-' ? "-" : "") + number.substr(digits);
    }
    return number;
}

std::vector<double> ticks(const Range& range, bool logarithmic, int about) {
    std::vector<double> values;
    const double slack = 1e-9;
    if (logarithmic) {
        const double decades = std::log10(range.second / range.first);
        const int stride = std::max(1, static_cast<int>(std::ceil(decades / about)));
        const bool between = decades < 2;
        for (int k = static_cast<int>(std::floor(std::log10(range.first)));
             std::pow(10, k) <= range.second; k += stride) {
            for (const double m : {1.0, 2.0, 5.0}) {
                const double value = m * std::pow(10.0, k);
                if ((m == 1 || between) && value >= range.first * (1 - slack) &&
                    value <= range.second * (1 + slack)) {
                    values.push_back(value);
                }
            }
        }
        return values;
    }
    const double step = round_length((range.second - range.first) / about * 1.5);
    for (double k = std::ceil(range.first / step - slack); k * step <= range.second + slack * step;
         k += 1) {
        values.push_back(k * step + 0.0); // no -0
    }
    return values;
}

double legend_width(const Legend& legend, double em) {
    double widest = 0;
    if (legend.range) {
        for (const double value : tick_values(legend)) {
            widest = std::max(widest, Overlay::width_of(short_number(value), em) + 2.2 * em);
        }
    }
    for (const LegendEntry& entry : shown_entries(legend)) {
        widest = std::max(widest, Overlay::width_of(entry.text, em) + 1.8 * em);
    }
    if (widest == 0) {
        return 0;
    }
    return std::max(widest, Overlay::width_of(legend.title, em, true)) + 2 * em;
}

void draw_legend(Overlay& overlay, const Legend& legend, const Area& area, double em,
                 const Rgb& ink) {
    const double left = area.left + em;
    if (legend.range) {
        const double height = std::min(0.6 * area.height, 22 * em);
        const double bottom = area.bottom + (area.height - height) / 2 - em;
        overlay.text(left, bottom + height + 1.6 * em, legend.title, em, ink, Align::left, true);
        constexpr int steps = 128;
        for (int k = 0; k < steps; ++k) {
            overlay.fill(left, bottom + height * k / steps, left + 1.2 * em,
                         bottom + height * (k + 1) / steps,
                         scale_colour(legend.colour, (k + 0.5) / steps));
        }
        for (const double value : tick_values(legend)) {
            const double y =
                bottom + height * place_in(*legend.range, is_logarithmic(legend.colour), value);
            overlay.line(left + 1.2 * em, y, left + 1.6 * em, y, em / 12, ink);
            overlay.text(left + 1.9 * em, y, short_number(value), em, ink);
        }
        return;
    }
    const std::vector<LegendEntry> entries = shown_entries(legend);
    const double row = 1.5 * em;
    double y = area.bottom + area.height / 2 + row * static_cast<double>(entries.size()) / 2;
    overlay.text(left, y + 0.3 * em, legend.title, em, ink, Align::left, true);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        y -= row;
        if (k < most_entries) {
            overlay.fill(left, y - em / 2, left + em, y + em / 2, entries[k].colour);
        }
        overlay.text(left + 1.5 * em, y, entries[k].text, em, ink);
    }
}

double round_length(double longest) {
    const double power = std::pow(10, std::floor(std::log10(longest)));
    return (longest >= 5 * power ? 5 : longest >= 2 * power ? 2 : 1) * power;
}

void draw_scale_bar(Overlay& overlay, const Area& area, double em, double units_per_pixel,
                    const Rgb& ink, const Rgb& paper) {
    const double length = round_length(0.22 * area.width * units_per_pixel);
    const double pixels = length / units_per_pixel;
    const double right = area.left + area.width - 1.2 * em;
    const double y = area.bottom + 1.4 * em;
    overlay.fill(right - pixels - 0.6 * em, y - 0.7 * em, right + 0.6 * em, y + 1.8 * em, paper,
                 paper_opacity);
    overlay.line(right - pixels, y, right, y, em / 6, ink);
    for (const double x : {right - pixels, right}) {
        overlay.line(x, y - em / 3, x, y + em / 3, em / 8, ink);
    }
    overlay.text(right - pixels / 2, y + em, short_number(length), em, ink, Align::centre);
}

void draw_axes(Overlay& overlay, const Area& area, double em, const Vec3& right, const Vec3& up,
               const Vec3& sight, int dimension, const Rgb& ink, const Rgb& paper) {
    static constexpr Rgb colours[] = {{205, 55, 50}, {50, 150, 60}, {50, 95, 205}};
    static constexpr const char* names[] = {"x", "y", "z"};
    const double length = 2.4 * em;
    const double x = area.left + 4 * em;
    const double y = area.bottom + 4 * em;
    overlay.disc(x, y, 3.7 * em, paper, paper_opacity);
    std::array<int, 3> order{0, 1, 2}; // from the back to the front
    std::sort(order.begin(), order.end(), [&](int a, int b) { return sight[a] > sight[b]; });
    for (const int k : order) {
        const double dx = right[k] * length;
        const double dy = up[k] * length;
        if (k >= dimension || std::hypot(dx, dy) < 0.05 * length) {
            continue; // points at the eye
        }
        overlay.line(x, y, x + dx, y + dy, em / 6, colours[k]);
        const double tip = std::hypot(dx, dy);
        const double ux = dx / tip;
        const double uy = dy / tip;
        overlay.polygon({{x + dx + 0.5 * em * ux, y + dy + 0.5 * em * uy},
                         {x + dx - 0.25 * em * uy, y + dy + 0.25 * em * ux},
                         {x + dx + 0.25 * em * uy, y + dy - 0.25 * em * ux}},
                        colours[k]);
        overlay.text(x + dx + 1.1 * em * ux, y + dy + 1.1 * em * uy, names[k], em, ink,
                     Align::centre, true);
    }
}

void draw_titles(Overlay& overlay, const Area& area, double em, const std::string& caption,
                 const std::string& warning, const Rgb& ink, const Rgb& paper) {
    const double top = area.bottom + area.height - 1.6 * em;
    double below = top;
    double left = area.left + area.width;
    if (!warning.empty()) {
        double size = 1.25 * em;
        const double widest = area.width - 3 * em;
        size *= std::min(1.0, widest / Overlay::width_of(warning, size, true));
        const double half = Overlay::width_of(warning, size, true) / 2 + em;
        const double x = area.left + area.width / 2;
        overlay.fill(x - half, top - 1.1 * em, x + half, top + 1.1 * em, {255, 193, 37});
        overlay.text(x, top, warning, size, {20, 20, 20}, Align::centre, true);
        left = x - half;
        below = top - 2.4 * em;
    }
    if (!caption.empty()) {
        const double size = 1.15 * em;
        const double right = area.left + 1.5 * em + Overlay::width_of(caption, size, true);
        const double y = right > left ? below : top;
        overlay.fill(area.left + 0.5 * em, y - em, right, y + em, paper, paper_opacity);
        overlay.text(area.left + em, y, caption, size, ink, Align::left, true);
    }
}

} // namespace ameco::gui
