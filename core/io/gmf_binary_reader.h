// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The binary form of GMF (.meshb, .solb), read from memory in either byte order.
///
///     int32 1 (16777216 when the bytes are swapped), int32 version, then records:
///     int32 keyword, position of the next record, [number of rows], rows;  the last one is End
///
///     version   real      integer   position
///     1         float32   int32     int32
///     2         float64   int32     int32
///     3         float64   int32     int64
///     4         float64   int64     int64
#pragma once

#include "core/io/gmf_reader.h"

namespace ameco::gmf {

[[nodiscard]] bool is_binary(std::string_view bytes);

class BinaryReader : public Reader {
public:
    /// Walks over all records and checks that they lie one behind the other in the file.
    BinaryReader(std::string_view bytes, const std::string& name);

    [[nodiscard]] std::string format() const override;
    [[nodiscard]] std::string place(const Section& section) const override;
    [[nodiscard]] std::optional<Section> next() override;
    void skip(const Section&) override {}
    void read_points(const Section& section, std::span<double> coordinates,
                     std::vector<int>& labels) override;
    void read_cells(const Section& section, std::int64_t node_count, std::span<NodeId> nodes,
                    std::span<int> labels) override;
    void read_numbers(const Section& section, std::span<std::int32_t> numbers) override;
    std::vector<ReferenceString> read_strings(const Section& section) override;
    std::vector<int> read_solution_types(Section& section) override;
    void read_reals(const Section& section, std::span<double> values) override;
    [[nodiscard]] std::vector<OpaqueRecord> carried() const override;
    [[nodiscard]] std::vector<std::string> notes() const override;

private:
    struct Record {
        int keyword;
        std::int64_t begin;   ///< byte of the keyword
        std::int64_t payload; ///< byte behind the position of the next record
        std::int64_t end;     ///< byte of the next record
    };

    [[nodiscard]] std::int64_t load_integer(std::int64_t at, int bytes) const;
    [[nodiscard]] int integer_bytes() const { return version_ == 4 ? 8 : 4; }
    [[nodiscard]] int real_bytes() const { return version_ == 1 ? 4 : 8; }
    [[nodiscard]] std::string describe(const Record& record) const;
    void find_records();
    void find_dimension();
    [[nodiscard]] bool is_known(const Record& record) const;
    [[nodiscard]] Section section_of(const Record& record) const;
    [[nodiscard]] const Record& record_of(const Section& section) const;
    void check_room(const Section& section, std::int64_t row_bytes) const;

    std::string_view bytes_;
    bool swapped_ = false;
    std::vector<Record> records_; ///< without Dimension and End; Vertices first
    std::size_t next_ = 0;
};

} // namespace ameco::gmf
