// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf_text_writer.h"

#include "core/io/gmf_text_reader.h"

#include <charconv>

namespace ameco::gmf {

TextWriter::TextWriter(const std::filesystem::path& path, int dimension) : file_(path) {
    text("MeshVersionFormatted 2\n\nDimension ");
    number(dimension, '\n');
}

template <class T>
void TextWriter::number(T value, char behind) {
    constexpr std::size_t longest = 32; // -1.7976931348623157e+308 has 24 characters
    char* begin = file_.room(longest);
    char* last = std::to_chars(begin, begin + longest - 1, value).ptr;
    *last++ = behind;
    file_.used(static_cast<std::size_t>(last - begin));
}

void TextWriter::begin_section(int keyword, std::size_t rows) {
    text("\n");
    text(word(keyword));
    text("\n");
    number(rows, '\n');
}

void TextWriter::write_points(std::span<const double> coordinates, int dimension,
                              std::span<const int> labels) {
    const auto d = static_cast<std::size_t>(dimension);
    const std::size_t n = coordinates.size() / d;
    begin_section(vertices, n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < d; ++k) {
            number(coordinates[i * d + k], ' ');
        }
        number(labels.empty() ? 0 : labels[i], '\n');
    }
}

void TextWriter::write_cells(int keyword, std::span<const NodeId> nodes,
                             std::span<const int> labels) {
    const std::size_t per_cell = nodes.size() / labels.size();
    begin_section(keyword, labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t k = 0; k < per_cell; ++k) {
            number(std::int64_t{nodes[i * per_cell + k].value()} + 1, ' ');
        }
        number(labels[i], '\n');
    }
}

void TextWriter::write_numbers(int keyword, std::span<const std::int32_t> numbers) {
    begin_section(keyword, numbers.size());
    for (const std::int32_t n : numbers) {
        number(std::int64_t{n} + 1, '\n');
    }
}

void TextWriter::write_names(int, const std::map<int, std::string>& names) {
    text("\n");
    for (const auto& [patch, name] : names) {
        text(patch_comment);
        number(patch, ' ');
        text(name);
        text("\n");
    }
}

void TextWriter::write_tensors(std::span<const double> values, std::size_t per_tensor) {
    begin_section(sol_at_vertices, values.size() / per_tensor);
    text("1 3\n");
    for (std::size_t i = 0; i < values.size(); ++i) {
        number(values[i], (i + 1) % per_tensor == 0 ? '\n' : ' ');
    }
}

void TextWriter::commit() {
    text("\nEnd\n");
    file_.commit();
}

} // namespace ameco::gmf
