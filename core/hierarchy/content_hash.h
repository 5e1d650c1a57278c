// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A fingerprint of a file's bytes, to notice that a file is another one than it was.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace ameco {

/// XXH3, 64 bits, as `xxhsum -H3` prints it. Finds accidents, not forgeries.
[[nodiscard]] std::uint64_t content_hash(std::span<const std::byte> bytes);

/// The hash of a whole file.
/// \throws FileError when it cannot be read
[[nodiscard]] std::uint64_t content_hash_of_file(const std::filesystem::path& path);

/// "xxh3:" and 16 hexadecimal digits.
[[nodiscard]] std::string hash_text(std::uint64_t hash);

/// The opposite. \throws InputError when the text is not such a hash
[[nodiscard]] std::uint64_t parse_hash(const std::string& text);

} // namespace ameco
