// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A binary file of numbers, written whole or not at all, in either byte order.
#pragma once

#include "core/io/atomic_file.h"
#include "core/io/byte_order.h"

namespace ameco {

/// The widths and the order of the numbers in a file.
struct NumberLayout {
    bool big_endian = false;
    int int_bytes = 4;  ///< 4 or 8
    int real_bytes = 8; ///< 4 or 8
};

class BinaryFile {
public:
    BinaryFile(const std::filesystem::path& path, const NumberLayout& layout)
        : file_(path), layout_(layout),
          swapped_(layout.big_endian != (std::endian::native == std::endian::big)) {}

    void integer(std::int64_t value) {
        if (layout_.int_bytes == 8) {
            put(value);
        } else {
            put(static_cast<std::int32_t>(value));
        }
    }
    void real(double value) {
        if (layout_.real_bytes == 8) {
            put(std::bit_cast<std::uint64_t>(value));
        } else {
            put(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
        }
    }
    /// The length of a Fortran record, before and behind it; always 32 bits.
    void record_mark(std::int64_t bytes) { put(static_cast<std::int32_t>(bytes)); }

    /// \throws FileError
    void commit() { file_.commit(); }

private:
    template <class T>
    void put(T value) {
        const T stored = swapped_ ? byte_swap(value) : value;
        std::memcpy(file_.room(sizeof(T)), &stored, sizeof(T));
        file_.used(sizeof(T));
    }

    AtomicFile file_;
    NumberLayout layout_;
    bool swapped_;
};

} // namespace ameco
