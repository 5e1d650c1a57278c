// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/content_hash.h"

#include "core/base/error.h"

#include <charconv>
#include <fstream>
#include <string_view>
#include <vector>

namespace ameco {
namespace {

constexpr std::string_view prefix = "fnv1a64:";

} // namespace

std::uint64_t content_hash(std::span<const std::byte> bytes, std::uint64_t seed) {
    constexpr std::uint64_t prime = 0x100000001b3u;
    std::uint64_t hash = seed;
    for (const std::byte b : bytes) {
        hash = (hash ^ static_cast<std::uint64_t>(b)) * prime;
    }
    return hash;
}

std::uint64_t content_hash_of_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw FileError(path.string() + ": cannot be opened: does it exist, may you read it?");
    }
    std::vector<char> buffer(std::size_t{1} << 20);
    std::uint64_t hash = content_hash({});
    while (file) {
        file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        hash = content_hash(
            std::as_bytes(std::span(buffer.data(), static_cast<std::size_t>(file.gcount()))), hash);
    }
    if (file.bad()) {
        throw FileError(path.string() + ": reading failed");
    }
    return hash;
}

std::string hash_text(std::uint64_t hash) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text(prefix);
    for (int shift = 60; shift >= 0; shift -= 4) {
        text += digits[(hash >> shift) & 15u];
    }
    return text;
}

std::uint64_t parse_hash(const std::string& text) {
    std::uint64_t hash = 0;
    const char* const end = text.data() + text.size();
    if (text.size() == prefix.size() + 16 && text.starts_with(prefix)) {
        const auto [stop, failure] = std::from_chars(text.data() + prefix.size(), end, hash, 16);
        if (failure == std::errc() && stop == end) {
            return hash;
        }
    }
    throw InputError("\"" + text + "\" is not a content hash (fnv1a64: and 16 hexadecimal digits)");
}

} // namespace ameco
