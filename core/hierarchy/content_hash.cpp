// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/hierarchy/content_hash.h"

#include "core/base/error.h"

// All in the header, as its makers offer: no library to link with.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <charconv>
#include <fstream>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

namespace ameco {
namespace {

constexpr std::string_view prefix = "xxh3:";

struct FreeState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

} // namespace

std::uint64_t content_hash(std::span<const std::byte> bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

std::uint64_t content_hash_of_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw FileError(path.string() + ": cannot be opened: does it exist, may you read it?");
    }
    const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
    if (!state) {
        throw std::bad_alloc();
    }
    XXH3_64bits_reset(state.get());
    std::vector<char> buffer(std::size_t{1} << 20);
    while (file) {
        file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        XXH3_64bits_update(state.get(), buffer.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) {
        throw FileError(path.string() + ": reading failed");
    }
    return XXH3_64bits_digest(state.get());
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
    throw InputError("\"" + text + "\" is not a content hash (xxh3: and 16 hexadecimal digits)");
}

} // namespace ameco
