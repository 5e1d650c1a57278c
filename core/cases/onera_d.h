// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The ONERA D section of the M6 wing.
#pragma once

#include "core/base/vec.h"

#include <vector>

namespace ameco {

enum class TrailingEdge {
    rounded, ///< closed by the circle that touches both sides at their ends, radius 0.00071 chord
    sharp    ///< both sides prolonged until they meet, at x/c = 1.0057
};

/// The upper half of the section, from the leading to the trailing edge, as a curve by its length
/// in chords; the lower half mirrors it.
///
/// A cubic spline runs through the 72 published points, which end with a blunt trailing edge 0.0014
/// chord thick; that is closed as asked.
///
/// Points: V. Schmitt and F. Charpin, Pressure distributions on the ONERA-M6-Wing at transonic Mach
/// numbers, AGARD AR-138, 1979 (public data).
class OneraD {
public:
    explicit OneraD(TrailingEdge trailing_edge);

    [[nodiscard]] double length() const { return samples_.back().arc; }

    /// Point (x/c, z/c) at the length s, 0 <= s <= length(); z is exactly 0 at both ends.
    [[nodiscard]] Vec<2> operator()(double s) const;

private:
    struct Sample {
        double arc; ///< length of the curve up to here [chords]
        double t;   ///< parameter of the spline; one more than its end closes the trailing edge
    };

    [[nodiscard]] Vec<2> at(double t) const;
    [[nodiscard]] Vec<2> spline(double t) const;
    [[nodiscard]] Vec<2> closing(double part) const;

    TrailingEdge trailing_edge_;
    std::vector<double> knots_;   ///< lengths of the polygon through the published points
    std::vector<Vec<2>> points_;  ///< the published points
    std::vector<Vec<2>> second_;  ///< second derivatives there
    std::vector<Sample> samples_; ///< close enough to turn length into parameter by interpolation
};

} // namespace ameco
