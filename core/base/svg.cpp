// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/base/svg.h"

#include "core/base/text.h"

#include <charconv>
#include <cmath>

namespace ameco::svg {
std::string number(double value, int decimals) {
    char text[64];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
    return {text, end.ptr};
}

std::string short_number(double value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3);
    return {text, end.ptr};
}

std::string axis_number(double value) {
    // What three digits round up to the next unit belongs there.
    if (std::abs(value) >= 999'500) {
        return short_number(value / 1e6) + "M";
    }
    return std::abs(value) >= 999.5 ? short_number(value / 1e3) + "k" : short_number(value);
}

std::string open(double width, double height) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width, 0) +
           "\" height=\"" + number(height, 0) + "\" viewBox=\"0 0 " + number(width, 0) + " " +
           number(height, 0) +
           "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
           "fill=\"#ffffff\"/>\n";
}

std::string text_at(double x, double y, const std::string& text, const char* anchor) {
    return "<text x=\"" + number(x, 1) + "\" y=\"" + number(y, 1) + "\" text-anchor=\"" + anchor +
           "\" fill=\"#222222\">" + xml_escaped(text) + "</text>\n";
}

} // namespace ameco::svg
