// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The text form of GMF (.mesh, .sol): always version 2, which every reader takes. A number is
/// written with the fewest digits that give back its bits.
#pragma once

#include "core/io/gmf_writer.h"
#include "core/io/text_file.h"

namespace ameco::gmf {

class TextWriter : public Writer {
public:
    TextWriter(const std::filesystem::path& path, int dimension);

    void write_points(std::span<const double> coordinates, int dimension,
                      std::span<const int> labels) override;
    void write_cells(int keyword, std::span<const NodeId> nodes,
                     std::span<const int> labels) override;
    void write_numbers(int keyword, std::span<const std::int32_t> numbers) override;
    void write_names(int face_keyword, const std::map<int, std::string>& names) override;
    void write_tensors(std::span<const double> values, std::size_t per_tensor) override;
    void commit() override;

private:
    void begin_section(int keyword, std::size_t rows);

    TextFile file_;
};

} // namespace ameco::gmf
