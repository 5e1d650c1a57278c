// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Random numbers that depend on nothing but their arguments: the same on every machine, in any
/// order of evaluation, on any number of threads.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace ameco {

/// Mixes a few integers into one whose bits look independent of theirs (the finaliser of
/// SplitMix64, Steele et al. 2014, once per argument).
[[nodiscard]] constexpr std::uint64_t mix(std::initializer_list<std::uint64_t> values) {
    std::uint64_t h = 0;
    for (const std::uint64_t v : values) {
        h += v + 0x9e3779b97f4a7c15u;
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
        h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
        h ^= h >> 31;
    }
    return h;
}

/// A number in [-1, 1) made from a few integers.
[[nodiscard]] constexpr double random_signed(std::initializer_list<std::uint64_t> values) {
    return static_cast<double>(mix(values) >> 11) * 0x1p-52 - 1;
}

} // namespace ameco
