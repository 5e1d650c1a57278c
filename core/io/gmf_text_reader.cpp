// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf_text_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

namespace ameco::gmf {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
constexpr std::string_view version_word = "MeshVersionFormatted";
/// Unknown sections named in the note about them.
constexpr std::size_t max_named = 8;
/// Fields of one solution, libMeshb's limit.
constexpr std::int64_t max_fields = 1000;

bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// A few characters of a file, fit for a message.
std::string quoted(std::string_view token) {
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

} // namespace

bool is_text(std::string_view bytes) {
    bytes = without_byte_order_mark(bytes);
    for (;;) {
        while (!bytes.empty() && is_blank(bytes.front())) {
            bytes.remove_prefix(1);
        }
        if (bytes.empty() || bytes.front() != '#') {
            return bytes.substr(0, version_word.size()) == version_word;
        }
        const std::size_t line_end = bytes.find('\n');
        if (line_end == std::string_view::npos) {
            return false;
        }
        bytes.remove_prefix(line_end);
    }
}

TextReader::TextReader(std::string_view bytes, const std::string& name)
    : Reader(name), bytes_(without_byte_order_mark(bytes)), at_(bytes_.data()),
      end_(bytes_.data() + bytes_.size()) {
    skip_blank();
    at_ += version_word.size();
    const Section header{};
    const std::int64_t version = integer({header, 0});
    if (version < 1 || version > 4) {
        fail_here("MeshVersionFormatted is " + std::to_string(version) +
                  ", but only versions 1 to 4 are known");
    }
    version_ = static_cast<int>(version);
    read_dimension();
}

void TextReader::read_dimension() {
    skip_blank();
    if (token() != word(gmf::dimension)) {
        fail_here("expected Dimension behind MeshVersionFormatted, found " + quoted(token()));
    }
    at_ += token().size();
    const Section header{};
    const std::int64_t value = integer({header, 0});
    if (value != 2 && value != 3) {
        fail_here("Dimension is " + std::to_string(value) + ", but must be 2 or 3");
    }
    dimension_ = static_cast<int>(value);
}

std::string TextReader::format() const {
    return "Medit text, version " + std::to_string(version_);
}

std::string TextReader::place(const Section& section) const {
    return "line " + std::to_string(line(bytes_.data() + section.place));
}

/// Counted only when somebody asks, and nobody does in a good file.
std::int64_t TextReader::line(const char* at) const {
    return 1 + std::count(bytes_.data(), at, '\n');
}

std::string_view TextReader::token() const {
    const char* stop = std::find_if(at_, end_, is_blank);
    return {at_, static_cast<std::size_t>(stop - at_)};
}

void TextReader::fail_here(const std::string& what) const {
    fail("line " + std::to_string(line(at_)) + ": " + what);
}

void TextReader::fail_token(const Row& row, const char* expected) const {
    std::string where;
    if (row.section.keyword != 0) {
        where = word(row.section.keyword);
        if (row.section.count > 0) {
            where += ", row " + std::to_string(row.index + 1) + " of " +
                     std::to_string(row.section.count);
        }
        where += ": ";
    }
    if (at_ == end_) {
        fail_here(where + "the file ends where " + expected +
                  " is expected; it is truncated: copy or write it again");
    }
    fail_here(where + "expected " + expected + ", found " + quoted(token()));
}

void TextReader::skip_blank() {
    while (at_ != end_) {
        if (is_blank(*at_)) {
            ++at_;
        } else if (*at_ == '#') {
            skip_comment();
        } else {
            return;
        }
    }
}

void TextReader::skip_comment() {
    const char* stop = std::find(at_, end_, '\n');
    std::string_view comment(at_, static_cast<std::size_t>(stop - at_));
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
        names_in_comments_.push_back({0, number, std::string(without_blanks_around(text))});
    }
}

std::int64_t TextReader::integer(const Row& row) {
    skip_blank();
    std::int64_t value = 0;
    const char* begin = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
    const auto [rest, error] = std::from_chars(begin, end_, value);
    if (error != std::errc{} || (rest != end_ && !is_blank(*rest) && *rest != '#')) {
        fail_token(row, "an integer");
    }
    at_ = rest;
    return value;
}

double TextReader::real(const Row& row) {
    skip_blank();
    double value = 0;
    const auto [rest, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{} || (rest != end_ && !is_blank(*rest))) {
        return unusual_real(row);
    }
    at_ = rest;
    return value;
}

/// What from_chars does not read: a plus sign, Fortran's exponent letter D, and numbers beyond the
/// range of double (those too small become 0).
double TextReader::unusual_real(const Row& row) {
    std::string_view digits = token();
    digits = digits.substr(0, digits.find('#'));
    const std::size_t length = digits.size();
    std::string copy(digits.substr(digits.substr(0, 1) == "+" ? 1 : 0));
    std::replace(copy.begin(), copy.end(), 'd', 'e');
    std::replace(copy.begin(), copy.end(), 'D', 'e');
    double value = 0;
    const char* stop = copy.data() + copy.size();
    const auto [rest, error] = std::from_chars(copy.data(), stop, value);
    if (error == std::errc::result_out_of_range && rest == stop) {
        const bool tiny =
            copy.find("e-") != std::string::npos || copy.find("E-") != std::string::npos;
        if (!tiny) {
            fail_token(row, "a number in the range of double");
        }
        value = 0;
    } else if (error != std::errc{} || rest != stop) {
        fail_token(row, "a number");
    }
    at_ += length;
    return value;
}

int TextReader::label(const Row& row) {
    const std::int64_t value = integer(row);
    if (value != static_cast<std::int32_t>(value)) {
        fail_label(row.section, row.index, value);
    }
    return static_cast<int>(value);
}

void TextReader::check_room(const Section& section, std::int64_t numbers_per_row) const {
    // A number takes at least a digit and a blank, but for the last one of the file.
    const std::int64_t room = (end_ - at_ + 1) / 2;
    if (section.count < 0 || section.count > unknown_count ||
        section.count * numbers_per_row > room) {
        fail_here(word(section.keyword) + " announces " + std::to_string(section.count) +
                  " rows, but only " + std::to_string(end_ - at_) +
                  " bytes follow; the file is truncated or damaged");
    }
}

std::optional<Section> TextReader::next() {
    for (;;) {
        skip_blank();
        if (at_ == end_) {
            return std::nullopt;
        }
        const std::string_view keyword = token();
        if (!is_letter(keyword.front())) {
            fail_here("expected a keyword, found " + quoted(keyword) +
                      "; a row above has too many numbers, or a count is too small");
        }
        const int found = code(keyword);
        if (found == end) {
            at_ = end_;
            ended_ = true;
            return std::nullopt;
        }
        if (!is_table(found) && found != sol_at_vertices && found != reference_strings) {
            skip_section(keyword);
            continue;
        }
        Section section;
        section.keyword = found;
        section.place = at_ - bytes_.data();
        at_ += keyword.size();
        section.count = integer({section, 0});
        const RowLayout row = row_layout(found, dimension_);
        check_room(section, std::max(1, row.reals + row.integers));
        return section;
    }
}

void TextReader::skip_section(std::string_view keyword) {
    ++skipped_count_;
    if (skipped_.size() < max_named) {
        skipped_.push_back(quoted(keyword) + " (line " + std::to_string(line(at_)) + ")");
    }
    at_ += keyword.size();
    skip_numbers();
}

void TextReader::skip_numbers() {
    for (skip_blank(); at_ != end_ && !is_letter(*at_); skip_blank()) {
        at_ += token().size();
    }
}

void TextReader::read_points(const Section& section, std::span<double> coordinates,
                             std::vector<int>& labels) {
    const auto d = static_cast<std::size_t>(dimension_);
    labels.clear();
    for (std::int64_t i = 0; i < section.count; ++i) {
        const Row row{section, i};
        for (std::size_t k = 0; k < d; ++k) {
            coordinates[static_cast<std::size_t>(i) * d + k] = real(row);
        }
        const int l = label(row);
        if (l != 0 && labels.empty()) {
            labels.resize(static_cast<std::size_t>(section.count));
        }
        if (l != 0) {
            labels[static_cast<std::size_t>(i)] = l;
        }
    }
}

void TextReader::read_cells(const Section& section, std::int64_t node_count,
                            std::span<NodeId> nodes, std::span<int> labels) {
    const std::size_t per_cell = labels.empty() ? 0 : nodes.size() / labels.size();
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Row row{section, static_cast<std::int64_t>(i)};
        for (std::size_t k = 0; k < per_cell; ++k) {
            const std::int64_t node = integer(row);
            if (node < 1 || node > node_count) {
                fail_node(section, row.index, node, node_count);
            }
            nodes[i * per_cell + k] = NodeId(static_cast<std::int32_t>(node - 1));
        }
        labels[i] = label(row);
    }
}

void TextReader::read_numbers(const Section& section, std::span<std::int32_t> numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto index = static_cast<std::int64_t>(i);
        const std::int64_t number = integer({section, index});
        if (number < 1 || number > unknown_count) {
            fail_number(section, index, number);
        }
        numbers[i] = static_cast<std::int32_t>(number - 1);
    }
}

std::vector<ReferenceString> TextReader::read_strings(const Section& section) {
    std::vector<ReferenceString> strings;
    for (std::int64_t i = 0; i < section.count; ++i) {
        const Row row{section, i};
        ReferenceString string;
        string.keyword = integer(row);
        string.number = integer(row);
        const char* stop = std::find(at_, end_, '\n');
        string.text = without_blanks_around({at_, static_cast<std::size_t>(stop - at_)});
        at_ = stop;
        strings.push_back(std::move(string));
    }
    return strings;
}

std::vector<int> TextReader::read_solution_types(Section& section) {
    Section header = section;
    header.count = 0; // so that messages name no row
    const std::int64_t count = integer({header, 0});
    if (count < 0 || count > max_fields) {
        fail_here("SolAtVertices announces " + std::to_string(count) +
                  " fields; the file is damaged");
    }
    std::vector<int> types;
    std::int64_t values = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        types.push_back(label({header, i}));
        values += values_of_type(types.back(), dimension_);
    }
    check_room(section, std::max<std::int64_t>(1, values));
    return types;
}

void TextReader::read_reals(const Section& section, std::span<double> values) {
    const std::int64_t per_row =
        section.count == 0 ? 1 : static_cast<std::int64_t>(values.size()) / section.count;
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = real({section, static_cast<std::int64_t>(i) / per_row});
    }
}

std::vector<std::string> TextReader::notes() const {
    std::vector<std::string> result;
    if (skipped_count_ > 0) {
        std::string note = "skipped sections that are not supported:";
        for (const std::string& section : skipped_) {
            note += " " + section;
        }
        const auto more = skipped_count_ - static_cast<std::int64_t>(skipped_.size());
        result.push_back(more > 0 ? note + " and " + std::to_string(more) + " more" : note);
    }
    if (!ended_) {
        result.push_back("the file has no End keyword; it may be truncated between two sections");
    }
    return result;
}

} // namespace ameco::gmf
