// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ameco {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

template <class Number>
bool parse(const std::string& word, Number& value) {
    const char* const end = word.data() + word.size();
    const auto [stop, failure] = std::from_chars(word.data(), end, value);
    return failure == std::errc() && stop == end && !word.empty();
}

double number_of(const std::string& word) {
    double value = 0;
    if (!parse(word, value)) {
        throw std::invalid_argument(word + " is no number");
    }
    return value;
}

template <class Values>
std::vector<std::string> names_of(const Values& values) {
    std::vector<std::string> names;
    for (const auto value : values) {
        names.emplace_back(name(value));
    }
    return names;
}

std::string joined(const std::vector<std::string>& words, const char* separator) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : separator) + word;
    }
    return text;
}

/// A setting that is a number at some place of the options.
template <class Place>
Setting number_setting(std::string_view name, std::string_view label, std::string_view value_name,
                       std::string help, double low, double high, Place) {
    Setting s;
    s.name = name;
    s.label = label;
    s.value_name = value_name;
    s.unit = name.ends_with("-angle") ? "deg" : "-";
    s.help = std::move(help);
    s.low = low;
    s.high = high;
    s.value = [](const HierarchyOptions& o) { return exact_word(Place()(o)); };
    s.assign = [](HierarchyOptions& o, const std::string& word) { Place()(o) = number_of(word); };
    return s;
}

Setting levels_setting() {
    Setting s;
    s.name = "levels";
    s.label = "Levels";
    s.value_name = "N";
    s.help = "coarser levels to make, at most";
    s.kind = Setting::Kind::whole_number;
    s.low = 1;
    s.high = 100;
    s.value = [](const HierarchyOptions& o) { return std::to_string(o.levels); };
    s.assign = [](HierarchyOptions& o, const std::string& word) { parse(word, o.levels); };
    return s;
}

Setting until_isotropic_setting() {
    Setting s;
    s.name = "until-isotropic";
    s.label = "Until isotropic";
    s.help = "end with the first level that has 95 % of its nodes below an aspect ratio of 5; as "
             "many levels as that takes, or as --levels allows";
    s.kind = Setting::Kind::flag;
    s.value = [](const HierarchyOptions& o) { return std::string(o.until_isotropic ? "1" : "0"); };
    s.assign = [](HierarchyOptions& o, const std::string& word) {
        o.until_isotropic = word == "1";
    };
    return s;
}

/// A setting that has one of a few named values, at some place of the options.
template <const auto& Values, class Place>
Setting choice_setting(std::string_view option, std::string_view label, std::string_view value_name,
                       std::string help, Place) {
    Setting s;
    s.name = option;
    s.label = label;
    s.value_name = value_name;
    s.help = std::move(help);
    s.kind = Setting::Kind::choice;
    s.choices = names_of(Values);
    s.value = [](const HierarchyOptions& o) { return std::string(name(Place()(o))); };
    s.assign = [](HierarchyOptions& o, const std::string& word) {
        for (const auto value : Values) {
            if (name(value) == word) {
                Place()(o) = value;
            }
        }
    };
    return s;
}

Setting rebuild_setting() {
    Setting s;
    s.name = "rebuild";
    s.label = "Rebuild";
    s.value_name = "HOW";
    s.kind = Setting::Kind::choice;
    s.choices = {"none", "tetgen"};
    s.help = "make the elements of each level anew from its surface and nodes: none, tetgen; where "
             "that fails, the level is made without";
    s.value = [](const HierarchyOptions& o) { return std::string(o.rebuild ? "tetgen" : "none"); };
    s.assign = [](HierarchyOptions& o, const std::string& word) { o.rebuild = word == "tetgen"; };
    return s;
}

std::vector<Setting> make_settings() {
    std::vector<Setting> all{levels_setting(), until_isotropic_setting()};
    all.push_back(number_setting(
        "target-ratio", "Target ratio", "R",
        "choose the factor of each level so that it has R times fewer nodes; takes up to five "
        "times as long [off]",
        1, no_bound, [](auto& o) -> auto& { return o.target_ratio; }));
    all.back().above_low = true;
    all.back().zero_is_off = true;
    all.push_back(number_setting(
        "slack", "Slack", "S",
        "how far a size may pass the next smaller one, at least 1 (the paper has 1)", 1, no_bound,
        [](auto& o) -> auto& { return o.coarsen.target.slack; }));
    all.push_back(number_setting(
        "isotropic-below", "Isotropic below", "R",
        "regions with a lower aspect ratio are coarsened alike in all directions, the more the "
        "rounder they are; at least 1, which leaves that out, as the paper does",
        1, no_bound, [](auto& o) -> auto& { return o.coarsen.target.isotropic_below; }));
    all.push_back(choice_setting<all_target_algorithms>(
        "algorithm", "Algorithm", "NAME",
        "whether sizes take notice of those beside them: " +
            joined(names_of(all_target_algorithms), ", "),
        [](auto& o) -> auto& { return o.coarsen.target.algorithm; }));
    all.push_back(number_setting(
        "gradation", "Gradation", "BETA",
        "with --algorithm graded: most growth of the coarse sizes over one fine edge, greater than "
        "1",
        1, no_bound, [](auto& o) -> auto& { return o.coarsen.target.gradation; }));
    all.back().above_low = true;
    all.push_back(choice_setting<all_means>(
        "mean", "Mean", "NAME",
        "how the metrics of the elements at a node become one: " +
            joined(names_of(all_means), ", "),
        [](auto& o) -> auto& { return o.coarsen.mean; }));
    all.push_back(number_setting(
        "surface-deviation", "Surface deviation", "D",
        "how far the boundary may move, over the local size of the surface mesh", 0, no_bound,
        [](auto& o) -> auto& { return o.coarsen.removal.surface.relative_distance; }));
    all.push_back(number_setting(
        "ridge-angle", "Ridge angle", "DEG", "boundary edges that turn by more degrees are kept", 0,
        180, [](auto& o) -> auto& { return o.coarsen.features.ridge_angle_deg; }));
    all.push_back(choice_setting<all_coarse_nodes>(
        "nodes", "Nodes", "WHERE",
        "where the nodes of a level are: nested (where nodes of the finer one are), moved (where "
        "the metric wants them: more edges in band, no injection)",
        [](auto& o) -> auto& { return o.coarsen.nodes; }));
    all.push_back(choice_setting<all_boundary_choices>(
        "boundary", "Boundary", "HOW",
        "coarsen: the boundary is coarsened too, but for the patches of --freeze; keep: all of "
        "it stays as it is",
        [](auto& o) -> auto& { return o.coarsen.features.boundary; }));
    all.push_back(rebuild_setting());
    return all;
}

} // namespace

bool Setting::accepts(const std::string& word) const {
    switch (kind) {
    case Kind::flag:
        return word == "0" || word == "1";
    case Kind::choice:
        return std::find(choices.begin(), choices.end(), word) != choices.end();
    case Kind::whole_number: {
        long whole = 0;
        return parse(word, whole) && static_cast<double>(whole) >= low &&
               static_cast<double>(whole) <= high;
    }
    case Kind::number:
        break;
    }
    double number = 0;
    if (!parse(word, number) || !std::isfinite(number)) {
        return false;
    }
    return (zero_is_off && number == 0) ||
           ((above_low ? number > low : number >= low) && number <= high);
}

std::string Setting::wanted() const {
    const std::string range = exact_word(low) + " to " + exact_word(high);
    switch (kind) {
    case Kind::flag:
        return "0 or 1";
    case Kind::choice:
        return "one of " + joined(choices, ", ");
    case Kind::whole_number:
        return "a whole number from " + range;
    case Kind::number:
        break;
    }
    if (above_low) {
        return "a number greater than " + exact_word(low);
    }
    return std::isinf(high) ? "a number of at least " + exact_word(low) : "a number from " + range;
}

const std::vector<Setting>& settings() {
    static const std::vector<Setting> all = make_settings();
    return all;
}

const Setting& setting(std::string_view name) {
    const auto& all = settings();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Setting& s) { return s.name == name; });
    if (found == all.end()) {
        throw std::logic_error("there is no setting " + std::string(name));
    }
    return *found;
}

std::string exact_word(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

std::string different_for_a_level(const HierarchyOptions& a, const HierarchyOptions& b) {
    std::vector<std::string> names;
    for (const Setting& s : settings()) {
        const bool bears = s.name != "levels" && s.name != "until-isotropic" &&
                           s.name != "target-ratio"; // these decide which factors, and how many
        if (bears && s.value(a) != s.value(b)) {
            names.emplace_back(s.name);
        }
    }
    if (a.coarsen.features.frozen_patches != b.coarsen.features.frozen_patches) {
        names.emplace_back("freeze");
    }
    return joined(names, ", ");
}

std::vector<std::string> coarsen_arguments(const HierarchyOptions& options,
                                           const std::vector<double>& factors) {
    const HierarchyOptions defaults;
    std::vector<std::string> words{"--levels", std::to_string(options.levels)};
    std::vector<double> list = factors;
    while (list.size() > 1 && list.back() == list[list.size() - 2]) {
        list.pop_back(); // the last one is that of all further levels
    }
    if (list.size() > 1 || (list.size() == 1 && list[0] != defaults.coarsen.target.factor)) {
        std::vector<std::string> numbers(list.size());
        std::transform(list.begin(), list.end(), numbers.begin(), exact_word);
        words.insert(words.end(), {"--factor", joined(numbers, ",")});
    }
    for (const Setting& s : settings()) {
        const bool told_already =
            s.name == "levels" || s.name == "until-isotropic" || s.name == "target-ratio";
        if (!told_already && (s.name == "mean" || s.value(options) != s.value(defaults))) {
            words.insert(words.end(), {"--" + std::string(s.name), s.value(options)});
        }
    }
    if (const auto& frozen = options.coarsen.features.frozen_patches; !frozen.empty()) {
        words.emplace_back("--freeze");
        for (const int patch : frozen) {
            words.push_back(std::to_string(patch));
        }
    }
    return words;
}

std::string shell_word(const std::string& word) {
    const auto is_plain = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) {
        return word;
    }
    std::string quoted = "'";
    for (const char c : word) {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return quoted + "'";
}

} // namespace ameco
