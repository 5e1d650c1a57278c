// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf_text_reader.h"

#include <algorithm>

namespace ameco::gmf {
namespace {

constexpr std::string_view version_word = "MeshVersionFormatted";
/// Unknown sections named in the note about them.
constexpr std::size_t max_named = 8;
/// Fields of one solution, libMeshb's limit.
constexpr std::int64_t max_fields = 1000;

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
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
    : Reader(name), text_(bytes, name, '#') {
    text_.skip_blank();
    text_.take(version_word.size());
    const Section header{};
    const std::int64_t version = text_.integer(Row{header, 0});
    if (version < 1 || version > 4) {
        text_.fail_here("MeshVersionFormatted is " + std::to_string(version) +
                        ", but only versions 1 to 4 are known");
    }
    version_ = static_cast<int>(version);
    read_dimension();
}

void TextReader::read_dimension() {
    text_.skip_blank();
    if (text_.token() != word(gmf::dimension)) {
        text_.fail_here("expected Dimension behind MeshVersionFormatted, found " +
                        in_quotes(text_.token()));
    }
    text_.take(text_.token().size());
    const Section header{};
    const std::int64_t value = text_.integer(Row{header, 0});
    if (value != 2 && value != 3) {
        text_.fail_here("Dimension is " + std::to_string(value) + ", but must be 2 or 3");
    }
    dimension_ = static_cast<int>(value);
}

std::string TextReader::format() const {
    return "Medit text, version " + std::to_string(version_);
}

std::string TextReader::place(const Section& section) const {
    return "line " + std::to_string(text_.line_of(section.place));
}

std::string TextReader::Row::operator()() const {
    if (section.keyword == 0) {
        return {};
    }
    std::string where = word(section.keyword);
    if (section.count > 0) {
        where += ", row " + std::to_string(index + 1) + " of " + std::to_string(section.count);
    }
    return where + ": ";
}

std::vector<ReferenceString> TextReader::names_in_comments() const {
    std::vector<ReferenceString> names;
    for (const auto& [patch, name] : text_.patch_comments()) {
        names.push_back({0, patch, name});
    }
    return names;
}

int TextReader::label(const Row& row) {
    const std::int64_t value = text_.integer(row);
    if (value != static_cast<std::int32_t>(value)) {
        fail_label(row.section, row.index, value);
    }
    return static_cast<int>(value);
}

void TextReader::check_room(const Section& section, std::int64_t numbers_per_row) const {
    if (!text_.has_room(section.count, numbers_per_row)) {
        text_.fail_room(word(section.keyword), section.count);
    }
}

std::optional<Section> TextReader::next() {
    for (;;) {
        if (ended_ || !text_.skip_blank()) {
            return std::nullopt;
        }
        const std::string_view keyword = text_.token();
        if (!is_letter(keyword.front())) {
            text_.fail_here("expected a keyword, found " + in_quotes(keyword) +
                            "; a row above has too many numbers, or a count is too small");
        }
        const int found = code(keyword);
        if (found == end) {
            ended_ = true;
            return std::nullopt;
        }
        if (!is_table(found) && found != sol_at_vertices && found != reference_strings) {
            skip_section(keyword);
            continue;
        }
        Section section;
        section.keyword = found;
        section.place = text_.position();
        text_.take(keyword.size());
        section.count = text_.integer(Row{section, 0});
        const RowLayout row = row_layout(found, dimension_);
        check_room(section, std::max(1, row.reals + row.integers));
        return section;
    }
}

void TextReader::skip_section(std::string_view keyword) {
    ++skipped_count_;
    if (skipped_.size() < max_named) {
        skipped_.push_back(in_quotes(keyword) + " (line " +
                           std::to_string(text_.line_of(text_.position())) + ")");
    }
    text_.take(keyword.size());
    skip_numbers();
}

void TextReader::skip_numbers() {
    while (text_.skip_blank() && !is_letter(text_.front())) {
        text_.take(text_.token().size());
    }
}

void TextReader::read_points(const Section& section, std::span<double> coordinates,
                             std::vector<int>& labels) {
    const auto d = static_cast<std::size_t>(dimension_);
    labels.clear();
    for (std::int64_t i = 0; i < section.count; ++i) {
        const Row row{section, i};
        for (std::size_t k = 0; k < d; ++k) {
            coordinates[static_cast<std::size_t>(i) * d + k] = text_.real(row);
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
            const std::int64_t node = text_.integer(row);
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
        const std::int64_t number = text_.integer(Row{section, index});
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
        string.keyword = text_.integer(row);
        string.number = text_.integer(row);
        string.text = text_.take_line();
        strings.push_back(std::move(string));
    }
    return strings;
}

std::vector<int> TextReader::read_solution_types(Section& section) {
    Section header = section;
    header.count = 0; // so that messages name no row
    const std::int64_t count = text_.integer(Row{header, 0});
    if (count < 0 || count > max_fields) {
        text_.fail_here("SolAtVertices announces " + std::to_string(count) +
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
        values[i] = text_.real(Row{section, static_cast<std::int64_t>(i) / per_row});
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
