// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Aspect ratios of nodes, and the paper's classes by powers of two (Table 3, figures 11, 13, 18).
#pragma once

#include "core/metric/metric.h"

#include <cstdint>
#include <vector>

namespace ameco {

/// Nodes by aspect ratio: class k (from 0) holds those in (max / 2^(k+1), max / 2^k], the last one
/// is the class that contains 1.
struct AspectRatioClasses {
    double max = 1;                   ///< upper edge of class 0 [-]
    std::vector<std::int64_t> counts; ///< nodes per class

    [[nodiscard]] double upper(std::size_t k) const;
    [[nodiscard]] double lower(std::size_t k) const { return upper(k + 1); }
    /// The class that an aspect ratio is counted in; 0 above `max`, and for what is no number.
    [[nodiscard]] std::size_t class_of(double aspect_ratio) const;
};

/// Classes with nothing in them yet, down to the one that contains 1.
/// \param max  upper edge of the first class; below 1 means 1
[[nodiscard]] AspectRatioClasses empty_classes(double max);

/// \param max  upper edge of the first class; 0 takes the field's own largest aspect ratio. Give
///             the finest level's to compare the levels of a hierarchy. Nodes above it are counted
///             in class 0.
template <int D>
[[nodiscard]] AspectRatioClasses classify_aspect_ratios(const MetricField<D>& field,
                                                        double max = 0);

/// A few numbers that say how anisotropic a field is.
struct AspectRatioSummary {
    double max = 1;           ///< largest aspect ratio
    double top_5_percent = 1; ///< 5 % of the nodes are above this
    double median = 1;
    double share_isotropic = 1; ///< share of nodes below 5 (the paper's "isotropic"), in [0, 1]
    double share_above_150 = 0; ///< share of nodes above 150, in [0, 1]
};

template <int D>
[[nodiscard]] AspectRatioSummary summarise_aspect_ratios(const MetricField<D>& field);

} // namespace ameco
