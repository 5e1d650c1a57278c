// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What can be said of a picture without comparing bytes.
#pragma once

#include <QColor>
#include <QImage>

namespace ameco::test {

/// Share of the pixels that `holds` says yes to, in [0, 1].
template <class Predicate>
[[nodiscard]] double share_of_pixels(const QImage& image, Predicate holds) {
    qint64 count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += holds(image.pixelColor(x, y)) ? 1 : 0;
        }
    }
    return static_cast<double>(count) / (static_cast<double>(image.width()) * image.height());
}

/// Whether two colours are no further apart than `tolerance` of 255 in each channel.
[[nodiscard]] inline bool near_colour(const QColor& a, const QColor& b, int tolerance) {
    return std::abs(a.red() - b.red()) <= tolerance &&
           std::abs(a.green() - b.green()) <= tolerance &&
           std::abs(a.blue() - b.blue()) <= tolerance;
}

/// Share of the pixels that are not of the colour in the upper left corner.
[[nodiscard]] inline double share_not_background(const QImage& image) {
    const QColor background = image.pixelColor(0, 0);
    return share_of_pixels(image, [&](const QColor& c) { return !near_colour(c, background, 6); });
}

} // namespace ameco::test
