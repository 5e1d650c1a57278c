// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Files with random damage, the same in every run.
#pragma once

#include "tests/core/io/io_support.h"

namespace ameco::test {

/// Random damage of the kinds that happen to files, and of the kinds that hurt readers.
inline std::string damaged(std::string bytes, Random& random, bool text) {
    constexpr std::int64_t values[] = {
        0,  1,   -1,  2,          54,        0x7fffffff, -0x80000000LL,
        64, 255, 199, 0x10000000, 0x1000000, 1LL << 40,  -(1LL << 62)};
    const char* const tokens[] = {"0",        "-1",          "nan",  "1e999",   "99999999999",
                                  "Vertices", "End",         "\n",   "#",       "+",
                                  "2e",       "Triangles 9", "-0.0", "Prisms 1"};
    for (int i = 1 + random.below(4); i > 0 && !bytes.empty(); --i) {
        const auto at = static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())));
        const auto length = std::min<std::size_t>(bytes.size() - at,
                                                  1 + static_cast<std::size_t>(random.below(16)));
        switch (random.below(7)) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
            break;
        case 1:
            bytes[at] = static_cast<char>(random.below(256));
            break;
        case 2:
            bytes.resize(at);
            break;
        case 3:
            bytes.erase(at, length);
            break;
        case 4:
            bytes.insert(at, bytes.substr(at, length));
            break;
        default:
            if (text) {
                bytes.replace(at, length, tokens[random.below(std::size(tokens))]);
            } else {
                const std::int64_t value = values[random.below(std::size(values))];
                const std::size_t width = random.below(2) ? 4 : 8;
                const std::size_t begin = at / 4 * 4;
                std::memcpy(bytes.data() + begin, &value, std::min(width, bytes.size() - begin));
            }
        }
    }
    return bytes;
}

} // namespace ameco::test
