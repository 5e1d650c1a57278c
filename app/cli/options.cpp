// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/options.h"

#include "app/cli/report.h"
#include "app/cli/suggest.h"
#include "core/base/error.h"

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

CLI::Option* add_mean_option(CLI::App& app, std::string& mean) {
    std::vector<std::string> names;
    std::string list;
    for (const Mean m : all_means) {
        names.emplace_back(name(m));
        list += (list.empty() ? "" : ", ") + names.back();
    }
    return app
        .add_option("--mean", mean, "how the metrics of the elements at a node become one: " + list)
        ->type_name("NAME")
        ->check(one_of(names))
        ->capture_default_str();
}

Mean chosen_mean(const std::string& text) {
    const std::optional<Mean> mean = mean_from_name(text);
    if (!mean) {
        throw UsageError("--mean " + text + ": not a mean");
    }
    return *mean;
}

void add_target_options(CLI::App& app, TargetOptions& target, const std::string& group) {
    app.add_option("--slack", target.slack,
                   "how far a size may pass the next smaller one, at least 1 (the paper has 1)")
        ->type_name("S")
        ->check(number_within(1, HUGE_VAL))
        ->capture_default_str()
        ->group(group);
    app.add_option(
           "--isotropic-below", target.isotropic_below,
           "regions with a lower aspect ratio are coarsened alike in all directions, the "
           "more the rounder they are; at least 1, which leaves that out, as the paper does")
        ->type_name("R")
        ->check(number_within(1, HUGE_VAL))
        ->capture_default_str()
        ->group(group);
    std::vector<std::string> names;
    std::string list;
    for (const TargetAlgorithm algorithm : all_target_algorithms) {
        names.emplace_back(name(algorithm));
        list += (list.empty() ? "" : ", ") + names.back();
    }
    app.add_option_function<std::string>(
           "--algorithm",
           [&target](const std::string& text) {
               target.algorithm = target_algorithm_from_name(text).value_or(target.algorithm);
           },
           "whether sizes take notice of those beside them: " + list)
        ->type_name("NAME")
        ->check(one_of(names))
        ->default_str(std::string(name(target.algorithm)))
        ->group(group);
    app.add_option("--gradation", target.gradation,
                   "with --algorithm graded: most growth of the coarse sizes over one fine edge, "
                   "greater than 1")
        ->type_name("BETA")
        ->check(greater_than(1))
        ->capture_default_str()
        ->group(group);
}

} // namespace ameco::cli
