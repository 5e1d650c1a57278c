// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The settings of a hierarchy as a table: what each is called, what it accepts, what it means. The
/// command line, the window's panel and the sessions it saves all work from it.
#pragma once

#include "core/hierarchy/hierarchy.h"

#include <string>
#include <string_view>
#include <vector>

namespace ameco {

/// One setting. Its value travels as the word that the command line takes; numbers with as many
/// digits as bring them back to the bit.
struct Setting {
    enum class Kind { flag, whole_number, number, choice };

    std::string_view name;       ///< "slack", for the option --slack
    std::string_view label;      ///< "Slack", for the window
    std::string_view value_name; ///< "S", for the help
    std::string_view unit;       ///< "deg"; "-" for a pure number, "" for what is none
    std::string help;            ///< one line
    Kind kind = Kind::number;
    double low = 0;                   ///< smallest value
    double high = 0;                  ///< largest value; infinity for none
    bool above_low = false;           ///< `low` itself is too small
    bool zero_is_off = false;         ///< 0 means that the setting is not used
    std::vector<std::string> choices; ///< for `choice`
    std::string (*value)(const HierarchyOptions& options) = nullptr;
    /// \pre the word is acceptable
    void (*assign)(HierarchyOptions& options, const std::string& word) = nullptr;

    /// Whether a word is a value of this setting.
    [[nodiscard]] bool accepts(const std::string& word) const;
    /// What it accepts, for a message: "a number of at least 1".
    [[nodiscard]] std::string wanted() const;
};

/// All settings, in the order of the help. The factors of the levels and the frozen patches, whose
/// values are lists, are not among them.
[[nodiscard]] const std::vector<Setting>& settings();

/// \pre there is one of that name
[[nodiscard]] const Setting& setting(std::string_view name);

/// A number as the shortest word that reads back to the same bits: "2", "0.13", "1e-09".
[[nodiscard]] std::string exact_word(double value);

/// Names of the settings, "factor" and "freeze" included, that differ and bear on the levels made:
/// all but the number of levels and when to end. "" if there are none; "mean, slack" otherwise.
[[nodiscard]] std::string different_for_a_level(const HierarchyOptions& a,
                                                const HierarchyOptions& b);

/// Options of `ameco coarsen` that make `options.levels` levels so. The mean is always named.
///
/// \param factors  of the levels 1, 2, ...; they stand for `options.factors`, the factor and the
///                 target ratio
[[nodiscard]] std::vector<std::string> coarsen_arguments(const HierarchyOptions& options,
                                                         const std::vector<double>& factors);

/// A word as a POSIX shell reads it: quoted where it has to be.
[[nodiscard]] std::string shell_word(const std::string& word);

} // namespace ameco
