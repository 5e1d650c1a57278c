// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Words and numbers of a text file in memory, for the readers of all text formats.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ameco {

/// Walks through a text once. Blanks (spaces, tabs, ends of lines) separate tokens and a comment
/// runs to the end of its line. Comments of the form `# ameco patch 3 wing` carry names of patches
/// in formats that have no place for them, and are collected.
///
/// What reads a number takes a callable that says where it is expected, "Tetrahedra, row 3 of 9: ";
/// it is called only when something else is found. All messages name the file and the line.
class TextScanner {
public:
    /// Whether a row may go on in the next line.
    enum class Rows { free, lines };

    /// \param comment  the character that begins a comment, or 0
    TextScanner(std::string_view bytes, std::string name, char comment, Rows rows = Rows::free);

    /// Goes to the next token. False at the end of the file, or of the line where rows are lines.
    bool skip_blank();
    /// Goes to the first token of the next line that has one; at first, of the first such line.
    /// False at the end of the file.
    bool next_row();
    /// The text from here to the next blank; empty at the end.
    [[nodiscard]] std::string_view token() const;
    void take(std::size_t characters) { at_ += characters; }
    /// Takes the rest of the line, without blanks around it; comments are no comments there.
    std::string_view take_line();
    /// Takes the bytes that follow, of data in binary form amid text.
    /// \throws InputError  fewer are left
    std::string_view take_bytes(std::int64_t bytes, const std::string& what);

    /// The next token must be one.
    template <class Where>
    std::int64_t integer(const Where& where) {
        std::int64_t value = 0;
        if (!read_integer(value)) {
            fail_expected(where(), "an integer");
        }
        return value;
    }
    template <class Where>
    double real(const Where& where) {
        double value = 0;
        if (const char* problem = read_real(value)) {
            fail_expected(where(), problem);
        }
        return value;
    }

    [[nodiscard]] bool at_end() const { return at_ == end_; }
    [[nodiscard]] char front() const { return *at_; }
    [[nodiscard]] const char* here() const { return at_; }
    [[nodiscard]] std::int64_t position() const { return at_ - bytes_.data(); }
    /// Bytes not read yet.
    [[nodiscard]] std::int64_t left() const { return end_ - at_; }
    /// Whether `rows` rows of so many numbers can be in what is left of the file: what a count
    /// must pass before memory is asked for.
    [[nodiscard]] bool has_room(std::int64_t rows, std::int64_t numbers_per_row) const;

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Counted from 1, and only when somebody asks: nobody does in a good file.
    [[nodiscard]] std::int64_t line_of(std::int64_t position) const;
    [[noreturn]] void fail_here(const std::string& what) const;
    [[noreturn]] void fail_expected(const std::string& where, const char* expected) const;
    /// As above for a count that `has_room` refused.
    [[noreturn]] void fail_room(const std::string& what, std::int64_t count) const;

    /// Names of patches that stood in comments so far: (patch, name).
    [[nodiscard]] const std::vector<std::pair<std::int64_t, std::string>>& patch_comments() const {
        return patch_comments_;
    }

private:
    void skip_comment();
    bool read_integer(std::int64_t& value);
    /// \return  null, or what was expected
    const char* read_real(double& value);
    const char* read_unusual_real(double& value);
    [[nodiscard]] bool ends_token(const char* at) const;

    std::string_view bytes_;
    const char* at_;
    const char* end_;
    std::string name_;
    char comment_;
    bool lines_;
    bool begun_ = false; ///< whether `next_row` was called
    std::vector<std::pair<std::int64_t, std::string>> patch_comments_;
};

/// What stands between the comment character and the number of the patch in such a comment.
inline constexpr std::string_view patch_comment = " ameco patch ";

/// How many tokens a text without comments has.
[[nodiscard]] std::int64_t count_tokens(std::string_view text);

/// A few characters of a file, fit for a message.
[[nodiscard]] std::string in_quotes(std::string_view token);

[[nodiscard]] std::string_view without_blanks_around(std::string_view text);
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view bytes);
[[nodiscard]] bool is_blank(char c);

/// The names whose patch fits into 32 bits.
[[nodiscard]] std::map<int, std::string>
names_in_comments(const std::vector<std::pair<std::int64_t, std::string>>& comments);

} // namespace ameco
