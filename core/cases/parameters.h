// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A table that ties names on the command line to the members of an options struct.
#pragma once

#include "core/cases/cases.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ameco {

/// Numbers a parameter accepts.
struct Range {
    double low = 0, high = 0;
    bool low_open = false; ///< `low` itself is not accepted
    std::string text;      ///< for people: "> 0", "0 ... 0.3"

    [[nodiscard]] bool contains(double x) const {
        return x <= high && (low_open ? x > low : x >= low);
    }
};
[[nodiscard]] Range above(double low);
[[nodiscard]] Range at_least(double low);
[[nodiscard]] Range between(double low, double high);

/// A number as people write it: the shortest text that reads back the same.
[[nodiscard]] std::string to_text(double value);
/// \throws UsageError unless all of `text` is one finite number in `range`; `where` begins the text
[[nodiscard]] double number_from(std::string_view text, const Range& range,
                                 const std::string& where);
[[nodiscard]] int integer_from(std::string_view text, const Range& range, const std::string& where);

/// The known name that is nearest to `name` by edit distance, if it is near enough to be meant.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      const std::vector<std::string>& known);

/// Throws a UsageError such as "box: there is no parameter 'nxx'; did you mean 'nx'?".
/// \param problem  its beginning: "box: there is no parameter"
[[noreturn]] void throw_unknown(const std::string& problem, std::string_view name,
                                const std::vector<std::string>& known);

/// The parameters of one case. Defaults are read from a default-made Options, so that they are
/// written once.
template <class Options>
class ParameterTable {
public:
    explicit ParameterTable(std::string case_name) : case_name_(std::move(case_name)) {}

    ParameterTable& add(const std::string& name, double Options::*member, const std::string& unit,
                        const Range& range, const std::string& help) {
        parameters_.push_back({name, to_text(Options().*member), unit, range.text, help});
        setters_.push_back(
            [member, range](Options& o, std::string_view text, const std::string& where) {
                o.*member = number_from(text, range, where);
            });
        return *this;
    }

    ParameterTable& add(const std::string& name, int Options::*member, const Range& range,
                        const std::string& help) {
        parameters_.push_back({name, std::to_string(Options().*member), "", range.text, help});
        setters_.push_back(
            [member, range](Options& o, std::string_view text, const std::string& where) {
                o.*member = integer_from(text, range, where);
            });
        return *this;
    }

    /// A choice by name.
    template <class Value, class Base>
    ParameterTable& add(const std::string& name, Value Base::*member,
                        const std::vector<std::pair<std::string, Value>>& choices,
                        const std::string& help) {
        std::vector<std::string> names;
        std::string list, default_name;
        for (const auto& [text, value] : choices) {
            names.push_back(text);
            list += (list.empty() ? "" : ", ") + text;
            if (value == Options().*member) {
                default_name = text;
            }
        }
        parameters_.push_back({name, default_name, "", list, help});
        setters_.push_back(
            [member, choices, names](Options& o, std::string_view text, const std::string& where) {
                for (const auto& [known, value] : choices) {
                    if (known == text) {
                        o.*member = value;
                        return;
                    }
                }
                throw_unknown(where + " cannot be", text, names);
            });
        return *this;
    }

    [[nodiscard]] const std::vector<CaseParameter>& parameters() const { return parameters_; }

    /// Sets the members that `values` names.
    /// \throws UsageError
    void apply(const std::map<std::string, std::string>& values, Options& options) const {
        std::vector<std::string> names;
        for (const CaseParameter& p : parameters_) {
            names.push_back(p.name);
        }
        for (const auto& [name, value] : values) {
            std::size_t i = 0;
            while (i < names.size() && names[i] != name) {
                ++i;
            }
            if (i == names.size()) {
                throw_unknown(case_name_ + ": there is no parameter", name, names);
            }
            setters_[i](options, value, case_name_ + ": " + name);
        }
    }

private:
    using Setter = std::function<void(Options&, std::string_view text, const std::string& where)>;

    std::string case_name_;
    std::vector<CaseParameter> parameters_;
    std::vector<Setter> setters_;
};

} // namespace ameco
