// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The binary form of GMF (.meshb, .solb), written in the machine's byte order.
#pragma once

#include "core/io/atomic_file.h"
#include "core/io/gmf_writer.h"
#include "core/io/patch_names.h"

namespace ameco::gmf {

class BinaryWriter : public Writer {
public:
    /// \param version  1 to 4; the caller sees to it that coordinates and positions fit
    BinaryWriter(const std::filesystem::path& path, int version, int dimension);

    void write_points(std::span<const double> coordinates, int dimension,
                      std::span<const int> labels) override;
    void write_cells(int keyword, std::span<const NodeId> nodes,
                     std::span<const int> labels) override;
    void write_numbers(int keyword, std::span<const std::int32_t> numbers) override;
    void write_names(int face_keyword, const std::map<int, std::string>& names) override;
    void write_tensors(std::span<const double> values, std::size_t per_tensor) override;
    void write_record(const OpaqueRecord& record);
    void commit() override;

    /// Bytes of text per name: what libMeshb's reader takes.
    static constexpr std::size_t name_bytes = longest_name + 1;

private:
    [[nodiscard]] std::int64_t integer_bytes() const { return version_ == 4 ? 8 : 4; }
    [[nodiscard]] std::int64_t real_bytes() const { return version_ == 1 ? 4 : 8; }
    void begin_record(int keyword, std::int64_t payload_bytes);
    void begin_table(int keyword, std::size_t rows, std::int64_t row_bytes);

    AtomicFile file_;
    int version_;
};

} // namespace ameco::gmf
