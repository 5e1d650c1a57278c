// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A text file that is written whole or not at all, for the writers of all text formats.
#pragma once

#include "core/base/vec.h"
#include "core/io/atomic_file.h"

#include <charconv>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace ameco {

/// Numbers are written with the fewest digits that give back their bits, in no locale.
class TextFile {
public:
    explicit TextFile(const std::filesystem::path& path) : file_(path) {}

    void text(std::string_view text) { file_.write(text.data(), text.size()); }

    /// \param behind  the character that follows, a blank or the end of the line
    template <class T>
    void number(T value, char behind) {
        constexpr std::size_t longest = 32; // -1.7976931348623157e+308 has 24 characters
        char* begin = file_.room(longest);
        char* last = std::to_chars(begin, begin + longest - 1, value).ptr;
        *last++ = behind;
        file_.used(static_cast<std::size_t>(last - begin));
    }

    /// One row.
    template <int D>
    void point(const Vec<D>& x) {
        for (int k = 0; k < D; ++k) {
            number(x[k], k + 1 < D ? ' ' : '\n');
        }
    }

    /// One comment per name, as TextScanner collects them.
    void patch_comments(char comment, const std::map<int, std::string>& names);

    /// Raw bytes, of data in binary form amid text.
    void bytes(const void* data, std::size_t size) { file_.write(data, size); }

    /// \throws FileError
    void commit() { file_.commit(); }

private:
    AtomicFile file_;
};

} // namespace ameco
