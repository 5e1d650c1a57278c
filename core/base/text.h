// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Numbers as people read them, the same on the terminal and in the window, whatever the locale.
#pragma once

#include <cstdint>
#include <string>

namespace ameco {

/// 67866 -> "67,866".
[[nodiscard]] std::string count_text(std::int64_t count);
/// Four significant digits, without an exponent from 0.001 to 10 million: "2.192", "532,700".
[[nodiscard]] std::string number_text(double value, int digits = 4);
/// 0.1234 -> "12.3 %".
[[nodiscard]] std::string percent_text(double share);
/// A ratio with two decimals: "2.19".
[[nodiscard]] std::string ratio_text(double ratio);
/// "1.3 GB" (powers of ten).
[[nodiscard]] std::string bytes_text(double bytes);
/// Without the characters that XML and HTML reserve, quotes included.
[[nodiscard]] std::string xml_escaped(const std::string& text);
/// "1 node", "2 nodes".
[[nodiscard]] std::string plural(std::int64_t count, const std::string& one);

} // namespace ameco
