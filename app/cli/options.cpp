// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/options.h"

#include "app/cli/report.h"
#include "app/cli/suggest.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>

namespace ameco::cli {
namespace {

template <class Number>
std::optional<Number> parse(const std::string& text) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, value);
    return failure == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

/// A validator without a name: the name would be printed after the option in the help.
CLI::Validator validator(std::function<std::string(std::string&)> test) {
    return {std::move(test), ""};
}

CLI::Validator finite_number(std::function<bool(double)> accepts, const std::string& wanted) {
    return validator([accepts = std::move(accepts), wanted](const std::string& text) {
        const auto value = parse<double>(text);
        return value && std::isfinite(*value) && accepts(*value) ? std::string()
                                                                 : text + " is not " + wanted;
    });
}

/// \param s  of the table, which outlives the parser
CLI::Validator values_of(const Setting& s) {
    if (s.kind == Setting::Kind::choice) {
        return one_of(s.choices);
    }
    return validator([&s](const std::string& text) {
        return s.accepts(text) ? std::string() : text + " is not " + s.wanted();
    });
}

} // namespace

CLI::Validator whole_number(long low, long high) {
    return validator([low, high](const std::string& text) {
        const auto value = parse<long>(text);
        return value && *value >= low && *value <= high
                   ? std::string()
                   : text + " is not a whole number from " + std::to_string(low) + " to " +
                         std::to_string(high);
    });
}

CLI::Validator greater_than(double bound) {
    return finite_number([bound](double value) { return value > bound; },
                         "a number greater than " + number_text(bound));
}

CLI::Validator number_within(double low, double high) {
    return finite_number([low, high](double value) { return value >= low && value <= high; },
                         std::isinf(high)
                             ? "a number of at least " + number_text(low)
                             : "a number from " + number_text(low) + " to " + number_text(high));
}

CLI::Validator one_of(std::vector<std::string> words) {
    return validator([words = std::move(words)](const std::string& text) -> std::string {
        if (std::find(words.begin(), words.end(), text) != words.end()) {
            return {};
        }
        std::string list;
        for (const std::string& word : words) {
            list += (list.empty() ? "" : ", ") + word;
        }
        return text + " is not one of " + list + did_you_mean(text, words);
    });
}

std::vector<double> numbers_from(const std::string& text) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        double value = 0;
        const auto [stop, failure] = std::from_chars(at, end, value);
        if (failure != std::errc() || !std::isfinite(value)) {
            return {};
        }
        numbers.push_back(value);
        if (stop == end) {
            return numbers;
        }
        if (*stop != ',') {
            return {};
        }
        at = stop + 1;
    }
}

CLI::Option* add_setting(CLI::App& app, HierarchyOptions& options, std::string_view name,
                         const std::string& group, const std::string& short_name) {
    const Setting& s = setting(name);
    const std::string names =
        (short_name.empty() ? "" : "-" + short_name + ",") + "--" + std::string(name);
    if (s.kind == Setting::Kind::flag) {
        return app
            .add_flag_callback(
                names, [&s, &options] { s.assign(options, "1"); }, s.help)
            ->group(group);
    }
    CLI::Option* const option = app.add_option_function<std::string>(
        names, [&s, &options](const std::string& word) { s.assign(options, word); }, s.help);
    if (!s.zero_is_off) {
        option->default_str(s.value(options));
    }
    return option->type_name(std::string(s.value_name))->check(values_of(s))->group(group);
}

} // namespace ameco::cli
