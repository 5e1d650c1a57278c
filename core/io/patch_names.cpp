// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/patch_names.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

namespace ameco {
namespace {

std::optional<int> whole_number(const std::string& text) {
    int value = 0;
    const char* last = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), last, value);
    return error == std::errc{} && rest == last ? std::optional(value) : std::nullopt;
}

} // namespace

std::string portable_name(const std::string& name) {
    std::string result = name.substr(0, longest_name);
    std::replace_if(
        result.begin(), result.end(), [](char c) { return c >= 0 && c < ' '; }, '_');
    const std::size_t begin = result.find_first_not_of(' ');
    const std::size_t last = result.find_last_not_of(' ');
    return begin == std::string::npos ? "" : result.substr(begin, last - begin + 1);
}

std::map<int, std::string> portable_names(const std::map<int, std::string>& names,
                                          std::vector<std::string>& notes) {
    std::map<int, std::string> result;
    for (const auto& [patch, name] : names) {
        std::string portable = portable_name(name);
        if (portable != name) {
            notes.push_back("the name of patch " + std::to_string(patch) +
                            (portable.empty() ? " is blank and was left out"
                                              : " was changed to '" + portable + "'"));
        }
        if (!portable.empty()) {
            result.emplace(patch, std::move(portable));
        }
    }
    return result;
}

std::map<int, std::string> tags_of(const std::vector<int>& patches,
                                   const std::map<int, std::string>& names) {
    std::map<int, std::string> tags;
    std::set<std::string> taken;
    const auto give = [&](int patch, const std::string& tag) {
        tags[patch] = tag;
        taken.insert(tag);
    };
    for (const int patch : patches) {
        if (!names.contains(patch)) {
            give(patch, std::to_string(patch));
        }
    }
    for (const int patch : patches) {
        if (tags.contains(patch)) {
            continue;
        }
        std::string tag = portable_name(names.at(patch));
        std::replace(tag.begin(), tag.end(), ' ', '_');
        if (tag.empty() || taken.contains(tag)) {
            tag += (tag.empty() ? "" : "_") + std::to_string(patch);
        }
        while (taken.contains(tag)) {
            tag += '_';
        }
        give(patch, tag);
    }
    return tags;
}

TaggedPatches patches_of(const std::vector<std::string>& tags,
                         const std::map<int, std::string>& known) {
    std::map<std::string, int> patch_of_tag;
    TaggedPatches result;
    std::set<int> taken;
    const std::set<std::string> used(tags.begin(), tags.end());
    std::vector<int> named;
    for (const auto& [patch, name] : known) {
        named.push_back(patch);
        taken.insert(patch);
        result.names[patch] = name;
    }
    for (const auto& [patch, tag] : tags_of(named, known)) {
        patch_of_tag[tag] = patch;
    }
    for (const std::string& tag : used) {
        const std::optional<int> number = whole_number(tag);
        if (number && !patch_of_tag.contains(tag) && taken.insert(*number).second) {
            patch_of_tag[tag] = *number;
        }
    }
    int next = 1;
    for (const std::string& tag : tags) {
        if (!patch_of_tag.contains(tag)) {
            while (!taken.insert(next).second) {
                ++next;
            }
            patch_of_tag[tag] = next;
            result.names[next] = tag;
        }
        result.patches.push_back(patch_of_tag[tag]);
    }
    return result;
}

std::vector<int> distinct(std::vector<int> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

} // namespace ameco
