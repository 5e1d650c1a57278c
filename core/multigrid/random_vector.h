// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Random vectors that are the same on every machine.
#pragma once

#include "core/multigrid/sparse.h"

#include <cstdint>

namespace ameco {

/// n numbers in [-1, 1) (Knuth's linear congruential generator, its upper 53 bits).
[[nodiscard]] inline Vector random_vector(Eigen::Index n, std::uint64_t seed = 1) {
    Vector r(n);
    std::uint64_t state = seed;
    for (double& x : r) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        x = static_cast<double>(state >> 11) * 0x1p-52 - 1;
    }
    return r;
}

} // namespace ameco
