// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Numbers in the bytes of a file, in either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace ameco {

template <class T>
[[nodiscard]] T load(const char* at) {
    T value;
    std::memcpy(&value, at, sizeof(T));
    return value;
}

template <class T>
[[nodiscard]] T byte_swap(T value) {
    auto bytes = std::bit_cast<std::array<unsigned char, sizeof(T)>>(value);
    std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
}

template <class Int>
[[nodiscard]] Int load_integer(const char* at, bool swapped) {
    const Int value = load<Int>(at);
    return swapped ? byte_swap(value) : value;
}

template <class Real>
[[nodiscard]] double load_real(const char* at, bool swapped) {
    // Swapped as an integer: a signalling NaN on its way through a register might change.
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    const Bits bits = load<Bits>(at);
    return static_cast<double>(std::bit_cast<Real>(swapped ? byte_swap(bits) : bits));
}

/// Numbers of the widths that a file announces, one behind the other.
class NumberCursor {
public:
    /// \param int_bytes, real_bytes  4 or 8
    NumberCursor(const char* at, bool swapped, int int_bytes, int real_bytes)
        : at_(at), swapped_(swapped), int_bytes_(int_bytes), real_bytes_(real_bytes) {}

    std::int64_t integer() {
        const std::int64_t value = int_bytes_ == 8 ? load_integer<std::int64_t>(at_, swapped_)
                                                   : load_integer<std::int32_t>(at_, swapped_);
        at_ += int_bytes_;
        return value;
    }
    double real() {
        const double value =
            real_bytes_ == 8 ? load_real<double>(at_, swapped_) : load_real<float>(at_, swapped_);
        at_ += real_bytes_;
        return value;
    }
    void skip(std::int64_t bytes) { at_ += bytes; }
    [[nodiscard]] const char* here() const { return at_; }

private:
    const char* at_;
    bool swapped_;
    int int_bytes_;
    int real_bytes_;
};

} // namespace ameco
