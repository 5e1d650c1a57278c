// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the binary and the text form of a GMF file have in common for a writer.
#pragma once

#include "core/base/id.h"
#include "core/io/gmf_keyword.h"
#include "core/io/io.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace ameco::gmf {

/// Writes the sections of a file in the order of the calls. Numbers are 0-based here and become
/// 1-based; the header is written by the constructors of the two forms. All throw FileError.
class Writer {
public:
    virtual ~Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// \param labels  [n], or empty for labels of 0
    virtual void write_points(std::span<const double> coordinates, int dimension,
                              std::span<const int> labels) = 0;
    /// \param nodes   [n * nodes per cell]
    /// \param labels  [n]
    virtual void write_cells(int keyword, std::span<const NodeId> nodes,
                             std::span<const int> labels) = 0;
    virtual void write_numbers(int keyword, std::span<const std::int32_t> numbers) = 0;
    /// \param names  of patches; they hold no control characters and at most 255 bytes
    virtual void write_names(int face_keyword, const std::map<int, std::string>& names) = 0;
    /// One symmetric tensor per vertex, components in the file's order.
    /// \param values  [n * values per tensor]
    virtual void write_tensors(std::span<const double> values, std::size_t per_tensor) = 0;
    /// Writes the End and puts the file in place.
    virtual void commit() = 0;

protected:
    Writer() = default;
};

} // namespace ameco::gmf
