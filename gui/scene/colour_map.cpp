// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gui/scene/colour_map.h"

#include <algorithm>
#include <cmath>

namespace ameco::gui {
namespace {

unsigned char byte(double value) {
    return static_cast<unsigned char>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

} // namespace

Rgb sequential_colour(double t) {
    // Polynomial fit to matplotlib's viridis (public domain, CC0) by Matt Zucker, CC0.
    static constexpr double c[7][3] = {
        {0.2777273272234177, 0.005407344544966578, 0.3340998053353061},
        {0.1050930431085774, 1.404613529898575, 1.384590162594685},
        {-0.3308618287255563, 0.214847559468213, 0.09509516302823659},
        {-4.634230498983486, -5.799100973351585, -19.33244095627987},
        {6.228269936347081, 14.17993336680509, 56.69055260068105},
        {4.776384997670288, -13.74514537774601, -65.35303263337234},
        {-5.435455855934631, 4.645852612178535, 26.3124352495832}};
    t = std::clamp(t, 0.0, 1.0);
    Rgb colour{};
    for (std::size_t k = 0; k < 3; ++k) {
        double value = 0;
        for (int power = 6; power >= 0; --power) {
            value = value * t + c[power][k];
        }
        colour[k] = byte(value);
    }
    return colour;
}

Rgb diverging_colour(double t) {
    static constexpr double stops[9][3] = {{33, 102, 172},  {67, 147, 195},  {146, 197, 222},
                                           {209, 229, 240}, {247, 247, 247}, {253, 219, 199},
                                           {244, 165, 130}, {214, 96, 77},   {178, 24, 43}};
    const double place = 8 * std::clamp(t, 0.0, 1.0);
    const int below = std::min(7, static_cast<int>(place));
    const double share = place - below;
    Rgb colour{};
    for (std::size_t k = 0; k < 3; ++k) {
        colour[k] = byte(((1 - share) * stops[below][k] + share * stops[below + 1][k]) / 255);
    }
    return colour;
}

Rgb category_colour(std::size_t index) {
    static constexpr Rgb colours[] = {
        {110, 158, 207}, {240, 160, 84},  {122, 186, 128}, {214, 117, 116}, {163, 142, 200},
        {181, 143, 124}, {226, 153, 196}, {150, 156, 163}, {198, 196, 92},  {98, 188, 200}};
    return colours[index % std::size(colours)];
}

} // namespace ameco::gui
