// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Words that our pictures in SVG are made of.
#pragma once

#include <array>
#include <string>

namespace ameco::svg {

/// Distinguishable without colour vision.
inline constexpr std::array<const char*, 8> colours{"#1f4e79", "#d95f02", "#1b9e77", "#7570b3",
                                                    "#e6ab02", "#a6761d", "#666666", "#e7298a"};

/// With so many decimals, whatever the locale.
[[nodiscard]] std::string number(double value, int decimals = 2);
/// Three significant digits.
[[nodiscard]] std::string short_number(double value);
/// The same in little space: 5490 is 5.49k, 351000 is 351k, 2e6 is 2M.
[[nodiscard]] std::string axis_number(double value);

/// The begin of a picture on white; to be ended by "</svg>".
[[nodiscard]] std::string open(double width, double height);

/// \param anchor  "start", "middle" or "end"
[[nodiscard]] std::string text_at(double x, double y, const std::string& text,
                                  const char* anchor = "start");

} // namespace ameco::svg
