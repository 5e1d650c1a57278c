// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf_binary_writer.h"

#include <bit>
#include <cstring>

namespace ameco::gmf {
namespace {

static_assert(std::endian::native == std::endian::little,
              "carried records are kept in little-endian order and written as they are");

/// Stores numbers one behind the other, in the widths of one version.
template <class Int, class Real>
class Row {
public:
    explicit Row(char* begin) : begin_(begin), at_(begin) {}
    void integer(std::int64_t value) { store(static_cast<Int>(value)); }
    void real(double value) { store(static_cast<Real>(value)); }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(at_ - begin_); }

private:
    template <class T>
    void store(T value) {
        std::memcpy(at_, &value, sizeof(T));
        at_ += sizeof(T);
    }
    char* begin_;
    char* at_;
};

/// Calls `fill(i, row)` for each of n rows, with rows of the version's widths.
template <class F>
void write_rows(AtomicFile& file, int version, std::size_t n, std::size_t row_bytes, F&& fill) {
    const auto loop = [&](auto make_row) {
        for (std::size_t i = 0; i < n; ++i) {
            auto row = make_row(file.room(row_bytes));
            fill(i, row);
            file.used(row.size());
        }
    };
    if (version == 1) {
        loop([](char* at) { return Row<std::int32_t, float>(at); });
    } else if (version == 4) {
        loop([](char* at) { return Row<std::int64_t, double>(at); });
    } else {
        loop([](char* at) { return Row<std::int32_t, double>(at); });
    }
}

} // namespace

BinaryWriter::BinaryWriter(const std::filesystem::path& path, int version, int dimension)
    : file_(path), version_(version) {
    const std::int32_t header[2] = {1, version};
    file_.write(header, sizeof(header));
    const std::int32_t value = dimension; // 32 bits in every version
    begin_record(gmf::dimension, sizeof(value));
    file_.write(&value, sizeof(value));
}

void BinaryWriter::begin_record(int keyword, std::int64_t payload_bytes) {
    const std::int32_t code = keyword;
    const std::int64_t position_bytes = version_ >= 3 ? 8 : 4;
    const std::int64_t next = file_.position() + 4 + position_bytes + payload_bytes;
    file_.write(&code, sizeof(code));
    if (version_ >= 3) {
        file_.write(&next, sizeof(next));
    } else {
        const auto short_next = static_cast<std::int32_t>(next);
        file_.write(&short_next, sizeof(short_next));
    }
}

void BinaryWriter::begin_table(int keyword, std::size_t rows, std::int64_t row_bytes) {
    const auto count = static_cast<std::int64_t>(rows);
    begin_record(keyword, integer_bytes() + count * row_bytes);
    write_rows(file_, version_, 1, 8, [&](std::size_t, auto& row) { row.integer(count); });
}

void BinaryWriter::write_points(std::span<const double> coordinates, int dimension,
                                std::span<const int> labels) {
    const auto d = static_cast<std::size_t>(dimension);
    const std::size_t n = coordinates.size() / d;
    const std::int64_t row_bytes = dimension * real_bytes() + integer_bytes();
    begin_table(vertices, n, row_bytes);
    write_rows(file_, version_, n, static_cast<std::size_t>(row_bytes),
               [&](std::size_t i, auto& row) {
                   for (std::size_t k = 0; k < d; ++k) {
                       row.real(coordinates[i * d + k]);
                   }
                   row.integer(labels.empty() ? 0 : labels[i]);
               });
}

void BinaryWriter::write_cells(int keyword, std::span<const NodeId> nodes,
                               std::span<const int> labels) {
    const std::size_t n = labels.size();
    const std::size_t per_cell = nodes.size() / n;
    const std::int64_t row_bytes = static_cast<std::int64_t>(per_cell + 1) * integer_bytes();
    begin_table(keyword, n, row_bytes);
    write_rows(file_, version_, n, static_cast<std::size_t>(row_bytes),
               [&](std::size_t i, auto& row) {
                   for (std::size_t k = 0; k < per_cell; ++k) {
                       row.integer(std::int64_t{nodes[i * per_cell + k].value()} + 1);
                   }
                   row.integer(labels[i]);
               });
}

void BinaryWriter::write_numbers(int keyword, std::span<const std::int32_t> numbers) {
    begin_table(keyword, numbers.size(), integer_bytes());
    write_rows(file_, version_, numbers.size(), 8,
               [&](std::size_t i, auto& row) { row.integer(std::int64_t{numbers[i]} + 1); });
}

void BinaryWriter::write_names(int face_keyword, const std::map<int, std::string>& names) {
    begin_table(reference_strings, names.size(),
                2 * integer_bytes() + static_cast<std::int64_t>(name_bytes));
    for (const auto& [patch, name] : names) {
        write_rows(file_, version_, 1, 16, [&, number = patch](std::size_t, auto& row) {
            row.integer(face_keyword);
            row.integer(number);
        });
        std::string text = name;
        text.resize(name_bytes, '\0');
        file_.write(text.data(), text.size());
    }
}

void BinaryWriter::write_tensors(std::span<const double> values, std::size_t per_tensor) {
    const std::size_t n = values.size() / per_tensor;
    const auto row_bytes = static_cast<std::int64_t>(per_tensor) * real_bytes();
    // The count, then one field, a symmetric tensor: always 32 bits each.
    begin_record(sol_at_vertices, integer_bytes() + 8 + static_cast<std::int64_t>(n) * row_bytes);
    write_rows(file_, version_, 1, 8,
               [&](std::size_t, auto& row) { row.integer(static_cast<std::int64_t>(n)); });
    const std::int32_t fields[2] = {1, symmetric_tensor};
    file_.write(fields, sizeof(fields));
    write_rows(file_, version_, values.size(), 8,
               [&](std::size_t i, auto& row) { row.real(values[i]); });
}

void BinaryWriter::write_record(const OpaqueRecord& record) {
    begin_record(record.keyword, static_cast<std::int64_t>(record.bytes.size()));
    file_.write(record.bytes.data(), record.bytes.size());
}

void BinaryWriter::commit() {
    const std::int64_t nothing_follows = 0;
    const std::int32_t code = end;
    file_.write(&code, sizeof(code));
    file_.write(&nothing_follows, version_ >= 3 ? 8 : 4);
    file_.commit();
}

} // namespace ameco::gmf
