// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/text_scanner.h"

#include "core/base/error.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace ameco {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

} // namespace

bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

std::int64_t count_tokens(std::string_view text) {
    std::int64_t count = 0;
    bool inside = false;
    for (const char c : text) {
        count += !is_blank(c) && !inside ? 1 : 0;
        inside = !is_blank(c);
    }
    return count;
}

std::string in_quotes(std::string_view token) {
    constexpr std::size_t longest = 24;
    std::string result = "'";
    for (const char c : token.substr(0, longest)) {
        result += c >= ' ' && c <= '~' ? c : '?';
    }
    return result + (token.size() > longest ? "...'" : "'");
}

std::string_view without_blanks_around(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

std::string_view without_byte_order_mark(std::string_view bytes) {
    if (bytes.substr(0, byte_order_mark.size()) == byte_order_mark) {
        bytes.remove_prefix(byte_order_mark.size());
    }
    return bytes;
}

std::map<int, std::string>
names_in_comments(const std::vector<std::pair<std::int64_t, std::string>>& comments) {
    std::map<int, std::string> names;
    for (const auto& [patch, name] : comments) {
        if (patch == static_cast<std::int32_t>(patch)) {
            names[static_cast<int>(patch)] = name;
        }
    }
    return names;
}

TextScanner::TextScanner(std::string_view bytes, std::string name, char comment, Rows rows)
    : bytes_(without_byte_order_mark(bytes)), at_(bytes_.data()),
      end_(bytes_.data() + bytes_.size()), name_(std::move(name)), comment_(comment),
      lines_(rows == Rows::lines) {}

bool TextScanner::skip_blank() {
    while (at_ != end_) {
        if (*at_ == '\n' && lines_) {
            return false;
        }
        if (is_blank(*at_)) {
            ++at_;
        } else if (*at_ == comment_) {
            skip_comment();
        } else {
            return true;
        }
    }
    return false;
}

bool TextScanner::next_row() {
    while (true) {
        if (begun_) {
            at_ = std::find(at_, end_, '\n');
            at_ += at_ == end_ ? 0 : 1;
        }
        begun_ = true;
        if (skip_blank()) {
            return true;
        }
        if (at_ == end_) {
            return false;
        }
    }
}

void TextScanner::skip_comment() {
    const char* stop = std::find(at_, end_, '\n');
    std::string_view comment(at_ + 1, static_cast<std::size_t>(stop - at_ - 1));
    at_ = stop;
    if (comment.substr(0, patch_comment.size()) != patch_comment) {
        return;
    }
    comment.remove_prefix(patch_comment.size());
    std::int64_t number = 0;
    const char* last = comment.data() + comment.size();
    const auto [rest, error] = std::from_chars(comment.data(), last, number);
    if (error == std::errc{}) {
        const std::string_view text(rest, static_cast<std::size_t>(last - rest));
        patch_comments_.emplace_back(number, without_blanks_around(text));
    }
}

std::string_view TextScanner::token() const {
    const char* stop = std::find_if(at_, end_, is_blank);
    return {at_, static_cast<std::size_t>(stop - at_)};
}

std::string_view TextScanner::take_line() {
    const char* stop = std::find(at_, end_, '\n');
    const std::string_view line(at_, static_cast<std::size_t>(stop - at_));
    at_ = stop;
    return without_blanks_around(line);
}

std::string_view TextScanner::take_bytes(std::int64_t bytes, const std::string& what) {
    if (bytes < 0 || bytes > left()) {
        throw InputError(name_ + ": byte " + std::to_string(position()) + ": " + what + " takes " +
                         std::to_string(bytes) + " bytes, but " + std::to_string(left()) +
                         " follow; the file is truncated or damaged");
    }
    const std::string_view result(at_, static_cast<std::size_t>(bytes));
    at_ += bytes;
    return result;
}

bool TextScanner::ends_token(const char* at) const {
    return at == end_ || is_blank(*at) || (*at == comment_ && comment_ != 0);
}

bool TextScanner::read_integer(std::int64_t& value) {
    skip_blank();
    const char* begin = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
    const auto [rest, error] = std::from_chars(begin, end_, value);
    if (error != std::errc{} || !ends_token(rest)) {
        return false;
    }
    at_ = rest;
    return true;
}

const char* TextScanner::read_real(double& value) {
    skip_blank();
    const auto [rest, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{} || (rest != end_ && !is_blank(*rest))) {
        return read_unusual_real(value);
    }
    at_ = rest;
    return nullptr;
}

/// What from_chars does not read: a plus sign, Fortran's exponent letter D, and numbers beyond the
/// range of double (those too small become 0).
const char* TextScanner::read_unusual_real(double& value) {
    std::string_view digits = token();
    if (comment_ != 0) {
        digits = digits.substr(0, digits.find(comment_));
    }
    std::string copy(digits.substr(digits.substr(0, 1) == "+" ? 1 : 0));
    std::replace(copy.begin(), copy.end(), 'd', 'e');
    std::replace(copy.begin(), copy.end(), 'D', 'e');
    const char* stop = copy.data() + copy.size();
    const auto [rest, error] = std::from_chars(copy.data(), stop, value);
    if (error == std::errc::result_out_of_range && rest == stop) {
        const bool tiny =
            copy.find("e-") != std::string::npos || copy.find("E-") != std::string::npos;
        if (!tiny) {
            return "a number in the range of double";
        }
        value = 0;
    } else if (error != std::errc{} || rest != stop) {
        return "a number";
    }
    at_ += digits.size();
    return nullptr;
}

bool TextScanner::has_room(std::int64_t rows, std::int64_t numbers_per_row) const {
    // A number takes at least a digit and a blank, but for the last one of the file.
    const std::int64_t room = (left() + 1) / 2;
    return rows >= 0 && rows <= std::numeric_limits<std::int32_t>::max() &&
           rows * numbers_per_row <= room;
}

std::int64_t TextScanner::line_of(std::int64_t position) const {
    return 1 + std::count(bytes_.data(), bytes_.data() + position, '\n');
}

void TextScanner::fail_here(const std::string& what) const {
    throw InputError(name_ + ": line " + std::to_string(line_of(position())) + ": " + what);
}

void TextScanner::fail_expected(const std::string& where, const char* expected) const {
    if (at_ == end_) {
        fail_here(where + "the file ends where " + expected +
                  " is expected; it is truncated: copy or write it again");
    }
    if (lines_ && *at_ == '\n') {
        fail_here(where + "the line ends where " + expected + " is expected");
    }
    fail_here(where + "expected " + expected + ", found " + in_quotes(token()));
}

void TextScanner::fail_room(const std::string& what, std::int64_t count) const {
    fail_here(what + " announces " + std::to_string(count) + " rows, but only " +
              std::to_string(left()) + " bytes follow; the file is truncated or damaged");
}

} // namespace ameco
