// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Names of patches on their way through formats that have only numbers, or only names.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace ameco {

/// Bytes of the longest name that every format can hold.
inline constexpr std::size_t longest_name = 255;

/// The name without what some format cannot hold: control characters, blanks around it, and more
/// than `longest_name` bytes.
[[nodiscard]] std::string portable_name(const std::string& name);

/// Portable names; blank ones are left out. What was changed is added to the notes.
[[nodiscard]] std::map<int, std::string> portable_names(const std::map<int, std::string>& names,
                                                        std::vector<std::string>& notes);

/// For a format that knows patches by name only: one word without blanks for each of the patches,
/// no two alike. A patch without a name goes by its number.
/// \param patches  ascending
[[nodiscard]] std::map<int, std::string> tags_of(const std::vector<int>& patches,
                                                 const std::map<int, std::string>& names);

/// The patches that some tags stand for.
struct TaggedPatches {
    std::vector<int> patches; ///< one per tag
    std::map<int, std::string> names;
};

/// The way back. A tag that `tags_of` makes from one of the known names is that patch; a whole
/// number is the patch of that number; other tags get the lowest numbers left, from 1, in their
/// order. Equal tags are one patch.
/// \param known  names of patches that the file tells elsewhere (in comments, say)
[[nodiscard]] TaggedPatches patches_of(const std::vector<std::string>& tags,
                                       const std::map<int, std::string>& known);

/// The values in a list, ascending, each once.
[[nodiscard]] std::vector<int> distinct(std::vector<int> values);

} // namespace ameco
