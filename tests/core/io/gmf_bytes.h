// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Medit binary files put together by hand, good and bad ones, without help from the code under
/// test.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace ameco::test {

class GmfBytes {
public:
    explicit GmfBytes(int version, bool swapped = false) : version_(version), swapped_(swapped) {
        int32(1);
        int32(version);
    }

    /// A file with its Dimension.
    static GmfBytes of(int version, int dimension, bool swapped = false) {
        GmfBytes bytes(version, swapped);
        return bytes.begin(3).int32(dimension).end();
    }

    GmfBytes& int32(std::int32_t value) { return append(value); }
    GmfBytes& int64(std::int64_t value) { return append(value); }
    /// In the version's width.
    GmfBytes& integer(std::int64_t value) {
        return version_ == 4 ? int64(value) : int32(static_cast<std::int32_t>(value));
    }
    GmfBytes& integers(std::initializer_list<std::int64_t> values) {
        for (const std::int64_t value : values) {
            integer(value);
        }
        return *this;
    }
    GmfBytes& real(double value) {
        return version_ == 1 ? append(static_cast<float>(value)) : append(value);
    }
    GmfBytes& position(std::int64_t value) {
        return version_ >= 3 ? int64(value) : int32(static_cast<std::int32_t>(value));
    }
    GmfBytes& text(const std::string& value, std::size_t width) {
        std::string padded = value;
        padded.resize(width, '\0');
        bytes_ += padded;
        return *this;
    }

    GmfBytes& begin(int keyword) {
        int32(keyword);
        patch_ = bytes_.size();
        return position(0);
    }
    /// Ends the record of the last `begin`: its position of the next record becomes known.
    GmfBytes& end() {
        const std::string behind = bytes_.substr(patch_ + (version_ >= 3 ? 8U : 4U));
        bytes_.resize(patch_);
        const std::size_t header = version_ >= 3 ? 8 : 4;
        position(static_cast<std::int64_t>(patch_ + header + behind.size()));
        bytes_ += behind;
        return *this;
    }

    /// The file so far, without an End.
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    /// The whole file.
    [[nodiscard]] std::string finish() const {
        GmfBytes copy = *this;
        copy.int32(54).position(0);
        return copy.bytes_;
    }

private:
    template <class T>
    GmfBytes& append(T value) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        if (swapped_) {
            std::reverse(raw, raw + sizeof(T));
        }
        bytes_.append(raw, sizeof(T));
        return *this;
    }

    int version_;
    bool swapped_;
    std::size_t patch_ = 0;
    std::string bytes_;
};

/// The unit tetrahedron, one face with patch 7, one edge with label 5.
inline GmfBytes tetrahedron(int version, bool swapped = false) {
    GmfBytes b = GmfBytes::of(version, 3, swapped);
    b.begin(4).integer(4);
    for (int i = 0; i < 4; ++i) {
        b.real(i == 1 ? 1 : 0).real(i == 2 ? 1 : 0).real(i == 3 ? 1 : 0).integer(i == 0 ? 9 : 0);
    }
    b.end();
    b.begin(5).integer(1).integers({1, 2, 5}).end();
    b.begin(6).integer(1).integers({1, 3, 2, 7}).end();
    b.begin(8).integer(1).integers({1, 2, 3, 4, 2}).end();
    return b;
}

/// The triangle (0,0) (1,0) (0,1), one edge with patch 7.
inline GmfBytes triangle(int version, bool swapped = false) {
    GmfBytes b = GmfBytes::of(version, 2, swapped);
    b.begin(4).integer(3);
    for (int i = 0; i < 3; ++i) {
        b.real(i == 1 ? 1 : 0).real(i == 2 ? 1 : 0).integer(0);
    }
    b.end();
    b.begin(5).integer(1).integers({1, 2, 7}).end();
    b.begin(6).integer(1).integers({1, 2, 3, 2}).end();
    return b;
}

} // namespace ameco::test
