// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf_text_writer.h"

namespace ameco::gmf {

TextWriter::TextWriter(const std::filesystem::path& path, int dimension) : file_(path) {
    file_.text("MeshVersionFormatted 2\n\nDimension ");
    file_.number(dimension, '\n');
}

void TextWriter::begin_section(int keyword, std::size_t rows) {
    file_.text("\n");
    file_.text(word(keyword));
    file_.text("\n");
    file_.number(rows, '\n');
}

void TextWriter::write_points(std::span<const double> coordinates, int dimension,
                              std::span<const int> labels) {
    const auto d = static_cast<std::size_t>(dimension);
    const std::size_t n = coordinates.size() / d;
    begin_section(vertices, n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < d; ++k) {
            file_.number(coordinates[i * d + k], ' ');
        }
        file_.number(labels.empty() ? 0 : labels[i], '\n');
    }
}

void TextWriter::write_cells(int keyword, std::span<const NodeId> nodes,
                             std::span<const int> labels) {
    const std::size_t per_cell = nodes.size() / labels.size();
    begin_section(keyword, labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t k = 0; k < per_cell; ++k) {
            file_.number(std::int64_t{nodes[i * per_cell + k].value()} + 1, ' ');
        }
        file_.number(labels[i], '\n');
    }
}

void TextWriter::write_numbers(int keyword, std::span<const std::int32_t> numbers) {
    begin_section(keyword, numbers.size());
    for (const std::int32_t n : numbers) {
        file_.number(std::int64_t{n} + 1, '\n');
    }
}

void TextWriter::write_names(int, const std::map<int, std::string>& names) {
    file_.text("\n");
    file_.patch_comments('#', names);
}

void TextWriter::write_tensors(std::span<const double> values, std::size_t per_tensor) {
    begin_section(sol_at_vertices, values.size() / per_tensor);
    file_.text("1 3\n");
    for (std::size_t i = 0; i < values.size(); ++i) {
        file_.number(values[i], (i + 1) % per_tensor == 0 ? '\n' : ' ');
    }
}

void TextWriter::commit() {
    file_.text("\nEnd\n");
    file_.commit();
}

} // namespace ameco::gmf
