// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/parameters.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>

namespace ameco {
namespace {

/// Fewest insertions, deletions and replacements that turn one text into the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row.back();
}

[[noreturn]] void throw_bad_number(std::string_view text, const Range& range,
                                   const std::string& where, const std::string& kind) {
    throw UsageError(where + " is '" + std::string(text) + "', but must be " + kind + " " +
                     range.text);
}

} // namespace

Range above(double low) {
    return {low, std::numeric_limits<double>::max(), true, "> " + to_text(low)};
}

Range at_least(double low) {
    return {low, std::numeric_limits<double>::max(), false, ">= " + to_text(low)};
}

Range between(double low, double high) {
    return {low, high, false, to_text(low) + " ... " + to_text(high)};
}

std::string to_text(double value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

double number_from(std::string_view text, const Range& range, const std::string& where) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
        !range.contains(value)) {
        throw_bad_number(text, range, where, "a number");
    }
    return value;
}

int integer_from(std::string_view text, const Range& range, const std::string& where) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !range.contains(value)) {
        throw_bad_number(text, range, where, "a whole number");
    }
    return value;
}

std::optional<std::string> nearest_name(std::string_view name,
                                        const std::vector<std::string>& known) {
    std::optional<std::string> nearest;
    // Up to a third of the letters wrong is a slip; more is another word.
    std::size_t best = std::max<std::size_t>(1, name.size() / 3) + 1;
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

void throw_unknown(const std::string& problem, std::string_view name,
                   const std::vector<std::string>& known) {
    std::string text = problem + " '" + std::string(name) + "'; ";
    if (const auto nearest = nearest_name(name, known)) {
        throw UsageError(text + "did you mean '" + *nearest + "'?");
    }
    text += "known are ";
    for (std::size_t i = 0; i < known.size(); ++i) {
        text += (i == 0 ? "" : ", ") + known[i];
    }
    throw UsageError(text);
}

} // namespace ameco
